#!/usr/bin/env python3
"""What tests/integration/failed_tests promises, on reports as ctest writes them."""

from __future__ import annotations

import pathlib
import subprocess
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).parents[1] / "integration" / "failed_tests"
REPORT = """<?xml version="1.0" encoding="UTF-8"?>
<testsuite name="release" tests="3" failures="1" disabled="0" skipped="1">
  <testcase name="Fixed.Adds" status="run"><system-out>quiet</system-out></testcase>
  <testcase name="remote_control" status="fail"><failure message=""/><system-out>{out}</system-out></testcase>
  <testcase name="ssh" status="notrun"><skipped message=""/></testcase>
</testsuite>
"""


class FailedTestsTest(unittest.TestCase):
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

    def test_a_report_that_is_missing_or_broken_is_passed_over(self) -> None:
        self.report("clang", "<testsuite><testcase")
        self.report("release", REPORT.replace("{out}", "why"))
        self.assertEqual(self.told("arm64", "clang", "release"), ["failed in release: remote_control", "  why"])


if __name__ == "__main__":
    unittest.main()
