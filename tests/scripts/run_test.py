#!/usr/bin/env python3
"""What hil/run promises, with rungs that are made here, and hil/desk/run."""

from __future__ import annotations

import json
import signal
import unittest

import fakes

OBJECT = '{"rung": %d, "scenario": "\'$1\'", "seed": \'$2\', "exit": 0, "ticks": 5, "missed": null, "trace_hash": "0123456789abcdef", "ticks_to_zero": 2, "skipped": 1, "seconds": 3}'


class RunTest(fakes.Tree):
    def setUp(self) -> None:
        super().setUp()
        for rung, folder in enumerate(("desk", "processors", "rig", "outside")):
            self.script(f"hil/{folder}/make", f"echo made $* >>{self.root}/made")
            self.script(f"hil/{folder}/run", f"echo '{OBJECT % rung}'\necho HIL_ONCE=$HIL_ONCE >&2\n")
            (self.root / f"hil/{folder}/scenarios").write_text("# a comment\none  # the first\ntwo\n" if rung == 0 else "one\n")

    def test_every_scenario_of_every_rung_is_in_the_table_and_counted(self) -> None:
        code, said, _ = self.call("hil/run")
        self.assertEqual(code, 0)
        self.assertIn("   0  two                          1     0         5       -        2  0123456789abcdef        3\n", said)
        self.assertEqual(said.splitlines()[-1], "5 passed, 0 failed, 5 skipped")
        self.assertEqual((self.root / "made").read_text(), "made one two\nmade one\nmade one\nmade one\n")

    def test_a_scenario_that_fails_fails_the_run_and_shows_its_complaints(self) -> None:
        self.script("hil/rig/run", "echo because >&2\nexit 6\n")
        code, said, complaints = self.call("hil/run", "0", "2")
        self.assertEqual((code, complaints, said.splitlines()[-1]), (1, "because\n", "2 passed, 1 failed, 2 skipped"))
        self.assertIn("   2  one                          1     6 ", said)

    def test_a_scenario_that_prints_a_good_object_and_fails_has_failed(self) -> None:
        self.script("hil/rig/run", f"echo '{OBJECT % 2}'\nexit 3\n")
        self.assertEqual(self.call("hil/run", "2")[0], 1)

    def test_a_scenario_that_says_nothing_of_itself_has_failed(self) -> None:
        for said in ("", "{cut off", "cut {off", OBJECT % 3, (OBJECT % 2).replace('"exit": 0', '"exit": 3'), (OBJECT % 2).replace("$2", "7")):
            self.script("hil/rig/run", f"echo '{said}'\n")
            code, table, _ = self.call("hil/run", "2")
            self.assertEqual((code, table.splitlines()[-1]), (1, "0 passed, 1 failed, 0 skipped"), said)
            self.assertIn("   2  one                          1     1 ", table, said)

    def test_a_rung_that_cannot_be_made_fails_its_scenarios(self) -> None:
        self.script("hil/desk/make", "echo no compiler\nexit 2\n")
        code, said, complaints = self.call("hil/run", "0", "--json")
        self.assertEqual((code, complaints), (1, "no compiler\n"))
        self.assertEqual([(each["scenario"], each["exit"]) for each in map(json.loads, said.splitlines())], [("one", 1), ("two", 1)])

    def test_a_range_of_seeds_is_one_run_of_each(self) -> None:
        code, said, _ = self.call("hil/run", "--seed", "08-10", "--json", "3")
        self.assertEqual((code, [json.loads(line)["seed"] for line in said.splitlines()]), (0, [8, 9, 10]))
        self.assertEqual((self.root / "build/hil/3-one-9.log").read_text(), "HIL_ONCE=1\n")

    def test_a_scenario_runs_on_every_rung_that_has_it(self) -> None:
        self.assertEqual(self.call("hil/run", "two")[1].splitlines()[-1], "1 passed, 0 failed, 1 skipped")

    def test_wrong_usage_is_exit_code_2(self) -> None:
        for words in (("7",), ("4",), ("three",), ("--seed",), ("--seed", "3-1"), ("--seed", "x"), ("--what",)):
            code, said, complaints = self.call("hil/run", *words)
            self.assertEqual((code, said, complaints[:5]), (2, "", "hil: "), words)

    def test_an_environment_is_for_the_board_of_a_lab_and_must_be_there(self) -> None:
        self.script("hil/lab/make", "true\n")
        self.script("hil/lab/run", f"echo '{OBJECT % 5}'\necho env $HIL_ENV >&2\n")
        (self.root / "hil/lab/scenarios").write_text("one\n")
        (self.root / "lab.yaml").write_text("")
        self.assertEqual(self.call("hil/run", "5", "one", "--env", "lab.yaml")[0], 0)
        self.assertEqual((self.root / "build/hil/5-one-1.log").read_text(), f"env {self.root}/lab.yaml\n")
        self.assertEqual(self.call("hil/run", "5", "one", HIL_ENV="left/over")[0], 0)
        self.assertEqual((self.root / "build/hil/5-one-1.log").read_text(), "env\n")
        self.assertEqual(self.call("hil/run", "5", "--env", "no.yaml"), (2, "", "hil: --env 'no.yaml': there is no such file; name a labgrid environment, "
                                                                           "as docs/boards-in-a-lab.md shows one\n"))
        self.assertEqual(self.call("hil/run", "5", "--env")[0], 2)
        self.assertEqual(self.call("hil/run", "2", "--env", "lab.yaml"), (2, "", "hil: --env is for rung 5; write ./dev hil 5 --env FILE\n"))

    def test_accept_is_for_the_cases_and_gives_their_exit_code(self) -> None:
        self.script("hil/cases/run", 'echo "$@"\nexit 3\n')
        self.assertEqual(self.call("hil/run", "--accept", "ball", "--reason", "a b")[:2], (3, "--accept ball --reason a b\n"))

    def test_a_time_limit_fails_the_scenario(self) -> None:
        self.script("hil/desk/run", "sleep 30\n")
        self.assertEqual(self.call("hil/run", "0", "one", HIL_LIMIT="0.2")[0], 1)

    def test_an_interrupt_ends_what_was_started(self) -> None:
        self.script("hil/desk/run", fakes.SLEEPS)
        for how in (signal.SIGTERM, signal.SIGHUP):
            self.assertEqual(self.interrupt(how, "hil/run", "0", "one"), 130)


