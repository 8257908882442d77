#!/usr/bin/env python3
"""What hil/mutants/run promises, with a core of one line and programs that look for words in it."""

from __future__ import annotations

import json
import os
import runpy
import signal
import unittest

import fakes

LIST = """# a comment
mutant one for the case
file shared/core.h
-good
+seen by case
why a case sees it

mutant two for the test
file shared/core.h
-good
+seen by test
why a test sees it
"""


class ListTest(unittest.TestCase):
    def test_every_mutant_of_the_list_applies(self) -> None:
        """Tried in seconds; what catches each is tried by ./dev mutants."""
        script = runpy.run_path(str(fakes.ROOT / "hil/mutants/run"))
        mutants = script["mutants_in"]((fakes.ROOT / "hil/mutants/list").read_text())
        self.assertGreater(len(mutants), 100)
        for mutant in mutants:
            with self.subTest(mutant.name):
                self.assertTrue(mutant.whole)
                self.assertEqual((fakes.ROOT / mutant.file).read_text().count("\n".join(mutant.removed)), 1, f"write it anew for {mutant.file}")


class MutantsTest(fakes.Tree):
    def setUp(self) -> None:
        super().setUp()
        (self.root / "shared").mkdir()
        (self.root / "shared/core.h").write_text("good\nlast\n")
        self.list(LIST)
        self.script("hil/cases/run", "echo ball\n")
        self.script("path/git", "echo shared/core.h\n")
        self.script("path/cmake", 'case "$*" in *"${CMAKE_FAILS:-nothing}"*) exit 1;; esac\n')
        look = "grep -q '%s' build/mutants/tree/shared/core.h"
        self.script("build/mutants/build/bin/replay_plain", f"if {look % 'by case'}; then echo '{{\"first_difference\": 12}}'; exit 3; fi\n")
        self.script("build/mutants/build/bin/test_shared", f"if {look % 'by test'}; then echo '[  FAILED  ] A.B (3 ms)'; exit 1; fi\n{look % 'by crash'} && exit 134\nexit 0\n")
        self.script("build/mutants/build/bin/test_firmware_core", "")

    def list(self, text: str) -> None:
        (self.root / "hil/mutants/list").write_text(text)

    def mutants(self, *words: str, **environment: str) -> tuple[int, str, str]:
        answer = self.call("hil/mutants/run", *words, PATH=f"{self.root}/path:{os.environ['PATH']}", **environment)
        self.assertEqual((self.root / "shared/core.h").read_text(), "good\nlast\n")
        return answer

    def test_each_mutant_is_caught_by_the_first_that_sees_it(self) -> None:
        code, said, _ = self.mutants()
        self.assertEqual(code, 0, said)
        self.assertRegex(said, r"killed    one for the case +case ball, tick 12 \(\d+ s\)\nkilled    two for the test +test A.B \(")
        self.assertIn("2 mutants: 1 killed by cases, 1 by tests, 0 survived\n", said)
        self.assertEqual((self.root / "build/mutants/tree/shared/core.h").read_text(), "good\nlast\n")

    def test_a_mutant_that_nothing_sees_survives(self) -> None:
        self.list(LIST.replace("seen by test", "seen by nobody"))
        code, said, _ = self.mutants()
        self.assertEqual((code, said.splitlines()[-2:]), (3, ["SURVIVED  two for the test (shared/core.h)", "2 mutants: 1 killed by cases, 0 by tests, 1 survived"]))

    def test_a_test_program_that_crashes_catches_too(self) -> None:
        self.list(LIST.replace("seen by test", "seen by crash"))
        code, said, _ = self.mutants("two")
        self.assertEqual(code, 0)
        self.assertIn("test program test_shared, exit code 134", said)

    def test_a_time_limit_catches_only_where_what_is_not_broken_ends(self) -> None:
        """124 is what a limit leaves. Where there is `slow`, the machine is too slow from the first limit on."""
        hangs = "if grep -q 'by test' build/mutants/tree/shared/core.h || [ -f late ]; then [ ! -f slow ] || touch late; exit 124; fi\n"
        self.wiring()
        named = (self.root / "hil/mutants/list").read_text().replace("seen by ctest", "seen by test")
        for program, text, what in (("build/mutants/build/bin/replay_plain", LIST, "case ball"),
                                    ("build/mutants/build/bin/test_shared", LIST, "test program test_shared"),
                                    ("path/ctest", named, "ctest -R '\\^loop:'")):
            self.script("hil/cases/run", "echo ball\n")
            before = (self.root / program).read_text()
            self.script(program, hangs)
            self.list(text)
            (self.root / "slow").unlink(missing_ok=True)
            code, said, _ = self.mutants("two", "three")
            self.assertEqual(code, 0, said)
            self.assertRegex(said, f"killed    t.* {what} does not end within its time limit, and without the mutant it does \\(")
            (self.root / "slow").touch()
            code, said, _ = self.mutants("two", "three")
            self.assertEqual((code, said.splitlines()[-1]), (3, "1 mutants: 0 killed by cases, 0 by tests, 0 survived, 1 timed out"))
            self.assertRegex(said, f"TIMED OUT t.*: {what} does not end within its time limit, nor without the mutant; ")
            (self.root / "late").unlink()
            (self.root / program).write_text(before)

    def test_a_mutant_that_does_not_apply_or_is_not_whole_survives(self) -> None:
        for text in (LIST.replace("-good", "-gone"), LIST.replace("-good", "-o"), LIST.replace("-good\n", ""), LIST.replace("why a", "#"), LIST.replace("file s", "file x")):
            self.list(text)
            self.assertEqual(self.mutants()[0], 3, text)

    def test_a_core_that_is_not_broken_must_pass(self) -> None:
        self.script("build/mutants/build/bin/test_firmware_core", "exit 1\n")
        self.assertEqual(self.mutants("two")[::2], (3, "mutants: the core that is not broken fails test program test_firmware_core, exit code 1\n"))
        self.script("build/mutants/build/bin/replay_plain", "exit 1\n")
        self.assertEqual(self.mutants("one")[0], 3)

    def test_a_child_that_fails_fails_the_script(self) -> None:
        for what in ("-S build", "--target replay_plain", "--target test_shared"):
            self.assertEqual(self.mutants(CMAKE_FAILS=what)[0], 1, what)
        self.script("path/git", "echo shared/core.h\nexit 1\n")
        self.assertEqual(self.mutants()[0], 1)
        self.script("path/git", "echo shared/core.h\n")
        self.script("hil/cases/run", "echo ball\nexit 1\n")
        self.assertEqual(self.mutants()[::2], (1, "mutants: the cases cannot be made\n"))

    def wiring(self, test: str = "test_loop: ^loop:") -> None:
        self.list(f"mutant three for a named test\nfile shared/core.h\n-good\n+seen by ctest\ntest {test}\nwhy it says which\n")
        self.script("path/ctest", "echo \"$*\" >>asked\nif grep -q 'seen by ctest' build/mutants/tree/shared/core.h; then\n"
                                  "  printf 'The following tests FAILED:\\n\\t 12 - loop:A.B (Failed)\\nErrors while running CTest\\n'; exit 8\nfi\n")
        self.script("hil/cases/run", "exit 1\n")   # nobody asks for a case

    def test_a_mutant_that_names_its_tests_is_tried_by_these_alone(self) -> None:
        self.wiring()
        code, said, _ = self.mutants()
        self.assertEqual(code, 0, said)
        self.assertRegex(said, r"killed    three for a named test +test loop:A.B \(")
        asked = (self.root / "asked").read_text().splitlines()
        self.assertEqual(len(asked), 2, "what is not broken, and the mutant")
        self.assertIn("--no-tests=error", asked[0])
        self.assertTrue(asked[0].endswith("-R ^loop:"))

    def test_a_mutant_that_its_tests_do_not_see_survives(self) -> None:
        self.wiring()
        self.script("path/ctest", "")
        self.assertEqual(self.mutants()[0], 3)

    def test_tests_that_fail_without_a_mutant_or_are_none_catch_nothing(self) -> None:
        self.wiring()
        self.script("path/ctest", "echo 'No tests were found!!!'\nexit 8\n")
        self.assertEqual(self.mutants()[::2], (3, "mutants: the code that is not broken fails ctest -R '^loop:', exit code 8\n"))

    def test_whatever_ends_it_ends_what_it_started(self) -> None:
        self.wiring()
        self.script("path/ctest", fakes.SLEEPS)
        for how in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            self.assertNotEqual(self.interrupt(how, "hil/mutants/run", PATH=f"{self.root}/path:{os.environ['PATH']}"), 0, how.name)

    def test_a_second_run_waits_until_the_first_has_ended(self) -> None:
        """Each would build and try the other's mutants."""
        self.wait_for_lock("build/mutants", "mutants", "hil/mutants/run", PATH=f"{self.root}/path:{os.environ['PATH']}")

    def test_a_test_without_its_targets_is_not_whole(self) -> None:
        self.wiring("^loop:")
        self.assertEqual(self.mutants()[0], 3)

    def test_a_source_that_this_machine_does_not_compile_is_left_out_and_counted(self) -> None:
        self.list(LIST.replace("shared/core.h", "shared/other.cpp"))
        (self.root / "shared/other.cpp").write_text("good\n")
        (self.root / "build/mutants/build/compile_commands.json").write_text(json.dumps([{"file": str(self.root / "build/mutants/tree/shared/core.cpp")}]))
        code, said, _ = self.mutants()
        self.assertEqual((code, said.splitlines()[-1]), (0, "2 mutants: 0 killed by cases, 0 by tests, 0 survived, 2 left out"))

    def test_what_is_no_longer_there_goes_from_the_copy(self) -> None:
        stale = self.root / "build/mutants/tree/tests/gone_test.cpp"
        stale.parent.mkdir(parents=True)
        stale.write_text("")
        self.assertEqual(self.mutants()[0], 0)
        self.assertFalse(stale.exists())

    def test_words_choose_and_one_that_chooses_nothing_is_wrong_usage(self) -> None:
        self.assertIn("1 mutants: 0 killed by cases, 1 by tests", self.mutants("two")[1])
        self.assertIn("2 mutants: ", self.mutants("shared/core")[1], "of the file, too")
        self.assertEqual(self.mutants("three")[::2], (2, "mutants: no mutant has one of these words in its name or file\n"))

    def test_a_line_that_begins_otherwise_is_refused(self) -> None:
        self.list(LIST + "what\n")
        self.assertEqual(self.mutants()[0], 3)


if __name__ == "__main__":
    unittest.main()
