#!/usr/bin/env python3
"""What tests/integration/closed_loop promises of the hash."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from types import ModuleType
from typing import Any
from unittest import mock

import fakes


def load() -> ModuleType:
    sys.path.insert(0, str(fakes.ROOT / "tests/integration"))
    with mock.patch.object(sys, "argv", ["closed_loop", "isotouchd", "falcon-sim", "replay_plain", "field"]):
        return fakes.load("../tests/integration/closed_loop")


class FakeRig:
    """Both runs leave the same recording, and its replay has this hash."""

    folder = Path(".")

    def __init__(self, answer: str) -> None:
        self.answer = answer

    def start_falcon(self, *_: str) -> None: ...

    def end_falcon(self, _: Any) -> None: ...

    def run(self, *command: Any) -> subprocess.CompletedProcess[str]:
        Path(command[-1]).write_text("a recording")
        return subprocess.CompletedProcess([], 0, "state: active\n", "")

    def done(self, *_: Any) -> str:
        return json.dumps({"ticks": 4000, "hash": self.answer, "seconds": 1})


class ClosedLoopTest(unittest.TestCase):
    def test_another_hash_than_that_of_every_machine_fails(self) -> None:
        script, before = load(), os.getcwd()
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            try:
                self.assertEqual(script.two_runs_in_lockstep(FakeRig(script.HASH))["hash"], script.HASH)
                with self.assertRaisesRegex(script.Failure, f"hash 0123456789abcdef instead of {script.HASH}"):
                    script.two_runs_in_lockstep(FakeRig("0123456789abcdef"))
            finally:
                os.chdir(before)


if __name__ == "__main__":
    unittest.main()
