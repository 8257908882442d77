#!/usr/bin/env python3
"""What .ci/run promises of a step that hangs, with a ./dev and a `timeout` that are made here."""

from __future__ import annotations

import os
import shutil
import unittest

import fakes

# Logs its limit and its words. FAKE_HANGS is the word that never ends; all others end at once.
TIMEOUT = """echo "$*" >>limits
shift 3
case "$*" in "$FAKE_HANGS") echo begun; exit 124 ;; esac
exec "$@"
"""


class CiTest(fakes.Tree):
    def setUp(self) -> None:
        super().setUp()
        (self.root / ".ci").mkdir()
        shutil.copy(fakes.ROOT / ".ci/run", self.root / ".ci/run")
        self.script("dev", 'case "$*" in "$FAKE_FAILS") exit 1 ;; "$FAKE_STOPS") exit 124 ;; esac\n')
        self.script("bin/timeout", TIMEOUT)
        for program in ("chrt", "arm-none-eabi-g++"):
            self.script(f"bin/{program}", "exit 0\n")

    def ci(self, since: int = 0, **environment: str) -> tuple[int, str]:
        """Exit code and the lines after the steps; CI has run for so many seconds before."""
        code, said, _ = self.call(".ci/run", PATH=f"{self.root}/bin:{os.environ['PATH']}", SECONDS=str(since), ISOTOUCH_DATA="none", **environment)
        return code, said

    def test_steps_that_end_are_counted(self) -> None:
        code, said = self.ci()
        self.assertEqual((code, said.splitlines()[-1]), (0, "20 passed, 0 failed, 0 skipped"))
        limits = [int(line.split()[2]) for line in (self.root / "limits").read_text().splitlines()]
        self.assertEqual(len(limits), 14)
        self.assertTrue(all(300 <= limit <= 3600 for limit in limits), limits)

    def test_what_hangs_until_its_ceiling_has_failed(self) -> None:
        for hangs in ("./dev races 20000", "./dev test sanitize", "./dev wakeups 1 3"):
            code, said = self.ci(FAKE_HANGS=hangs)
            self.assertEqual((code, said.splitlines()[-1]), (1, "19 passed, 1 failed, 0 skipped"), hangs)

    def test_what_had_less_time_than_its_ceiling_is_left_out(self) -> None:
        code, said = self.ci(4800 - 350, FAKE_HANGS="./dev races 20000")
        self.assertEqual((code, said.splitlines()[-1]), (0, "19 passed, 0 failed, 1 skipped"))
        self.assertIn("no time was left to end: races 20000", said)
        code, said = self.ci(4800 - 30)
        self.assertEqual((code, said.splitlines()[-1]), (0, "6 passed, 0 failed, 14 skipped"))
        self.assertIn("no time was left for: races 20000", said)

    def test_a_step_that_all_machines_have_time_for_is_never_left_out(self) -> None:
        self.assertEqual(self.ci(FAKE_STOPS="hil 0")[0], 1)
        self.assertEqual(self.ci(FAKE_FAILS="hil 0")[0], 1)


if __name__ == "__main__":
    unittest.main()
