#!/usr/bin/env python3
"""The doors of the fuzzer reach everything that they are meant to reach."""

from __future__ import annotations

import re
import subprocess
import tempfile
import unittest
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FUZZ = ROOT / "tests" / "fuzz"
NOT_FUZZED = {   # each with its reason
    "isotouch_build": "takes seconds, and every format of points has its own door; tests/host/python/buffers_test.py hands it odd arrays",
    "isotouch_build_default": "the same",
}


def functions(header: Path) -> set[str]:
    return set(re.findall(r"^ISOTOUCH_API\b[^;(]*?\b(isotouch_\w+)\(", header.read_text(), re.MULTILINE))


# Stands in for the tool: writes something into the file behind -o.
TOOL = """#!/bin/sh
while [ "$1" != -o ]; do shift; done
echo something >"$2"
"""
WELCOME = 129


def frames(stream: bytes) -> Iterator[tuple[int, bytes]]:
    """Kind and body of each frame (shared/protocol.h); raises ValueError where there is none. The door writes the checksums."""
    while stream:
        length = int.from_bytes(stream[8:12], "little")
        if stream[:4] != b"ITCW" or stream[5:8] != bytes(3) or len(stream) < 16 + length:
            raise ValueError(stream[:16])
        yield stream[4], stream[16 : 16 + length]
        stream = stream[16 + length :]


class FuzzTest(unittest.TestCase):
    def test_every_function_of_the_c_libraries_is_called_by_a_door(self) -> None:
        known = functions(ROOT / "host/library/isotouch.h") | functions(ROOT / "host/build_library/isotouch_build.h")
        self.assertGreater(len(known), 30)
        called = {name for door in FUZZ.glob("*_fuzz.cpp") for name in re.findall(r"\b(isotouch_\w+)\(", door.read_text())}
        self.assertEqual(known - called, set(NOT_FUZZED), "call it in tests/fuzz/library_fuzz.cpp or link_fuzz.cpp")

    def test_every_door_has_seeds_and_kept_inputs(self) -> None:
        doors = {door.name.removesuffix("_fuzz.cpp") for door in FUZZ.glob("*_fuzz.cpp")}
        seeds = (FUZZ / "seeds").read_text()
        made = set(re.search(r"^for door in ([a-z ]+); do", seeds, re.MULTILINE)[1].split())  # type: ignore[index]
        self.assertEqual(made, doors)
        self.assertEqual({folder.name for folder in (FUZZ / "corpus").iterdir() if any(folder.iterdir())}, doors, "./dev fuzz minimise DOOR")
        self.assertLessEqual({entry.stem for entry in (FUZZ / "dictionaries").iterdir()}, doors)

    def test_frames_that_are_seeds_have_the_layout_of_the_protocol(self) -> None:
        major = re.search(r"kMajor = (\d+);", (ROOT / "shared/protocol.h").read_text())
        assert major
        with tempfile.TemporaryDirectory() as folder:
            tool, seeds = Path(folder, "tool"), Path(folder, "seeds")
            tool.write_text(TOOL)
            tool.chmod(0o755)
            subprocess.run([FUZZ / "seeds", tool, seeds], check=True, cwd=ROOT)
            answers = [seed.read_bytes()[1:] for seed in (seeds / "link").iterdir()]   # behind the byte that says what is asked
            messages = [seed.read_bytes() for seed in (seeds / "protocol").iterdir()]
        self.assertGreater(len(answers), 10)
        for answer in answers:
            (kind, body), *rest = frames(answer)
            self.assertEqual((kind, int.from_bytes(body[:2], "little")), (WELCOME, int(major[1])), "a greeting that the client accepts")
            self.assertGreater(len(rest), 10)
        self.assertGreater(len(messages), 20)
        for message in messages:
            self.assertEqual(len(list(frames(message))), 1)

    def test_kept_inputs_are_few_and_small(self) -> None:
        kept = [entry.stat().st_size for entry in (FUZZ / "corpus").rglob("*") if entry.is_file()]
        self.assertGreater(len(kept), 100)
        self.assertLessEqual(max(kept), 65_536)
        self.assertLessEqual(sum(kept), 1_500_000)


if __name__ == "__main__":
    unittest.main()
