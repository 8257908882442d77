#!/usr/bin/env python3
"""The version of CMakeLists.txt is the one that every other file names."""

from __future__ import annotations

import pathlib
import re
import subprocess
import tomllib
import unittest

ROOT = pathlib.Path(__file__).parents[2]


class VersionTest(unittest.TestCase):
    def setUp(self) -> None:
        found = re.search(r"^project\(isotouch VERSION (\d+\.\d+)\.(\d+) ", (ROOT / "CMakeLists.txt").read_text(), re.MULTILINE)
        assert found
        self.minor, self.version = found[1], f"{found[1]}.{found[2]}"

    def test_the_list_of_changes_begins_with_it(self) -> None:
        found = re.search(r"^## ([0-9.]+)", (ROOT / "CHANGELOG.md").read_text(), re.MULTILINE)
        self.assertEqual(found and found[1], self.version)

    def test_released_versions_have_a_date_and_a_tag(self) -> None:
        """A heading `## 0.9.0, 2026-12-24` is of a release, and only the first one may be without a date."""
        headings = re.findall(r"^## (.+)$", (ROOT / "CHANGELOG.md").read_text(), re.MULTILINE)
        released = [heading for heading in headings if re.fullmatch(r"\d+\.\d+\.\d+, \d{4}-\d{2}-\d{2}", heading)]
        self.assertIn(headings[: len(headings) - len(released)], ([], [self.version]))
        tags = subprocess.run(["git", "-C", ROOT, "tag", "--list", "v*"], check=True, stdout=subprocess.PIPE, text=True).stdout.split()
        if tags:   # a shallow clone has none
            self.assertEqual({heading.split(",")[0] for heading in released if heading.split(",")[0] != self.version} - {tag[1:] for tag in tags}, set())
        self.assertEqual({tag[1:] for tag in tags} - {heading.split(",")[0] for heading in released}, set())

    def test_the_module_for_python_has_it(self) -> None:
        self.assertEqual(tomllib.loads((ROOT / "host/python/pyproject.toml").read_text())["project"]["version"], self.version)

    def test_examples_ask_for_it(self) -> None:
        asked = subprocess.run(["git", "-C", ROOT, "grep", "-hoE", r"find_package\(isotouch [0-9.]+", "--", "docs", "host"], check=True, stdout=subprocess.PIPE, text=True)
        self.assertEqual({line.split()[1] for line in asked.stdout.splitlines()}, {self.minor})


if __name__ == "__main__":
    unittest.main()
