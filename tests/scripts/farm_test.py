#!/usr/bin/env python3
"""What hil/farm/programs leaves behind, with a cmake that stands in for the real one, and what hil/farm/cost computes."""

from __future__ import annotations

import json
import os
import re
import subprocess
import unittest

import fakes

# Like the real one it keeps what it found when it first configured, unless it begins afresh. A commit's number is also its compiler's version.
CMAKE = """echo "$*" >>"$FAKE_LOG"
[ "$1" != --fresh ] || { shift; rm -rf build/*/CMakeFiles; }
case $1 in
  --preset) [ -e build/$2/CMakeFiles ] || { mkdir -p build/$2/CMakeFiles/3 &&
      printf 'set(CMAKE_CXX_COMPILER_ID "GNU")\nset(CMAKE_CXX_COMPILER_VERSION "%s")\n' "$(cat number)" >build/$2/CMakeFiles/3/CMakeCXXCompiler.cmake; } ;;
  --build) [ -z "${FAKE_MOVES:-}" ] || git checkout -q --detach "$FAKE_MOVES"
    while [ -e "${FAKE_HOLDS:-/nowhere}" ]; do touch "$FAKE_HOLDS.begun"; sleep 0.05; done
    if [ -e broken ]; then echo "x.cpp:1: error: broken" >&2; exit 1; fi; mkdir -p "$2/bin" && cat number >"$2/bin/replay_plain" ;;
esac
"""


class ProgramsTest(fakes.Tree):
    def setUp(self) -> None:
        super().setUp()
        self.script("bin/cmake", CMAKE)
        self.git("init", "-q")
        self.commits = [self.commit("1"), self.commit("2", broken="yes"), self.commit("3")]

    def git(self, *words: str) -> str:
        command = ["git", "-c", "user.name=nobody", "-c", "user.email=nobody@example.org", *words]
        return subprocess.run(command, cwd=self.root, check=True, capture_output=True, text=True).stdout.strip()

    def commit(self, number: str, broken: str = "") -> str:
        (self.root / "number").write_text(number)
        (self.root / "broken").unlink(missing_ok=True)
        if broken:
            (self.root / "broken").write_text(broken)
        self.git("add", "-A", "number", *(["broken"] if broken or number == "3" else []))
        self.git("commit", "-qm", number)
        return self.git("rev-parse", "HEAD")[:12]

    def environment(self) -> dict[str, str]:
        return {"PATH": f"{self.root}/bin:{os.environ['PATH']}", "FAKE_LOG": str(self.root / "log")}

    def programs(self, *words: str, **environment: str) -> tuple[int, str, str]:
        return self.call("hil/farm/programs", *words, **self.environment(), **environment)

    def test_the_table_has_the_oldest_commit_first_and_names_what_it_leaves_out(self) -> None:
        code, _, complaints = self.programs(str(self.root / "set"), "--commits", "HEAD", "release")
        self.assertEqual(code, 3)
        self.assertIn(f"{self.commits[1]} is left out for release: x.cpp:1: error: broken", complaints)
        lines = [json.loads(line) for line in (self.root / "set/programs.jsonl").read_text().splitlines()]
        self.assertEqual([line["commit"] for line in lines], [self.commits[0], self.commits[2]])
        self.assertEqual([line["compiler"] for line in lines], ["GNU 1", "GNU 3"], "each is built as its own commit says")
        self.assertEqual([(self.root / "set" / line["command"][0]).read_text() for line in lines], ["1", "3"])

    def test_what_is_there_is_not_built_again(self) -> None:
        self.assertEqual(self.programs(str(self.root / "set"), "release")[0], 0)
        (self.root / "log").write_text("")
        self.assertEqual(self.programs(str(self.root / "set"), "release")[0], 0)
        self.assertEqual((self.root / "log").read_text(), "")

    def test_the_table_is_that_of_the_last_call_which_names_what_it_no_longer_lists(self) -> None:
        folder = self.root / "set"

        def listed() -> list[str]:
            return [json.loads(line)["commit"] for line in (folder / "programs.jsonl").read_text().splitlines()]

        first, _, last = self.commits
        for commits, lists, unlisted in (("-1 HEAD~2", [first], 0), ("-1 HEAD", [last], 1), ("HEAD", [first, last], 0)):
            _, _, complaints = self.programs(str(folder), "--commits", commits, "release")
            self.assertEqual(listed(), lists)
            self.assertEqual("that are not listed any more: 1; name all commits and presets in one call" in complaints, unlisted == 1, complaints)

    def test_of_two_at_once_each_stores_its_own_commit(self) -> None:
        held, folder = self.root / "held", self.root / "set"
        held.touch()
        with self.start("hil/farm/programs", str(folder), "--commits", "-1 HEAD~2", "release", **self.environment(), FAKE_HOLDS=str(held)) as first:
            self.assertTrue(fakes.appears(self.root / "held.begun"))
            with self.start("hil/farm/programs", str(folder), "release", **self.environment()) as second:
                assert second.stderr
                said = second.stderr.readline()
                held.unlink()
                first.communicate(timeout=60)
                second.communicate(timeout=60)
        self.assertEqual((first.returncode, second.returncode), (0, 0))
        for commit, number in ((self.commits[0], "1"), (self.commits[2], "3")):
            self.assertEqual((folder / commit / "release/replay_plain").read_text(), number)
        self.assertIn("another one builds", said)

    def test_a_tree_that_comes_to_another_commit_while_it_is_built_gives_no_program(self) -> None:
        code, _, complaints = self.programs(str(self.root / "set"), "release", FAKE_MOVES=self.commits[0])
        self.assertEqual(code, 1)
        self.assertIn(f"came to {self.commits[0]} while it was built", complaints)
        self.assertFalse((self.root / "set" / self.commits[2]).exists())

    def test_what_cannot_be_is_refused(self) -> None:
        self.assertEqual(self.programs(str(self.root / "set"), "amiga")[0], 2)
        code, _, complaints = self.programs(str(self.root / "set"), "--commits", "no-such-commit", "release")
        self.assertEqual(code, 1)
        self.assertIn("--commits 'no-such-commit'", complaints)
        self.assertFalse((self.root / "set/programs.jsonl").exists())


class CostTest(fakes.Tree):
    def cost(self, *words: str) -> tuple[int, str, str]:
        return self.call("hil/farm/cost", *words)

    def test_the_work_is_that_of_the_formula(self) -> None:
        code, said, _ = self.cost("--hours", "100", "--commits", "2", "--cores", "4", "--task-seconds", "0", "--shard-seconds", "0", "--speed", "a=1000")
        self.assertEqual(code, 0)
        hours = re.search(r"work (\d+) core-hours", said)
        assert hours
        self.assertTrue(200 <= int(hours[1]) <= 204, "a tick takes a millisecond, as long as it took the hand: two commits of a hundred hours")

    def test_numbers_that_are_none_are_refused(self) -> None:
        self.assertEqual(self.cost()[0], 1)
        self.assertEqual(self.cost("--speed", "a=fast")[0], 2)
        for speed in ("a=0", "a=nan", "a=-1", "a=inf"):
            self.assertEqual(self.cost("--speed", speed)[0], 1, speed)
        for option in ("--hours", "--mean-minutes", "--task-seconds", "--shard-seconds"):
            for number in ("inf", "nan", "-1"):
                code, _, complaints = self.cost("--speed", "a=1", option, number)
                self.assertEqual((code, complaints), (1, "hil/farm/cost: give at least one --speed, and finite numbers above 0\n"), f"{option} {number}")


if __name__ == "__main__":
    unittest.main()
