#!/usr/bin/env python3
"""What hil/cases/run promises, with a tool whose files say how they were made and whose hashes are those of the files."""

from __future__ import annotations

import json
import unittest

import fakes

# Every file holds the words that made it and what they read. FAKE_CORE turns the chain of each tick from FAKE_FROM on.
TOOL = r"""#!/usr/bin/env -S python3 -ES
import hashlib, json, os, pathlib, sys
words = sys.argv[1:]
if os.environ.get("FAKE_FAILS") == words[0]:
    sys.exit("it is meant to fail")
inputs = [word for word in words if "/" in word and os.path.exists(word)]
content = " ".join(word for word in words if "/" not in word) + "".join(pathlib.Path(name).read_text() for name in inputs)
def digest(text): return hashlib.sha256(text.encode()).hexdigest()[:16]
def chain(text, tick):
    core = os.environ.get("FAKE_CORE", "") if tick >= int(os.environ.get("FAKE_FROM", 0)) else ""
    return digest(text + core + str(tick))
if words[0] == "info":
    print(json.dumps({"hash": digest(pathlib.Path(words[1]).read_text() + os.environ.get("FAKE_FIELD", ""))}))
elif words[:2] == ["trace", "show"]:
    text = pathlib.Path(words[2]).read_text()
    print(json.dumps({"header": {"period_ns": 1000000}}) if "--header" in words else "\n".join(["chain"] + [chain(text, i) for i in range(32)]))
elif words[:2] == ["trace", "diff"]:
    print(json.dumps({"first_difference": {"tick": 20, "field": "output.force.x"}}))
    sys.exit(3)
elif "-o" in words:
    pathlib.Path(words[words.index("-o") + 1]).write_text(content)
else:
    text = pathlib.Path(words[-1]).read_text()
    print(json.dumps({"hash": chain(text, 31), "ticks": 32, "seconds": 0.016}))
"""
TABLE = """# What a case is
case,object,hand,mutations,device,image,trace,marks,limits,reason
ball,sphere --grid 20,press --ticks 32,jitter:3,,,,,,new
# between
packets,torus,tour --ticks 32,,libnifalcon late:2,,,,,new
real,data:owl.ply,tour,,,,,,,new
"""
COUNTS = """echo '{"stages": {"pose": {"worst": '${FAKE_POSE:-1000}', "worst_tick": 7}}}'\n"""


