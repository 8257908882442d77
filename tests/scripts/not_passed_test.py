#!/usr/bin/env python3
"""What tests/integration/not_passed promises, on reports as ctest writes them."""

from __future__ import annotations

import pathlib
import subprocess
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).parents[1] / "integration" / "not_passed"
REPORT = """<?xml version="1.0" encoding="UTF-8"?>
<testsuite name="release" tests="3" failures="1" disabled="0" skipped="1">
  <testcase name="Fixed.Adds" status="run"><system-out>quiet</system-out></testcase>
  <testcase name="remote_control" status="fail"><failure message=""/><system-out>{out}</system-out></testcase>
</testsuite>
"""
SKIPPED = """<testsuite>
  <testcase name="Fixed.Adds" status="run"><system-out>left out: nothing</system-out></testcase>
  <testcase name="ssh" status="notrun"><skipped message="SKIP_REGULAR_EXPRESSION_MATCHED"/><system-out>[ RUN      ] ssh
upload_test.cpp:289: Skipped
no sshd is installed
[  SKIPPED ] ssh (1 ms)
</system-out></testcase>
  <testcase name="wiring" status="notrun"><skipped message="SKIP_RETURN_CODE=77"/><system-out>left out: rights
a crash: the device is left without force
left out: a bit that flips
</system-out></testcase>
  <testcase name="Golden.Writes" status="disabled"><system-out>Disabled</system-out></testcase>
  <testcase name="odd" status="notrun"><skipped message=""/></testcase>
</testsuite>
"""


class NotPassedTest(unittest.TestCase):
    def setUp(self) -> None:
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.root = pathlib.Path(kept.name)

    def told(self, *presets: str) -> list[str]:
        reports = [str(self.root / preset / "tests.xml") for preset in presets]
        return subprocess.run([SCRIPT, *reports], check=True, stdout=subprocess.PIPE, text=True).stdout.splitlines()

    def report(self, preset: str, text: str) -> None:
        (self.root / preset).mkdir()
        (self.root / preset / "tests.xml").write_text(text)

    def test_a_failed_test_is_named_with_the_end_of_its_output(self) -> None:
        self.report("release", REPORT.replace("{out}", "\n".join(f"line {i}" for i in range(40))))
        told = self.told("release")
        self.assertEqual(told[0], "failed in release: remote_control")
        self.assertEqual(told[1:], [f"  line {i}" for i in range(15, 40)])

    def test_a_skipped_test_is_named_once_with_its_reason_and_every_preset(self) -> None:
        self.report("release", SKIPPED)
        self.report("arm64", SKIPPED.replace("installed", "wanted"))
        self.assertEqual(self.told("release", "arm64"), [
            "skipped in release: ssh: no sshd is installed",
            "skipped in release, arm64: wiring: rights; a bit that flips",
            "skipped in release, arm64: Golden.Writes: it is disabled",
            "skipped in release, arm64: odd: it does not say why",
            "skipped in arm64: ssh: no sshd is wanted"])

    def test_a_report_that_is_missing_or_broken_is_passed_over(self) -> None:
        self.report("clang", "<testsuite><testcase")
        self.report("release", REPORT.replace("{out}", "why"))
        self.assertEqual(self.told("arm64", "clang", "release"), ["failed in release: remote_control", "  why"])


if __name__ == "__main__":
    unittest.main()
