#!/usr/bin/env python3
"""What run_blocks.py promises, tried on pages that are made here."""

from __future__ import annotations

import contextlib
import io
import re
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

sys.dont_write_bytecode = True  # nothing is left beside the sources
import run_blocks  # noqa: E402


class RunBlocksTest(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        (self.root / "docs").mkdir()

    def page(self, name: str, text: str) -> None:
        (self.root / name).write_text(text, encoding="utf-8")

    def run_all(self, *options: str) -> tuple[int, str]:
        """Exit code, and everything that was said."""
        said = io.StringIO()
        with contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
            code = run_blocks.main(["/nowhere", str(self.root), *options])
        return code, said.getvalue()

    def test_blocks_of_a_page_run_in_their_order_in_one_folder_and_one_shell(self) -> None:
        self.page("README.md", "```sh\necho one >file\nname=two\n```\nwords\n```sh\ntest $(cat file) = one\ntest $name = two\n```\n")
        self.assertEqual(self.run_all()[0], 0)

    def test_pages_do_not_see_each_other(self) -> None:
        self.page("README.md", "```sh\ntouch file\n```\n")
        self.page("docs/a.md", "```sh\ntest ! -e file\ntouch file\n```\n")
        self.page("docs/b.md", "```sh\ntest ! -e file\n```\n")
        code, said = self.run_all()
        self.assertEqual((code, said.count(" blocks, ")), (0, 3), said)
        self.assertIn("3 pages: 3 blocks ran, 0 are marked no-run, 0 pages failed", said)

    def test_a_command_that_fails_is_named_with_its_page_and_line(self) -> None:
        self.page("README.md", "```sh\ntrue\n```\n")
        self.page("docs/a.md", "words\n\n```sh\ntrue\n```\n```sh\necho because\nfalse\ntrue\n```\n")
        code, said = self.run_all()
        self.assertEqual(code, 1)
        self.assertIn("docs/a.md, line 6: this block failed, exit code 1", said)
        self.assertIn("because", said)

    def test_a_failure_within_a_pipe_counts(self) -> None:
        self.page("README.md", "```sh\nfalse | cat\n```\n")
        self.assertEqual(self.run_all()[0], 1)

    def test_a_page_without_a_block_to_run_fails(self) -> None:
        self.page("README.md", "```sh\ntrue\n```\n")
        self.page("docs/a.md", "words\n```text\nfalse\n```\n")
        code, said = self.run_all()
        self.assertEqual(code, 1)
        self.assertIn("docs/a.md, there is no block marked sh", said)

    def test_a_page_of_prose_needs_no_block_and_its_blocks_run_all_the_same(self) -> None:
        self.page("docs/faq.md", "words\n")
        self.assertEqual(self.run_all()[0], 0)
        self.page("docs/faq.md", "```sh\nfalse\n```\n")
        self.assertEqual(self.run_all()[0], 1)

    def test_a_block_that_cannot_run_is_left_out_and_counted_with_its_reason(self) -> None:
        self.page("README.md", "```sh\ntrue\n```\n```sh no-run needs a device\nfalse\n```\n")
        code, said = self.run_all()
        self.assertEqual(code, 0, said)
        self.assertIn("line 4 not run: needs a device", said)
        self.assertIn("1 blocks ran, 1 are marked no-run, 0 pages failed", said)

    def test_a_page_with_nothing_but_blocks_that_cannot_run_fails(self) -> None:
        self.page("docs/a.md", "```sh no-run needs root\nfalse\n```\n")
        self.assertIn("docs/a.md, there is no block marked sh", self.run_all()[1])

    def test_a_block_that_is_not_run_without_a_reason_fails(self) -> None:
        for mark in ("sh no-run", "sh no-run  ", "sh skip it", "text no-run needs root"):
            self.page("README.md", f"```sh\ntrue\n```\n```{mark}\nfalse\n```\n")
            code, said = self.run_all()
            self.assertEqual(code, 1, mark)
            self.assertIn("README.md, line 4: this block is marked", said)

    def test_a_command_outside_a_block_marked_sh_fails(self) -> None:
        for hidden in ("```text\nsudo apt install isotouch\n```\n", "words:\n\n    ./dev hil 2\n", "```text\nisotouch info scan.itf\n```\n",
                       "    one\n    hil/cases/run --instructions\n"):
            self.page("README.md", f"```sh\ntrue\n```\n\n{hidden}")
            code, said = self.run_all()
            self.assertEqual(code, 1, hidden)
            self.assertIn("a command is ", said)
        for shown in ("```text\nisotouch: a sentence\n```\n", "- words\n    isotouch info goes on\n", "    x = y\n"):
            self.page("README.md", f"```sh\ntrue\n```\n\n{shown}")
            self.assertEqual(self.run_all()[0], 0, shown)

    def test_pages_below_other_folders_run_too_but_not_what_is_built(self) -> None:
        (self.root / "hil").mkdir()
        (self.root / "build").mkdir()
        self.page("hil/README.md", "```sh\nfalse\n```\n")
        self.page("build/README.md", "```sh\nfalse\n```\n")
        code, said = self.run_all()
        self.assertEqual((code, said.count("README.md, ")), (1, 1), said)

    def test_no_page_fails(self) -> None:
        self.assertEqual(self.run_all(), (1, f"{self.root}: no page was found\n"))
        self.page("README.md", "```sh\ntrue\n```\n")
        self.assertEqual(self.run_all("--page", "docs.md")[0], 1)

    def test_a_block_without_a_known_mark_fails(self) -> None:
        for mark in ("", "bash", "shell"):
            self.page("README.md", f"```sh\ntrue\n```\n```{mark}\nfalse\n```\n")
            code, said = self.run_all()
            self.assertEqual(code, 1)
            self.assertIn("README.md, line 4: this block is marked", said)

    def test_a_block_that_does_not_end_fails(self) -> None:
        self.page("README.md", "```sh\ntrue\n")
        self.assertIn("line 1: this block does not end", self.run_all()[1])

    def test_a_block_in_a_list_loses_its_indentation(self) -> None:
        self.page("README.md", "1. words\n   ```sh\n   cat >file <<END\n   word\n   END\n   test $(cat file) = word\n   ```\n")
        self.assertEqual(self.run_all()[0], 0)

    def test_a_page_that_takes_too_long_fails(self) -> None:
        self.page("README.md", "```sh\nsleep 60\n```\n")
        code, said = self.run_all("--seconds", "0.5")
        self.assertEqual(code, 1)
        self.assertIn("not done after 0.5 s", said)

    def test_what_a_page_leaves_running_is_ended(self) -> None:
        note = self.root / "note"
        self.page("README.md", f"```sh\n(trap 'echo ended >{note}; exit' TERM; while true; do sleep 0.1; done) &\nsleep 0.3\n```\n")
        begin = time.monotonic()
        self.assertEqual(self.run_all()[0], 0)
        self.assertEqual(note.read_text(), "ended\n")
        self.assertLess(time.monotonic() - begin, 5)

    def test_a_loop_that_checks_fails_when_its_first_file_differs(self) -> None:
        """A reader's shell goes on after a command that fails, unlike the one that runs the pages."""
        pages = Path(__file__).parents[2] / "docs"
        blocks = [block for page in pages.glob("*.md") for block in run_blocks.blocks_of(page.read_text(encoding="utf-8"))]
        loops = [block.text for block in blocks if block.runs and re.search(r"^for .*--check", block.text, re.MULTILINE)]
        self.assertTrue(loops)
        for loop in loops:
            for differing, code in ((1, 1), (0, 0)):
                script = f"isotouch() {{ runs=$((${{runs:-0}} + 1)); test $runs -gt {differing}; }}\ntouch scan.itf felt.trace touched.trace\n{loop}"
                with tempfile.TemporaryDirectory() as folder:
                    self.assertEqual(subprocess.run(["bash", "-c", script], cwd=folder, check=False).returncode, code, loop)


if __name__ == "__main__":
    unittest.main()