class CasesTest(fakes.Tree):
    def setUp(self) -> None:
        super().setUp()
        self.script("tool", "")
        (self.root / "tool").write_text(TOOL)
        (self.root / "hil/cases.csv").write_text(TABLE)
        self.script("hil/instructions/count", COUNTS)
        self.script("hil/instructions/same_compiler", "")

    def cases(self, *words: str, **environment: str) -> tuple[int, str, str]:
        return self.call("hil/cases/run", *words, ISOTOUCH=str(self.root / "tool"), **{"ISOTOUCH_DATA": "", **environment})

    def accept(self) -> None:
        for name in ("ball", "packets"):
            self.assertEqual(self.cases("--accept", name, "--reason", "first")[::2], (0, ""))

    def row(self, name: str) -> list[str]:
        return next(line for line in (self.root / "hil/cases.csv").read_text().splitlines() if line.startswith(name + ",")).split(",")

    def test_what_was_accepted_is_equal_and_counted(self) -> None:
        self.accept()
        code, said, complaints = self.cases()
        objects = [json.loads(line) for line in said.splitlines()]
        self.assertEqual([(each["case"], each.get("exit")) for each in objects], [("ball", 0), ("packets", 0), ("real", None)])
        self.assertEqual((code, complaints), (0, "cases: 2 compared, 1 skipped; the tool: 64 ticks in 0.032 s, 2 times real time\n"))
        for each in objects[:2]:
            self.assertEqual((each["trace_hash"], each["ticks"]), (self.row(each["case"])[6], 32))

    def test_a_core_that_answers_otherwise_is_found_to_the_tick(self) -> None:
        self.accept()
        code, _, complaints = self.cases("ball", FAKE_CORE="broken", FAKE_FROM="20")
        self.assertEqual(code, 3)
        self.assertRegex(complaints, r"ball on tool: hash \w{16} instead of \w{16}, first between ticks 20 and 21 .*--accept ball --reason WHY")
        self.assertEqual(self.cases("ball")[0], 0)   # keeps its trace
        self.assertIn("first in tick 20 in output.force.x", self.cases("ball", FAKE_CORE="broken", FAKE_FROM="20")[2])

    def test_another_field_is_named_before_the_ticks(self) -> None:
        self.accept()
        code, _, complaints = self.cases("ball", FAKE_CORE="broken", FAKE_FIELD="broken")
        self.assertEqual(code, 3)
        self.assertRegex(complaints, r"ball: the field is another, \w{16} instead of \w{16}")

    def test_a_case_that_was_never_accepted_is_not_equal(self) -> None:
        self.assertEqual(self.cases("ball")[0], 3)

    def test_accepting_changes_one_line_and_keeps_the_reason(self) -> None:
        self.accept()
        before = (self.root / "hil/cases.csv").read_text().splitlines()
        self.assertEqual(self.cases("--accept", "ball", "--reason", "softer, by intent", FAKE_CORE="other")[0], 0)
        after = (self.root / "hil/cases.csv").read_text().splitlines()
        self.assertEqual([i for i, pair in enumerate(zip(before, after)) if pair[0] != pair[1]], [2])
        self.assertEqual((len(after), self.row("ball")[9]), (len(before), "softer; by intent"))
        self.assertEqual(self.cases("ball", FAKE_CORE="other")[0], 0)

    def test_nothing_is_accepted_without_a_reason_a_change_a_case_or_its_data(self) -> None:
        self.accept()
        before = (self.root / "hil/cases.csv").read_text()
        for words, code, sentence in (
            (("--accept", "ball"), 2, "why does 'ball' differ?"),
            (("--accept", "ball", "--reason", "again"), 1, "there is nothing to accept"),
            (("--accept", "cube", "--reason", "x"), 2, "no case is called 'cube'"),
            (("--accept", "ball", "--reason", "two\nlines"), 1, "one line of text"),
            (("--accept", "real", "--reason", "x"), 1, "made of real data"),
        ):
            found = self.cases(*words)
            self.assertEqual(found[0], code, words)
            self.assertIn(sentence, found[2])
        self.assertEqual((self.root / "hil/cases.csv").read_text(), before)

    def test_a_recipe_that_changes_is_made_anew(self) -> None:
        self.accept()
        table = self.root / "hil/cases.csv"
        table.write_text(table.read_text().replace("jitter:3", "jitter:4"))
        self.assertEqual(self.cases("ball")[0], 3)

    def test_a_step_that_fails_fails_the_script(self) -> None:
        for step in ("shape", "build", "export", "trace", "replay", "info"):
            code, _, complaints = self.cases("ball", FAKE_FAILS=step)
            self.assertNotEqual(code, 0, step)
            self.assertIn("it is meant to fail", complaints)
        self.assertFalse((self.root / "build/cases/ball.key").exists() and self.cases("ball")[0] == 0)

    def test_a_program_that_is_not_there_is_no_equal_hash(self) -> None:
        self.accept()
        code, said, complaints = self.cases("--processor", "release", "ball")
        self.assertEqual((code, json.loads(said)["exit"]), (3, 127))
        self.assertIn("replay_plain", complaints)
        self.script("build/release/bin/replay_plain", "exit 0\n")   # says nothing
        self.assertEqual(self.cases("--processor", "release", "ball")[0], 3)
        self.script("build/release/bin/replay_plain", f"echo '{{\"hash\": \"{self.row('ball')[6]}\"}}'\nexit 3\n")   # its exit code counts too
        self.assertEqual(self.cases("--processor", "release", "ball")[0], 3)

    def test_patches_go_with_their_recording(self) -> None:
        (self.root / "kept").mkdir()
        for name in ("hand.trace", "hand.patches"):
            (self.root / "kept" / name).write_text(name)
        table = self.root / "hil/cases.csv"
        table.write_text(table.read_text() + "patched,sphere,kept/hand.trace,,,,,,,new\n")
        self.accept()
        self.assertEqual(self.cases("--accept", "patched", "--reason", "first")[0], 0)
        self.script("build/release/bin/replay_plain", f"echo \"$@\" >>{self.root}/words\necho '{{\"hash\": \"{self.row('patched')[6]}\"}}'\n")
        self.assertEqual(self.cases("--processor", "release", "patched")[0], 0)
        self.cases("--processor", "release", "ball")
        self.assertEqual((self.root / "words").read_text().splitlines(), ["build/cases/patched.itfi build/cases/patched.trace build/cases/patched.patches",
                                                                          "build/cases/ball.itfi build/cases/ball.trace"])
        self.assertEqual((self.root / "build/cases/patched.patches").read_text(), "hand.patches")
        answer = json.dumps({"hash": self.row("patched")[6], "first_difference": None})
        self.script("hil/webassembly/replay_in_browser", f"shift\nprintf '<%s>' \"$@\" >{self.root}/words\necho '{answer}'\necho '{answer}'\n")
        self.cases("--processor", "chromium", "ball", "patched")
        self.assertEqual((self.root / "words").read_text(), "<build/cases/ball.itfi><build/cases/ball.trace><>"
                         "<build/cases/patched.itfi><build/cases/patched.trace><build/cases/patched.patches>")
        for name in ("hand.trace", "hand.patches"):
            (self.root / "kept" / name).write_text("damaged")
            self.cases("patched")
            self.assertIn("damaged", (self.root / "build/cases" / name.replace("hand", "patched")).read_text())
        table.write_text(table.read_text().replace("kept/hand.trace", "tour --ticks 32"))
        self.cases("patched")
        self.assertFalse((self.root / "build/cases/patched.patches").exists())

    def test_a_browser_that_answers_wrongly_or_too_little_fails(self) -> None:
        self.accept()
        right = self.row("ball")[6]
        for answer, end, code, sentence in (
            (f'{{"hash": "{right}", "first_difference": null}}', 0, 0, ""),
            (f'{{"hash": "{right}", "first_difference": 5}}', 3, 3, ""),
            ('{"hash": "0000000000000001", "first_difference": null}', 0, 3, "hash 0000000000000001 instead of"),
            ("", 0, 3, "ball on chromium: the browser ended with 1"),
            ("", 1, 3, "ball on chromium: the browser ended with 1"),
        ):
            self.script("hil/webassembly/replay_in_browser", f"echo '{answer}'\nexit {end}\n")
            found = self.cases("--processor", "chromium", "ball")
            self.assertEqual(found[0], code, answer)
            self.assertIn(sentence, found[2])

    def test_the_worst_tick_lies_within_its_limits(self) -> None:
        self.accept()
        self.assertIn("ball has no limits", self.cases("--instructions", "ball")[2])
        table = self.root / "hil/cases.csv"
        row = self.row("ball")
        table.write_text(table.read_text().replace(",".join(row), ",".join([*row[:8], "pose:900-1021", row[9]])))
        for pose, code, sentence in (("1000", 0, ""), ("1022", 3, "takes 1022 instructions in tick 7, its limit is 1021"), ("899", 3, "fewer than its lower limit 900")):
            found = self.cases("--instructions", "ball", FAKE_POSE=pose)
            self.assertEqual(found[0], code, pose)
            self.assertIn(sentence, found[2])
        for limits, code, sentence in (
            ("words:1-9", 3, "stage pose has no limits"),
            ("pose:900-1021 words:1", 1, "'words:1' among the limits of 'ball' is not STAGE:LOWER-UPPER"),
            ("pose:900-1021 words:1-9", 3, "stage words has limits and is not counted"),
        ):
            table.write_text(table.read_text().replace(",".join(self.row("ball")), ",".join([*row[:8], limits, row[9]])))
            found = self.cases("--instructions", "ball", FAKE_POSE="1000")
            self.assertEqual(found[0], code, limits)
            self.assertIn(sentence, found[2])
        table.write_text(table.read_text().replace(" words:1-9", ""))
        self.script("hil/instructions/same_compiler", "exit 1\n")   # what another compiler built may take half as much again, and less
        for pose, code in (("899", 0), ("1531", 0), ("1532", 3)):
            self.assertEqual(self.cases("--instructions", "ball", FAKE_POSE=pose)[0], code, pose)
        self.script("hil/instructions/count", "exit 1\n")
        self.assertIn("ball cannot be counted on arm64", self.cases("--instructions", "ball")[2])

    def test_a_second_run_waits_until_the_first_has_ended(self) -> None:
        self.accept()
        said = self.wait_for_lock("build/cases", "cases", "hil/cases/run", "ball", ISOTOUCH=str(self.root / "tool"), ISOTOUCH_DATA="")
        self.assertEqual(json.loads(said)["exit"], 0)

    def test_a_table_with_a_cell_too_few_or_without_a_case_is_refused(self) -> None:
        table = self.root / "hil/cases.csv"
        table.write_text(TABLE.replace("jitter:3,", "jitter:3"))
        self.assertIn("has 9 cells instead of 10", self.cases()[2])
        table.write_text("# none\n")
        self.assertEqual(self.cases()[0], 1)


if __name__ == "__main__":
    unittest.main()
