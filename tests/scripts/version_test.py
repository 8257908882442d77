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
        found = re.search(r"^## (\S+)", (ROOT / "CHANGELOG.md").read_text(), re.MULTILINE)
        self.assertEqual(found and found[1], self.version)

    def test_the_module_for_python_has_it(self) -> None:
        self.assertEqual(tomllib.loads((ROOT / "host/python/pyproject.toml").read_text())["project"]["version"], self.version)

    def test_examples_ask_for_it(self) -> None:
        asked = subprocess.run(["git", "-C", ROOT, "grep", "-hoE", r"find_package\(isotouch [0-9.]+", "--", "docs", "host"], check=True, stdout=subprocess.PIPE, text=True)
        self.assertEqual({line.split()[1] for line in asked.stdout.splitlines()}, {self.minor})


if __name__ == "__main__":
    unittest.main()
