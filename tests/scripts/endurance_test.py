#!/usr/bin/env python3
"""What hil/endurance promises: each of the people round a controller notices what only they can notice."""

from __future__ import annotations

import random
import subprocess
import tempfile
import unittest
from pathlib import Path
from typing import Any

import fakes

endurance = fakes.load("endurance")
Answer = subprocess.CompletedProcess


class FakeDesk:
    """A controller with the field a.itf, whose hash is 'a'."""

    def __init__(self, folder: Path) -> None:
        self.bin, self.room, self.control = folder, folder, f"unix:{folder}/control"
        (folder / "isotouch").symlink_to("/bin/true")   # what is watched
        self.now: dict[str, Any] = {"state": "active", "faults": [], "field_hash": "a", "sentence": "felt"}
        self.answer = Answer([], 0, "", "")

    def tell(self, what: str, *command: object) -> str:
        return f'{{"hash": "{command[1][0]}"}}' if command[0] == "info" else what   # type: ignore[index]

    def ask(self, *_: object) -> Answer[str]:
        return self.answer

    def status(self) -> dict[str, Any]:
        return self.now


class EnduranceTest(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.desk = FakeDesk(Path(folder.name))
        self.it = endurance.Endurance(self.desk, ["a.itf"], 1)
        self.chance = random.Random(1)

    def fails(self, act: str, reason: str) -> None:
        with self.assertRaises(endurance.Failure) as failure:
            getattr(self.it, act)(self.chance)
        self.assertIn(reason, str(failure.exception))

    def test_the_device_takes_every_kind_of_fault_that_is_ordered(self) -> None:
        orders = endurance.faults_for(5_000_000, self.chance).splitlines()
        self.assertEqual({order.split()[2] for order in orders}, {name for name, _ in endurance.FAULTS})
        packets = [int(order.split()[1]) for order in orders]
        self.assertEqual(packets, sorted(set(packets)))
        self.assertEqual(endurance.faults_for(1000, random.Random(4)), endurance.faults_for(1000, random.Random(4)))

    def test_the_device_must_have_had_what_was_ordered(self) -> None:
        orders = "at 5 short\nat 9 late 3\nat 12 merged\n"
        end = "falcon-sim: 10 packets, torque until the 7th\n"
        self.assertEqual(endurance.met_by("falcon-sim: ready\nfalcon-sim: at 5 short\nfalcon-sim: at 9 late 3\n" + end, orders), {"short": 1, "late": 1})
        for had in ("", "falcon-sim: at 5 short\n", "falcon-sim: at 5 short\nfalcon-sim: at 9 late 4\n"):
            with self.assertRaisesRegex(endurance.Failure, f"2 faults were ordered until packet 10, and the simulated Falcon had {had.count(': at ')}"):
                endurance.met_by(had + end, orders)
        with self.assertRaisesRegex(endurance.Failure, "how many packets"):
            endurance.met_by("", orders)

    def test_an_acknowledged_field_that_is_not_active_is_noticed(self) -> None:
        self.assertEqual(self.it.upload(self.chance), "upload: done")
        self.desk.now["field_hash"] = "b"
        self.fails("upload", "the field a was acknowledged, and b is active")

    def test_a_refusal_is_one_sentence(self) -> None:
        self.desk.answer = Answer([], 1, "", "isotouch: no place is left; try again\n")
        self.assertEqual(self.it.upload(self.chance), "upload: refused")
        for code, said in ((1, ""), (1, "Traceback\n"), (1, "isotouch: a\nb\nc\n"), (139, "isotouch: a\n")):
            self.desk.answer = Answer([], code, "", said)
            for act in ("upload", "ask", "set"):
                self.fails(act, f"ended with {code}")

    def test_a_stop_is_never_refused_but_may_be_taken_back(self) -> None:
        self.assertEqual(self.it.stop(self.chance), "stop: done")
        self.desk.answer = Answer([], 1, "", "isotouch: the stop was taken back at once, by a button\n")
        self.assertEqual(self.it.stop(self.chance), "stop: taken back")
        self.desk.answer = Answer([], 1, "", "isotouch: no place is left; try again\n")
        self.fails("stop", "a stop was refused")

    def test_a_setting_that_nobody_may_choose_is_refused(self) -> None:
        with self.assertRaises(endurance.Failure):
            for _ in range(20):
                self.it.set(self.chance)

    def test_force_that_does_not_come_back_is_noticed(self) -> None:
        self.desk.now |= {"state": "fault", "faults": ["silent"], "sentence": "fault: no answer"}
        self.assertEqual(self.it.hand(self.chance), "resume: done")
        self.desk.now["faults"] = ["silent", "stopped"]
        self.it.hand(self.chance)
        self.assertEqual(self.it.faults, {"silent": 1}, "a stop is no fault of the device")
        self.it.touched -= endurance.LONGEST_WITHOUT_TOUCH + 1
        self.fails("hand", "the state is fault, with silent")

    def test_one_who_finds_something_wrong_ends_it_for_all(self) -> None:
        self.desk.now["field_hash"] = "b"
        with self.assertRaises(endurance.Failure):
            self.it.live(60)

    def test_a_recording_that_does_not_replay_is_noticed(self) -> None:
        trace = self.desk.room / "r.trace"
        for said, good in (("ticks        70\n", True), ("", False)):
            trace.write_text("")
            self.desk.answer = Answer([], 0, said, "")
            if good:
                self.assertEqual(self.it.record(self.chance), "record: done")
                self.assertEqual((self.it.replayed, trace.exists()), (70, False))
            else:
                self.fails("record", "does not replay")

    def test_a_tool_that_fails_fails_the_script(self) -> None:
        code, said = fakes.run("endurance", "BIN", "a.itf", "b.itf", FAKE_FAILS="info")
        self.assertEqual(code, 1, said)
        self.assertIn("endurance: isotouch info", said)
        self.assertNotIn("LEFT BEHIND", said)

    def test_a_number_that_is_none_is_wrong_usage(self) -> None:
        for arguments in (("0",), ("1", "x"), ("1", "2", "3"), ("1000000001",)):
            self.assertEqual(fakes.run("endurance", "BIN", "a.itf", "b.itf", *arguments)[0], 2)


if __name__ == "__main__":
    unittest.main()
