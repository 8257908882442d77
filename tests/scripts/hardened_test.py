#!/usr/bin/env python3
"""tests/integration/hardened sees each protection that is left out, on programs that are compiled here."""

from __future__ import annotations

import pathlib
import shutil
import subprocess
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).parents[1] / "integration" / "hardened"
SOURCE = '#include <cstring>\nint main(int, char** v) { char name[20]; std::strcpy(name, v[0]); return name[1]; }\n'
COMPILE = ["-O2", "-fstack-protector-strong", "-U_FORTIFY_SOURCE", "-D_FORTIFY_SOURCE=2"]
LINK = ["-pie", "-Wl,-z,relro,-z,now,-z,noexecstack"]


class HardenedTest(unittest.TestCase):
    def setUp(self) -> None:
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.root = pathlib.Path(kept.name)
        (self.root / "main.cpp").write_text(SOURCE)

    def told(self, *options: str, compiler: str = "g++") -> tuple[int, str]:
        program = self.root / "program"
        subprocess.run([compiler, "-fPIE", *COMPILE, *LINK, *options, str(self.root / "main.cpp"), "-o", str(program)], check=True)
        done = subprocess.run([SCRIPT, program], stdout=subprocess.PIPE, text=True)
        return done.returncode, done.stdout

    def test_a_program_with_all_of_it(self) -> None:
        code, said = self.told()
        self.assertEqual((code, said.split()), (0, ["program", "hardened"]))

    def test_each_protection_that_is_left_out_is_named(self) -> None:
        for name, option in {"a random address": "-no-pie", "read-only relocations": "-Wl,-z,norelro", "binding before it runs": "-Wl,-z,lazy",
                             "a stack without code": "-Wl,-z,execstack", "stack protectors": "-fno-stack-protector",
                             "checked copies": "-U_FORTIFY_SOURCE"}.items():
            with self.subTest(name):
                code, said = self.told(option)
                self.assertEqual((code, said.split("without ", 1)[1].strip()), (3, name))

    @unittest.skipUnless(shutil.which("clang++"), "clang++ is not installed")
    def test_of_clang_checked_copies_are_not_looked_for_and_that_is_said(self) -> None:
        code, said = self.told("-U_FORTIFY_SOURCE", compiler="clang++")
        self.assertEqual((code, said.split(maxsplit=1)), (0, ["program", "hardened, checked copies not looked for\n"]))

    def test_nothing_to_read_is_no_success(self) -> None:
        self.assertEqual(subprocess.run([SCRIPT], stderr=subprocess.DEVNULL).returncode, 2)


if __name__ == "__main__":
    unittest.main()
