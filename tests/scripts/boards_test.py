#!/usr/bin/env python3
"""What hil/rig/run, hil/outside/run and hil/bare_metal/run promise, with consoles that are made here."""

from __future__ import annotations

import hashlib
import json
import unittest
from typing import Any

import fakes

STATUS = "hil: status: {\nhil: status:   \"ticks\": 500,\nhil: status:   \"late\": %s\nhil: status: }\n"
CONSOLE = 'kernel\nhil: trace all "ticks": 70, "hash": "00000000000000ab" \nhil: zero unplugged: stale, fault, ticks 2\nhil: cases: 4 compared, 3 skipped\n'
ANSWER = '{"ticks": 9, "hash": "00000000000000cd", "first_difference": null}'


class BoardsTest(fakes.Tree):
    def console(self, text: str) -> None:
        (self.root / "console").write_text(text)

    def run_board(self, script: str, scenario: str, **environment: str) -> tuple[int, dict[str, Any]]:
        code, said, _ = self.call(script, scenario, "7", **environment)
        outcome = json.loads(said)
        self.assertEqual((outcome["scenario"], outcome["seed"], outcome["exit"]), (scenario, 7, code))
        return code, outcome


class RigTest(BoardsTest):
    def setUp(self) -> None:
        super().setUp()
        self.script("hil/rig/head", '[ "$2" = late ] && echo ${FAKE_LATE:-0} || echo "$3"\n')
        self.script("hil/rig/boot", f'cat {self.root}/console\n[ -z "$FAKE_NOISE" ] || echo $$\nexit ${{FAKE_EXIT:-0}}\n')
        self.console(CONSOLE + STATUS % 0 + STATUS % 0 + "hil: done\n")

    def rig(self, **environment: str) -> tuple[int, dict[str, Any]]:
        return self.run_board("hil/rig/run", "tour", **environment)

    def test_two_equal_runs_are_told_with_the_figures_of_the_first(self) -> None:
        code, outcome = self.rig()
        self.assertEqual(code, 0)
        self.assertEqual([outcome[key] for key in ("rung", "ticks", "missed", "trace_hash", "ticks_to_zero", "skipped", "equal")], [2, 1000, 0, "00000000000000ab", 2, 3, True])

    def test_once_has_nothing_to_be_equal_to(self) -> None:
        code, outcome = self.rig(HIL_ONCE="1", FAKE_NOISE="1")
        self.assertEqual((code, outcome["equal"]), (0, None))

    def test_two_runs_that_differ_fail(self) -> None:
        code, outcome = self.rig(FAKE_NOISE="1")
        self.assertEqual((code, outcome["equal"]), (3, False))

    def test_a_board_that_fails_or_never_comes_to_the_end_fails(self) -> None:
        self.assertEqual(self.rig(FAKE_EXIT="5")[0], 5)
        self.console(CONSOLE + STATUS % 0)
        self.assertEqual(self.rig()[0], 6)

    def test_ticks_are_late_where_that_is_ordered_and_nowhere_else(self) -> None:
        self.console(STATUS % 2 + STATUS % 1 + "hil: done\n")
        self.assertEqual(self.rig()[0], 4)
        self.assertEqual(self.rig(FAKE_LATE="3")[0], 0)

    def test_a_status_that_is_cut_or_missing_is_no_status(self) -> None:
        self.console((STATUS % 0).replace("500", "5[ 3.1] kernel") + "hil: done\n")
        code, outcome = self.rig()
        self.assertEqual((code, outcome["missed"], outcome["ticks"]), (4, None, None))
        self.console(STATUS % 0 + (STATUS % 7).replace("7", "7[ 3.1] kernel") + "hil: done\n")   # the first alone would pass
        self.assertEqual(self.rig()[0], 4)
        self.console(CONSOLE + "hil: done\n")
        self.assertEqual(self.rig()[0], 4)
        code, outcome = self.rig(FAKE_LATE="null")
        self.assertEqual((code, outcome["ticks"]), (0, 70))


