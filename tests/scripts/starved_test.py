#!/usr/bin/env python3
"""What hil/starved promises before it starves anybody."""

from __future__ import annotations

import itertools
import random
import subprocess
import unittest
from collections.abc import Iterator
from pathlib import Path

import fakes

starved = fakes.load("starved")
REFUSED = "isotouch: the controller has no memory for it; try again"


class Shortage(starved.Starved):   # type: ignore[misc, name-defined]
    """A controller that waits, and a tool that answers with these exit codes and sentences."""

    def __init__(self, desk: starved.Desk, answers: Iterator[tuple[int, str]]) -> None:   # type: ignore[name-defined]
        self.desk, self.fields, self.hash_of, self.answers = desk, ["a", "b"], {"a": "1", "b": "2"}, answers
        sleeper = subprocess.Popen("cat", stdin=subprocess.PIPE, stdout=subprocess.PIPE, bufsize=0)
        assert sleeper.stdin and sleeper.stdout
        sleeper.stdin.write(b"begun")   # it needs no more memory then
        sleeper.stdout.read(5)
        desk.started.append(sleeper)
        desk.ask, desk.tell = self.ask, lambda *_: ""

    def ask(self, *command: str | Path, timeout: float = 0) -> subprocess.CompletedProcess[str]:
        code, said = next(self.answers)
        if said == "ends":
            self.desk.started[-1].kill()
        return subprocess.CompletedProcess(command, code, "", said and said + "\n")

    def learn(self, field: str) -> None:
        self.hash_of[field] = field

    def works(self, after: str) -> str:
        return "1"


class Steady:
    """A controller whose ticks go on, with the field of the hash 1 whatever is uploaded."""
    control = "unix:control"
    ticks = 0

    def ask(self, *command: str | Path) -> subprocess.CompletedProcess[str]:
        return subprocess.CompletedProcess(command, 0, "", "")

    def status(self) -> dict[str, int | str]:
        self.ticks += 1
        return {"ticks": self.ticks, "field_hash": "1"}


class StarvedTest(unittest.TestCase):
    def test_a_number_that_is_none_is_wrong_usage(self) -> None:
        for arguments in (("0",), ("1", "x"), ("1", "2", "3"), ("1234567",)):
            self.assertEqual(fakes.run("starved", "BIN", "a.itf", "b.itf", *arguments)[0], 2)

    def test_a_tool_that_fails_fails_the_script_and_leaves_no_disk_mounted(self) -> None:
        code, said = fakes.run("starved", "BIN", "a.itf", "b.itf", FAKE_FAILS="info")
        self.assertEqual(code, 1, said)
        self.assertIn("starved: isotouch info", said)
        self.assertNotIn("LEFT BEHIND", said)

    def test_an_acknowledged_field_that_is_not_active_is_noticed(self) -> None:
        it = starved.Starved.__new__(starved.Starved)
        it.desk, it.fields, it.hash_of, it.chance = Steady(), ["a"], {"a": "1"}, random.Random(1)
        self.assertEqual(it.works("at rest"), "1")
        it.hash_of["a"] = "2"
        with self.assertRaisesRegex(starved.Failure, "at rest: the field 2 was acknowledged, and 1 is active"):
            it.works("at rest")

    def short_of_memory(self, *answers: tuple[int, str]) -> str:
        """What the part about memory says of a controller whose requests are answered so, in turn and from the beginning."""
        with starved.Desk("") as desk:
            it = Shortage(desk, itertools.cycle(answers))
            try:
                return str(starved.out_of_memory(it))
            finally:
                desk.started[-1].kill()
                desk.started.pop().communicate()

    def test_memory_that_never_runs_short_fails(self) -> None:
        with self.assertRaisesRegex(starved.Failure, "memory never ran short"):
            self.short_of_memory((0, ""))
        self.assertEqual(self.short_of_memory(*[(0, "")] * 21, (1, REFUSED)), "1 refused; it went on, and a stop was possible")

    def test_without_memory_every_refusal_says_what_to_do(self) -> None:
        for answers in (((1, "no"),), ((0, ""), (0, ""), (1, "no")), ((1, f"{REFUSED}\nmore\nstill more"),), ((9, REFUSED),)):
            with self.assertRaisesRegex(starved.Failure, "without memory: isotouch"):
                self.short_of_memory(*answers)
        self.assertIn("27 refused; it went on", self.short_of_memory((1, REFUSED)))

    def test_a_controller_that_ends_without_memory_may_say_nothing_but_must_end_by_its_own_decision(self) -> None:
        with self.assertRaisesRegex(starved.Failure, "ended with -9, and not by its own decision"):
            self.short_of_memory((0, ""), (1, "ends"))


if __name__ == "__main__":
    unittest.main()
