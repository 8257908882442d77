#!/usr/bin/env python3
"""What the safety case names as its proof exists: safety_case_test.py BUILD_FOLDER"""

from __future__ import annotations

import re
import subprocess
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SCENARIOS = {"2": ROOT / "hil" / "rig" / "scenarios", "3": ROOT / "hil" / "outside" / "scenarios"}


def section(text: str) -> str:
    return text[text.index("## Safety case\n"):text.index("## How this is tested\n")]


def proofs(text: str) -> list[str]:
    """The code spans in the last column of the tables, which have a header and a line of hyphens."""
    cells = [line.rstrip(" |").rsplit(" | ", 1)[-1] for line in section(text).splitlines() if line.startswith("| ")]
    return [span for cell in cells if cell != "What shows it" for span in re.findall(r"`([^`]+)`", cell)]


def tests(build: Path) -> set[str]:
    listed = subprocess.run(["ctest", "--test-dir", str(build), "-N"], capture_output=True, text=True, check=True).stdout
    return {name for line in listed.splitlines() if (name := re.sub(r"^ *Test +#\d+: ", "", line)) != line}


def exists(proof: str, known: set[str]) -> bool:
    if not proof.startswith("./dev "):
        return proof in known
    _, word, *rest = proof.split()
    if word == "hil" and len(rest) == 2:
        return rest[0] in SCENARIOS and (SCENARIOS[rest[0]] / rest[1]).is_file()
    return not rest and re.search(rf"^  {word}\b", (ROOT / "dev").read_text(encoding="utf-8"), re.MULTILINE) is not None


class SafetyCaseTest(unittest.TestCase):
    build = Path()

    def test_every_proof_exists(self) -> None:
        known = tests(self.build)
        named = proofs((ROOT / "docs" / "safety.md").read_text(encoding="utf-8"))
        self.assertGreater(len(known), 1000)
        self.assertGreater(len(named), 40)
        self.assertEqual([proof for proof in named if not exists(proof, known)], [])

    def test_what_does_not_exist_is_noticed(self) -> None:
        known = {"driver:FaultMatrix.EveryBoundIsKept"}
        for proof in (*known, "./dev faults", "./dev hil 2 tour"):
            self.assertTrue(exists(proof, known), proof)
        for proof in ("driver:FaultMatrix.EveryBound", "./dev nonsense", "./dev hil 2 no-such-scenario", "./dev hil 9 tour", "./dev faults tour"):
            self.assertFalse(exists(proof, known), proof)


if __name__ == "__main__":
    SafetyCaseTest.build = Path(sys.argv.pop())
    unittest.main()