class DialogueTest(fakes.Tree):
    def test_only_so_many_packets_as_are_compared_are_a_dialogue(self) -> None:
        self.script("isotouchctl", "printf 'fresh,packet,command_1,command_2,command_3\\n1,5,0,0,0\\n0,5,0,0,0\\n1,6,1,2,3\\n'\nexit $FAKE_EXIT\n")
        dialogue, tool = str(fakes.ROOT / "hil/rig/guest/dialogue"), str(self.root / "isotouchctl")

        def run(packets: int, ends_with: int) -> tuple[int, str, str]:
            return self.call("/bin/sh", dialogue, "a.trace", str(packets), ISOTOUCHCTL=tool, FAKE_EXIT=str(ends_with))

        code, said, _ = run(2, 0)
        self.assertEqual(code, 0)
        self.assertRegex(said, '^"packets": 2, "with_commands": 1, "hash": "[0-9a-f]{16}"\n$')
        self.assertEqual(run(1, 0)[:2], (0, '"packets": 1, "with_commands": 0, "hash": "' + hashlib.sha256(b"5 0 0 0\n").hexdigest()[:16] + '"\n'))
        self.assertEqual(run(3, 0), (1, "", "dialogue: a.trace has 2 packets, and 3 are compared\n"))
        self.assertEqual(run(2, 1)[:2], (1, ""))


class OutsideTest(BoardsTest):
    def setUp(self) -> None:
        super().setUp()
        for file in ("rig/arm64/vmlinuz", "outside/initramfs.gz", "release/bin/falcon-sim", "release/bin/board_wires"):
            self.script(f"build/{file}", "")
        self.script("hil/outside/scenarios/unplug", 'echo "hil: seed $seed" >>"$console"\nexit ${FAKE_EXIT:-0}\n')
        self.script("hil/outside/host.sh", f'cat {self.root}/console >>"$console"\n')
        self.console(CONSOLE + STATUS % 4 + "hil: to zero 1\n")

    def test_the_scenarios_end_is_the_outcome(self) -> None:
        code, outcome = self.run_board("hil/outside/run", "unplug")
        self.assertEqual((code, [outcome[key] for key in ("rung", "ticks", "missed", "trace_hash", "ticks_to_zero")]), (0, [3, 500, 4, "00000000000000ab", 1]))
        self.assertTrue((self.root / "build/outside/unplug-7.log").read_text().endswith("hil: seed 7\n"))
        self.assertEqual(self.run_board("hil/outside/run", "unplug", FAKE_EXIT="9")[0], 9)

    def test_what_is_missing_is_named(self) -> None:
        self.assertIn("there are: unplug", self.call("hil/outside/run", "nonsense", "7")[2])
        (self.root / "build/outside/initramfs.gz").unlink()
        self.assertEqual(self.call("hil/outside/run", "unplug", "7")[::2], (2, "run: build/outside/initramfs.gz is missing; hil/outside/make makes it\n"))


class BareMetalTest(BoardsTest):
    def setUp(self) -> None:
        super().setUp()
        self.script("build/release/bin/isotouch", 'for last; do :; done\necho made >"$last"\nexit ${FAKE_TOOL:-0}\n')
        self.script("build/release/bin/replay_plain", f"echo '{ANSWER}'\n")
        self.script("hil/bare_metal/boot", f'cat {self.root}/console\n[ -z "$FAKE_NOISE" ] || echo $$\nexit ${{FAKE_EXIT:-0}}\n')
        self.console(ANSWER + "\n")

    def test_the_desks_hash_twice_passes(self) -> None:
        code, outcome = self.run_board("hil/bare_metal/run", "hand-tour")
        self.assertEqual((code, outcome["rung"], outcome["ticks"], outcome["trace_hash"]), (0, 4, 9, "00000000000000cd"))

    def test_another_hash_none_or_two_consoles_that_differ_fail(self) -> None:
        self.assertEqual(self.run_board("hil/bare_metal/run", "tour", FAKE_NOISE="1")[0], 3)
        self.console(ANSWER.replace("cd", "ce"))
        self.assertEqual(self.run_board("hil/bare_metal/run", "tour")[0], 3)
        self.console("")
        self.assertEqual(self.run_board("hil/bare_metal/run", "tour")[0], 3)
        self.assertEqual(self.run_board("hil/bare_metal/run", "tour", FAKE_EXIT="1")[0], 1)

    def test_what_cannot_be_made_fails(self) -> None:
        code, _, complaints = self.call("hil/bare_metal/run", "tour", "7", FAKE_TOOL="1")
        self.assertEqual((code, "isotouch shape: exit code 1" in complaints), (1, True))


if __name__ == "__main__":
    unittest.main()
