#!/usr/bin/env python3
"""What hil/instructions/ceilings promises, with counts that are made here."""

from __future__ import annotations

import unittest

import fakes

COUNT = """
sum='{"worst": 1000, "in_contact": {"median": '${FAKE_MEDIAN:-980}', "worst": 1000}}'
[ -z "$FAKE_NO_CONTACT" ] || sum='{"worst": 1000}'
stage='{"worst": 100}'
echo "{\\"stages\\": {\\"packet\\": $stage, \\"pose\\": $stage, \\"sampler\\": $stage, \\"proxy\\": $stage, \\"feel\\": $stage, \\"words\\": $stage, \\"hip_to_force\\": $sum, \\"counts_to_words\\": $sum}}"
"""
CEILINGS = "# a comment\ncortex-m7,default,1040,1040\ncortex-m7,published,5200,5200\naarch64,default,1040,1040\n"


class CeilingsTest(fakes.Tree):
    def setUp(self) -> None:
        super().setUp()
        (self.root / "hil/instructions/ceilings.csv").write_text(CEILINGS)
        self.script("hil/instructions/count", COUNT)
        self.script("hil/instructions/same_compiler", 'echo "another compiler: half as many again"; exit ${FAKE_COMPILER:-0}\n')
        self.script("hil/cases/run", """echo '{"case": "ball", "method": "default", "hip_to_force": '${FAKE_CASE:-1000}'}'
echo '{"case": "levels", "method": "published", "hip_to_force": '${FAKE_PUBLISHED:-5000}', "counts_to_words": 5000}'; exit ${FAKE_CASES_EXIT:-0}\n""")
        self.script("build/release/bin/isotouch", "exit ${FAKE_TOOL:-0}\n")
        self.script("build/release/bin/worst_tick", """echo '{"hip_to_force": '${FAKE_SEARCH:-1000}'}'\n""")
        self.script("build/cortex-m7/bin/replay_bare", "")

    def ceilings(self, *words: str, **environment: str) -> tuple[int, str, str]:
        return self.call("hil/instructions/ceilings", *words, **environment)

    def test_what_lies_just_below_its_ceiling_passes(self) -> None:
        code, said, complaints = self.ceilings()
        self.assertEqual((code, complaints), (0, ""))
        self.assertEqual(said.count("cortex-m7  "), 10, "a line for each of 8 motions, the stages and the sums")
        self.assertRegex(said, r"cortex-m7, published +5000 +5200 +5000 +5200 ")
        self.assertRegex(said, r"cortex-m7 +1000 +1040 +1000 +1040 ")

    def test_a_motion_a_case_or_the_search_above_the_ceiling_fails(self) -> None:
        for source in ("FAKE_CASE", "FAKE_SEARCH"):
            code, _, complaints = self.ceilings(**{source: "1041"})
            self.assertEqual((code, complaints), (3, "ceilings: cortex-m7: HIP to force took 1041 instructions, the ceiling is 1040\n"), source)
        code, _, complaints = self.ceilings(FAKE_PUBLISHED="5201")
        self.assertEqual((code, complaints), (3, "ceilings: cortex-m7, published: HIP to force took 5201 instructions, the ceiling is 5200\n"))
        (self.root / "hil/instructions/ceilings.csv").write_text(CEILINGS.replace("1040,1040", "999,1040"))
        self.assertEqual(self.ceilings()[0], 3)

    def test_a_ceiling_that_is_a_twentieth_too_high_fails_after_a_long_search_alone(self) -> None:
        (self.root / "hil/instructions/ceilings.csv").write_text(CEILINGS.replace("1040,1040", "1053,1053"))
        self.assertEqual(self.ceilings("--generations", "19")[0], 0)
        code, _, complaints = self.ceilings("--generations", "20")
        self.assertEqual(code, 3)
        self.assertIn("the ceiling 1053 should come down", complaints)

    def test_a_tick_far_above_its_motions_median_fails(self) -> None:
        self.assertEqual(self.ceilings(FAKE_MEDIAN="910")[0], 0)
        self.assertIn("a tick of press takes more than 1.1 medians", self.ceilings(FAKE_MEDIAN="909")[2])

    def test_what_another_compiler_built_may_take_half_as_much_again_and_no_more(self) -> None:
        code, _, complaints = self.ceilings(FAKE_SEARCH="1560", FAKE_COMPILER="1")
        self.assertEqual((code, complaints), (0, "ceilings: another compiler: half as many again\n"))
        code, _, complaints = self.ceilings(FAKE_SEARCH="1561", FAKE_COMPILER="1")
        self.assertEqual(code, 3)
        self.assertIn("HIP to force took 1561 instructions, the ceiling is 1560", complaints)

    def test_a_case_above_its_own_limit_fails(self) -> None:
        self.assertEqual(self.ceilings(FAKE_CASES_EXIT="3")[0], 3)

    def test_a_processor_without_a_ceiling_fails(self) -> None:
        (self.root / "hil/instructions/ceilings.csv").write_text("aarch64,default,1040,1040\n")
        self.assertIn("cortex-m7 has no ceiling", self.ceilings()[2])

    def test_a_ceiling_of_what_is_not_counted_fails(self) -> None:
        (self.root / "hil/instructions/ceilings.csv").write_text(CEILINGS + "cortex-m7,patched,1,1\n")
        self.assertEqual(self.ceilings()[::2], (3, "ceilings: cortex-m7, patched has a ceiling in ceilings.csv, and no case of that method is counted\n"))

    def test_nothing_counted_is_no_success(self) -> None:
        for environment in ({"FAKE_TOOL": "1"}, {"FAKE_NO_CONTACT": "1"}, {"FAKE_CASES_EXIT": "1"}):
            self.assertEqual(self.ceilings(**environment)[0], 1, environment)
        (self.root / "build/cortex-m7/bin/replay_bare").unlink()
        self.assertEqual(self.ceilings()[::2], (1, "ceilings: nothing is built\n"))


if __name__ == "__main__":
    unittest.main()
