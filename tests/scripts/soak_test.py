#!/usr/bin/env python3
"""What hil/soak promises."""

import contextlib
import io
import json
import subprocess
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import fakes
from lib import desk as desks


def soak(*arguments: str, **environment: str) -> tuple[int, str]:
    return fakes.run("soak", "BIN", "a.itf", "b.itf", *(arguments or ("1", "2")), **environment)


class SoakTest(unittest.TestCase):
    def test_a_good_run_prints_its_figures_and_leaves_nothing_behind(self) -> None:
        code, said = soak()
        self.assertEqual(code, 0, said)
        self.assertIn("followed      10000 of 10000 a second, with 0 gaps", said)
        self.assertIn("felt          10000 ticks; resumed 0 times", said)
        self.assertRegex(said, r"recordings +[1-9]\d* whole ones of 200 ms, 0 that another field ended; [1-9]\d* ticks replayed to the bit")
        self.assertIn("      1 futex FUTEX_WAKE_PRIVATE", said)
        self.assertTrue(said.endswith("\n1 passed, 0 failed, 0 skipped\n"), said)
        self.assertNotIn("LEFT BEHIND", said)

    def test_a_child_that_fails_fails_the_script(self) -> None:
        for child in ("falcon-sim", "isotouchd", "upload", "status", "latency", "watch", "record", "replay"):
            with self.subTest(child):
                code, said = soak(FAKE_FAILS=child)
                self.assertEqual(code, 1, said)
                self.assertIn("; the controller said:", said)
                self.assertIn("did not start" if child in ("falcon-sim", "isotouchd") else "it is meant to fail", said)   # for this reason, and no later one
                self.assertNotIn("LEFT BEHIND", said)

    def test_a_command_that_hangs_fails_the_script(self) -> None:
        with tempfile.TemporaryDirectory() as folder, mock.patch.object(desks, "ASK_SECONDS", 0.2), contextlib.redirect_stderr(io.StringIO()) as said:
            Path(folder, "isotouch").write_text("#!/bin/sh\nexec sleep 30\n")
            Path(folder, "isotouch").chmod(0o755)
            self.assertEqual(desks.at_desk("soak", folder, lambda desk: print(desk.status())), 1)
        self.assertIn("timed out after 0.2 seconds", said.getvalue())

    def test_a_program_that_crashes_at_its_end_fails_the_script(self) -> None:
        for program in ("falcon-sim", "isotouchd"):
            code, said = soak(FAKE_CRASHES=program)
            self.assertEqual(code, 1, said)
            self.assertRegex(said, f"{program}.* ended with -11 after SIGTERM")
            self.assertNotIn("LEFT BEHIND", said)

    def test_what_the_tick_must_not_do_fails_the_script(self) -> None:
        for what, environment in (("allocated", {"FAKE_STATUS": '{"allocations": 1}'}), ("page faults", {"FAKE_STATUS": '{"page_faults": 1}'}),
                                  ("ticks did not reach", {"FAKE_GAP": "1"}),
                                  ("no tick was felt", {"FAKE_TICKS": "hold"}), ("does not name: write 3", {"FAKE_CALLS": fakes.CALLS + "write(3, 0) = 1\n"}),
                                  ("neither waited nor woke", {"FAKE_CALLS": "getrusage(RUSAGE_THREAD, 0) = 0\n"})):
            with self.subTest(what):
                code, said = soak(**environment)
                self.assertEqual(code, 1, said)
                self.assertIn(what, said)

    def test_a_machine_that_hides_the_system_calls_fails_the_script_unless_told_before(self) -> None:
        for environment in ({"FAKE_FAILS": "strace"}, {"FAKE_CALLS": ""}):
            code, said = soak(**environment)
            self.assertEqual(code, 1, said)
            self.assertIn("strace may not look at threads here (", said)
            code, said = soak(**environment, SOAK_WITHOUT_CALLS="1")
            self.assertEqual(code, 0, said)
            self.assertTrue(said.endswith("\n1 passed, 0 failed, 1 skipped\n"), said)

    def test_a_number_that_is_none_is_wrong_usage(self) -> None:
        for arguments in (("0",), ("1", "x"), ("1", "2", "3"), ("1234567",)):
            self.assertEqual(soak(*arguments)[0], 2)

    def test_late_ticks_of_a_busy_machine_are_resumed_and_no_other_fault(self) -> None:
        desk = fakes.load("soak").Desk("BIN")
        for simulated, fault, resumed in ((True, "late", 1), (True, "stopped", 1), (True, "silent", 0), (True, "penetration", 0), (False, "late", 0)):
            with self.subTest(fault, simulated=simulated), desk:
                desk.simulated, desk.resumed = simulated, 0
                desk.status = lambda: {"state": "fault", "faults": [fault]}
                desk.ask = lambda *_, **__: subprocess.CompletedProcess([], 0)
                self.assertFalse(desk.is_felt())
                self.assertEqual(desk.resumed, resumed)

    def test_before_homing_a_silent_simulated_device_is_resumed(self) -> None:
        desk = fakes.load("soak").Desk("BIN")
        for simulated, fault, resumed in ((True, "silent", 1), (True, "late", 1), (True, "penetration", 0), (False, "silent", 0)):
            with self.subTest(fault, simulated=simulated), desk:
                desk.simulated, desk.resumed = simulated, 0
                desk.ask = lambda *_, **__: subprocess.CompletedProcess([], 0, json.dumps({"state": "fault", "faults": [fault]}))
                self.assertFalse(desk.is_homed())
                self.assertEqual(desk.resumed, resumed)

    def test_gaps_are_counted_between_ticks_alone(self) -> None:
        count = fakes.load("soak").count_ticks
        self.assertEqual(count(["tick,state\n"]), (0, 0, 0))
        self.assertEqual(count(["tick,state\n", "7,hold\n", "8,active\n", "10,active\n"]), (3, 1, 2))

    def test_the_calls_at_both_ends_of_strace_are_not_counted(self) -> None:
        calls = fakes.load("soak").calls_in
        trace = ["restart_syscall(<... resuming interrupted futex ...>) = 0", "futex_time64(0x1, FUTEX_WAKE_PRIVATE, 1) = 0", "read(3 <unfinished ...>"]
        self.assertEqual(calls(trace), {"futex FUTEX_WAKE_PRIVATE": 1})


if __name__ == "__main__":
    unittest.main()
