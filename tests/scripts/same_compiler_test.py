#!/usr/bin/env python3
"""What hil/instructions/same_compiler promises, beside the ceilings as they stand in the tree."""

from __future__ import annotations

import re
import shutil
import unittest

import fakes

CEILINGS = "hil/instructions/ceilings.csv"


class SameCompilerTest(fakes.Tree):
    def setUp(self) -> None:
        super().setUp()
        for file in (CEILINGS, "hil/instructions/same_compiler"):
            shutil.copy(fakes.ROOT / file, self.root / file)
        named = re.match(r"# counted with gcc (\d+)", (self.root / CEILINGS).read_text())
        assert named
        self.counted = int(named[1])

    def same(self, built: int) -> tuple[int, str, str]:
        known = self.root / "build/release/CMakeFiles/3.25.1/CMakeCXXCompiler.cmake"
        known.parent.mkdir(parents=True, exist_ok=True)
        known.write_text(f'set(CMAKE_CXX_COMPILER "/usr/bin/c++")\nset(CMAKE_CXX_COMPILER_VERSION "{built}.2.0")\n')
        return self.call("hil/instructions/same_compiler", "release")

    def test_the_compiler_of_the_ceilings_is_known_from_their_first_line(self) -> None:
        self.assertEqual(self.same(self.counted), (0, "", ""))

    def test_another_compiler_is_named(self) -> None:
        other = self.counted + 1
        self.assertEqual(self.same(other)[:2], (1, f"release was built with gcc {other} and the limits were counted with gcc {self.counted}: "
                                                   "it may take half as many instructions again\n"))

    def test_ceilings_that_name_no_compiler_are_no_excuse(self) -> None:
        (self.root / CEILINGS).write_text("processor,method,hip_to_force,counts_to_words\n")
        code, said, complaint = self.same(self.counted)
        self.assertEqual((code, said), (2, ""))
        self.assertIn("does not say with which gcc", complaint)


if __name__ == "__main__":
    unittest.main()
