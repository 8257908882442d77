#!/usr/bin/env python3
"""Debian's packages are built with the libraries that ./dev installs, and nothing that lintian says is overridden."""

from __future__ import annotations

import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).parents[2]
OF_TESTS = {"libgtest-dev", "libgmock-dev"}


def libraries(text: str) -> set[str]:
    return set(re.findall(r"\b(?:lib[a-z0-9.+-]+|nlohmann-json3)-dev\b", text))


class DebianTest(unittest.TestCase):
    def test_libraries_are_those_of_dev(self) -> None:
        lists = re.findall(r"^(?:libraries|packages_build)=\((.*)\)", (ROOT / "dev").read_text(), re.MULTILINE)
        self.assertEqual(len(lists), 2)
        wanted = (ROOT / "packaging/debian/control").read_text().split("Package:")[0]
        self.assertEqual(libraries(wanted), libraries(" ".join(lists)) - OF_TESTS)

    def test_nothing_is_overridden(self) -> None:
        self.assertEqual([str(file) for file in (ROOT / "packaging/debian").rglob("*lintian*")], [])


if __name__ == "__main__":
    unittest.main()
