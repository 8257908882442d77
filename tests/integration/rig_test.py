#!/usr/bin/env python3
"""What rig.py promises to the scripts that use it."""

import contextlib
import io
import os
import signal
import subprocess
import sys
import time
import unittest
from collections.abc import Callable
from pathlib import Path
from unittest import mock

import rig as rigs
from rig import Controller, Rig, thread_of

HANGS = """
import sys, time
from pathlib import Path
sys.path.insert(0, sys.argv[1])
import rig as rigs

def hangs_here(rig):
    Path("daemon.log").write_text("its last words\\n")
    print("ready", flush=True)
    time.sleep(300)

rigs.LONG_SECONDS = int(sys.argv[2])
sys.exit(rigs.main("script", hangs_here))
"""


class IntegrationRigTest(unittest.TestCase):
    def run_work(self, work: Callable[[Rig], None]) -> tuple[int, str]:
        before = os.getcwd()
        self.addCleanup(os.chdir, before)
        self.addCleanup(signal.alarm, 0)
        for number in (signal.SIGTERM, signal.SIGALRM):
            self.addCleanup(signal.signal, number, signal.getsignal(number))
        with contextlib.redirect_stderr(io.StringIO()) as said:
            code = rigs.main("script", work)
        return code, said.getvalue()

    def hanging(self, long_seconds: int) -> subprocess.Popen[str]:
        process = subprocess.Popen([sys.executable, "-c", HANGS, str(Path(rigs.__file__).parent), str(long_seconds)], stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.__exit__, None, None, None)
        self.addCleanup(process.kill)
        assert process.stdout
        self.assertEqual(process.stdout.readline(), "ready\n")
        return process

    def test_a_script_that_is_ended_shows_where_it_was_and_the_logs(self) -> None:
        process = self.hanging(300)
        process.terminate()
        _, said = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 1, said)
        for words in ("script: Failure: it was ended by SIGTERM\n", "in hangs_here\n", "==> daemon.log\nits last words\n"):
            self.assertIn(words, said)

    def test_a_script_that_takes_long_shows_where_it_is_and_goes_on(self) -> None:
        process = self.hanging(300)
        process.send_signal(signal.SIGALRM)   # as if that time had passed
        assert process.stderr
        said = ""
        while not said.endswith("its last words\n"):
            line = process.stderr.readline()
            self.assertTrue(line, said)
            said += line
        self.assertIn("script: still at work after 300 s\n", said)
        self.assertIn("in hangs_here\n", said)
        self.assertIsNone(process.poll())

    def test_every_failure_shows_its_place_and_the_logs(self) -> None:
        def adds_nothing(rig: Rig) -> None:
            (rig.folder / "daemon.log").write_text("its last words\n")
            nothing: int = None  # type: ignore[assignment]
            nothing += 1
        code, said = self.run_work(adds_nothing)
        self.assertEqual(code, 1)
        self.assertRegex(said, r"^script: TypeError: (?s:.*)in adds_nothing\n(?s:.*)==> daemon.log\nits last words\n$")

    def test_a_command_that_hangs_fails(self) -> None:
        with mock.patch.object(rigs, "COMMAND_SECONDS", 1):
            code, said = self.run_work(lambda rig: print(rig.run("sleep", "300")))
        self.assertEqual(code, 1)
        self.assertIn("TimeoutExpired", said)

    def test_a_controller_that_has_ended_is_not_waited_for(self) -> None:
        began = time.monotonic()
        code, said = self.run_work(lambda rig: Controller(rig, "false").start())
        self.assertLess(time.monotonic() - began, rigs.PATIENCE / 2)
        self.assertEqual(code, 1)
        self.assertIn("the controller does not listen; its exit code is 1\n", said)

    def test_what_was_not_reached_is_named_as_it_was_last_seen(self) -> None:
        asked = []

        def status() -> dict[str, str]:
            asked.append(1)
            return {"state": "boot"}

        def waits(rig: Rig) -> None:
            controller = Controller(rig, "true")
            with mock.patch.object(controller, "status", status), mock.patch.object(rigs, "PATIENCE", 0):
                controller.wait_for("state", "active")
        code, said = self.run_work(waits)
        self.assertEqual((code, len(asked)), (1, 1))
        self.assertIn("state is not active but boot\n", said)

    def test_a_thread_that_ends_while_others_are_looked_at_is_left_out(self) -> None:
        threads = Path("/proc/self/task")
        own = threads / str(os.getpid()) / "comm"
        with mock.patch.object(Path, "glob", lambda *_: [threads / "0" / "comm", own]):
            self.assertEqual(thread_of(os.getpid(), own.read_text().removesuffix("\n")), os.getpid())


if __name__ == "__main__":
    unittest.main()
