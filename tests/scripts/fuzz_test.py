#!/usr/bin/env python3
"""The doors of the fuzzer reach everything that they are meant to reach."""

import re
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FUZZ = ROOT / "tests" / "fuzz"
NOT_FUZZED = {   # each with its reason
    "isotouch_build": "takes seconds, and every format of points has its own door; tests/host/python/buffers_test.py hands it odd arrays",
    "isotouch_build_default": "the same",
}


def functions(header: Path) -> set[str]:
    return set(re.findall(r"^ISOTOUCH_API\b[^;(]*?\b(isotouch_\w+)\(", header.read_text(), re.MULTILINE))


class FuzzTest(unittest.TestCase):
    def test_every_function_of_the_c_libraries_is_called_by_a_door(self) -> None:
        known = functions(ROOT / "host/library/isotouch.h") | functions(ROOT / "host/build_library/isotouch_build.h")
        self.assertGreater(len(known), 30)
        called = {name for door in FUZZ.glob("*_fuzz.cpp") for name in re.findall(r"\b(isotouch_\w+)\(", door.read_text())}
        self.assertEqual(known - called, set(NOT_FUZZED), "call it in tests/fuzz/library_fuzz.cpp or link_fuzz.cpp")

    def test_every_door_has_seeds_and_every_kept_input_a_door(self) -> None:
        doors = {door.name.removesuffix("_fuzz.cpp") for door in FUZZ.glob("*_fuzz.cpp")}
        seeds = (FUZZ / "seeds").read_text()
        made = set(re.search(r"^for door in ([a-z ]+); do", seeds, re.MULTILINE)[1].split())  # type: ignore[index]
        self.assertEqual(made, doors)
        for folder in ("corpus", "dictionaries"):
            self.assertLessEqual({entry.name.removesuffix(".dict") for entry in (FUZZ / folder).iterdir()}, doors, folder)

    def test_kept_inputs_are_few_and_small(self) -> None:
        kept = [entry.stat().st_size for entry in (FUZZ / "corpus").rglob("*") if entry.is_file()]
        self.assertGreater(len(kept), 100)
        self.assertLessEqual(sum(kept), 500_000)


if __name__ == "__main__":
    unittest.main()