class DeskRunTest(fakes.Tree):
    def setUp(self) -> None:
        super().setUp()
        self.script("build/release/bin/replay_plain", 'echo \'{"ticks": 10, "hash": "00000000000000ab", "first_difference": null}\'\nshift\necho $* >&2\n')
        golden = self.root / "tests/golden"
        golden.mkdir(parents=True)
        (golden / "recordings").write_text("# a comment\nslow ball\nfast ball\n")
        for name in ("slow.trace", "fast.trace", "fast.patches"):
            (golden / name).touch()

    def outcome(self, scenario: str) -> tuple[int, dict[str, object], str]:
        code, said, complaints = self.call("hil/desk/run", scenario, "7")
        return code, json.loads(said), complaints

    def test_ticks_are_added_and_several_hashes_become_one(self) -> None:
        code, found, _ = self.outcome("golden")
        self.assertEqual((code, found["exit"], found["ticks"], found["seed"]), (0, 0, 20, 7))
        self.assertRegex(str(found["trace_hash"]), "^[0-9a-f]{16}$")
        self.assertNotEqual(found["trace_hash"], "00000000000000ab")

    def test_every_recording_is_replayed_with_its_patches(self) -> None:
        golden = self.root / "tests/golden"
        self.outcome("golden")
        self.assertEqual((self.root / "build/hil/golden-7/log").read_text().splitlines()[1::2], [f"{golden}/slow.trace", f"{golden}/fast.trace {golden}/fast.patches"])
        for stranger in (golden / "new.trace", golden / "slow.trace"):
            stranger.unlink() if stranger.exists() else stranger.touch()
            code, found, complaints = self.outcome("golden")
            self.assertEqual((code, found["exit"]), (1, 1))
            self.assertIn(f"differ in: {stranger.stem}", complaints)
            (golden / "new.trace").unlink(missing_ok=True)

    def test_a_child_that_fails_fails_the_scenario(self) -> None:
        programs = {"golden": "build/release/bin/replay_plain", "tour": "build/release/bin/isotouch", "closed-loop": "tests/integration/closed_loop", "touch": "hil/touch_demo",
                    "cases": "hil/cases/run", "coverage": "hil/cases/coverage", "faults": "build/release/bin/fault_matrix", "instructions": "hil/instructions/ceilings"}
        for scenario, program in programs.items():
            with self.subTest(scenario):
                self.script(program, 'echo \'{"ticks": 10, "hash": "00000000000000ab"}\'\necho because >&2\nexit 3\n')
                code, found, complaints = self.outcome(scenario)
                self.assertEqual((code, found["exit"], found["ticks"]), (3, 3, 10))
                self.assertIn("because\n", complaints)

    def test_a_program_that_is_missing_and_a_scenario_that_is_not_fail(self) -> None:
        self.assertEqual(self.outcome("faults")[0], 127)
        self.assertEqual(self.outcome("nonsense")[::2], (1, "no scenario 'nonsense'\n"))

    def test_figures_are_read_from_text_too(self) -> None:
        figures = fakes.load("desk/run").figures_of
        matrix = "unplugged  2  fault\n32 faults, 0 bounds broken, at most 3 ticks until no force is commanded, 10 are allowed. The ticks\n"
        self.assertEqual(figures(matrix)["ticks_to_zero"], 3)
        said = "ticks            70, of which late 4\nticks        60\nreplay hash  00000000000000ab\ncases: 3 compared, 2 skipped\nceilings: armhf: x: not judged\n"
        self.assertEqual(figures(said), {"ticks": 60, "missed": 4, "trace_hash": "00000000000000ab", "ticks_to_zero": None, "skipped": 3})


if __name__ == "__main__":
    unittest.main()
