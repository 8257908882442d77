"""Limits of instructions hold for the compiler that they were counted with; what another one built may take half as many again."""

from __future__ import annotations

import subprocess


def other_compiler(preset: str) -> str:
    """A sentence where another compiler built this preset; else empty."""
    done = subprocess.run(["hil/instructions/same_compiler", preset], stdout=subprocess.PIPE, text=True, check=False)
    if done.returncode > 1:
        raise SystemExit(done.returncode)   # it has said why
    return "" if done.returncode == 0 else done.stdout.strip() or f"{preset} was built with another compiler"


def most_allowed(limit: int, other: str) -> int:
    """other: as above"""
    return limit * 3 // 2 if other else limit
