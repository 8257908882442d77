"""What one scenario of a rung says of itself: one JSON object in one line. hil/run reads it."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass
from typing import Any


@dataclass
class Outcome:
    """None where there is no such figure."""

    rung: int
    scenario: str
    seed: int
    exit: int
    ticks: int | None = None
    missed: int | None = None
    trace_hash: str | None = None
    log_hash: str | None = None
    ticks_to_zero: int | None = None
    skipped: int = 0
    seconds: int | None = None
    equal: bool | None = None   # of two runs, to the last byte

    def line(self) -> str:
        return json.dumps(asdict(self))


def exit_code(returncode: int) -> int:
    """As a shell has it: 128 and the signal's number for a program that a signal ended."""
    return returncode if returncode >= 0 else 128 - returncode


def objects_in(log: str) -> list[dict[str, Any]]:
    """The JSON objects that end a line."""
    objects = []
    for line in log.splitlines():
        try:
            found = json.loads(line[line.index("{"):])
        except ValueError:
            continue
        objects.append(found)
    return objects
