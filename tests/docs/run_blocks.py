#!/usr/bin/env python3
"""Runs the commands that the documents show, so that no page teaches a command that fails.

    run_blocks.py BIN ROOT [--page NAME]... [--jobs N] [--seconds N]

BIN is the folder of the programs, ROOT the project's folder. The blocks of one page that are marked ```sh run in their order, in one shell and one empty
folder; the shell stops at the first command that fails. A block that a desk cannot run, because it needs a device, root or an hour, is marked

    ```sh no-run REASON

and counted. Other blocks are shown only, and hold no commands: neither those marked ```text and the like, nor those that are indented without a fence.

Exit code 0: every block of every page succeeded. Exit code 1: a command failed or took too long, a page that is no page of prose has no block to run, a block
is not marked or hides commands, or no page was found. Each problem is one sentence that names the page and the line. The last line has the totals.
"""

from __future__ import annotations

import argparse
import os
import re
import signal
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

RUN = "sh"
NOT_RUN = "no-run"
SHOWN = {"text", "toml", "csv", "json", "yaml", "cmake", "ts"}
# Pages that have nothing to type in, or nothing that a desk can run without root. Every other page must have a block that runs.
PROSE = {"CHANGELOG.md", "CONTRIBUTING.md", "DECISIONS.md", "DESIGN.md", "GLOSSARY.md", "SECURITY.md", "docs/README.md", "docs/faq.md",
         "docs/boards-in-a-lab.md", "docs/install.md", "docs/stability.md",
         "host/page/src/touch/README.md", "host/python/README.md", "shared/SPEC.md"}
COMMAND = re.compile(r"\s*(\$ )?(sudo|apt(-get)?|cmake|ninja|pip3?|python3|systemctl|journalctl|qemu-\S+|\./dev|hil/\S+|(\S*/)?isotouch(ctl|d)?|(\S*/)?falcon-sim)\s+[-\w./]")


class PageError(Exception):
    """What is wrong with a page, as one sentence without the page's name."""


@dataclass(frozen=True)
class Block:
    line: int  # of the opening fence, counted from 1
    language: str
    text: str
    reason: str = ""  # why it is not run; empty if it is

    @property
    def runs(self) -> bool:
        return self.language == RUN and not self.reason


def mark_of(number: int, mark: str) -> tuple[str, str]:
    """Language of a block, and the reason why it is not run; raises PageError for another mark."""
    language, _, rest = mark.partition(" ")
    if language not in {RUN, *SHOWN} or (rest and language != RUN):
        raise PageError(f"line {number}: this block is marked '{mark}'; mark it {RUN} to have it run, or one of {', '.join(sorted(SHOWN))}")
    word, _, reason = rest.partition(" ")
    if rest and (word != NOT_RUN or not reason.strip()):
        raise PageError(f"line {number}: this block is marked '{mark}'; write '{RUN} {NOT_RUN} REASON' for a block that no test can run")
    return language, reason.strip()


def blocks_of(page: str) -> list[Block]:
    """The fenced blocks of a page in their order; raises PageError for a block without a known mark, one that does not end, and commands outside ```sh."""
    blocks: list[Block] = []
    opened: tuple[int, str, str, int] | None = None  # line, language, reason, indentation
    lines: list[str] = []
    before = ""
    for number, line in enumerate(page.splitlines(), start=1):
        stripped = line.strip()
        if opened is None:
            if stripped.startswith("```"):
                opened = (number, *mark_of(number, stripped.removeprefix("```").strip()), len(line) - len(line.lstrip()))
                lines = []
            elif line.startswith("    ") and (not before or before.startswith("    ")) and COMMAND.match(line):
                raise PageError(f"line {number}: a command is shown by indentation alone; put it into a block that is marked {RUN}")
        elif stripped == "```":
            blocks.append(Block(opened[0], opened[1], "\n".join(lines) + "\n", opened[2]))
            opened = None
        else:
            if opened[1] != RUN and COMMAND.match(line):
                raise PageError(f"line {number}: a command is in a block marked '{opened[1]}'; mark it {RUN}, or {RUN} {NOT_RUN} REASON")
            indentation = min(opened[3], len(line) - len(line.lstrip()))
            lines.append(line[indentation:])
        before = line
    if opened is not None:
        raise PageError(f"line {opened[0]}: this block does not end")
    return blocks


def script_of(blocks: list[Block], progress: Path) -> str:
    """One script of all blocks; it writes the line of each into the file `progress` before the block begins."""
    parts = ["set -euo pipefail"]
    for block in blocks:
        parts += [f"echo {block.line} >'{progress}'", block.text]
    return "\n".join(parts) + "\n"


def end_group(shell: subprocess.Popen[bytes]) -> None:
    """Ends the shell, if it still runs, and what it left in the background: politely, and by force after two seconds."""
    end = time.monotonic() + 2
    try:
        os.killpg(shell.pid, signal.SIGTERM)
        while time.monotonic() < end:
            shell.poll()
            os.killpg(shell.pid, 0)
            time.sleep(0.05)
        os.killpg(shell.pid, signal.SIGKILL)
    except ProcessLookupError:
        pass
    shell.wait()


def run_page(page: Path, prose: bool, programs: Path, seconds: float) -> tuple[int, list[Block]]:
    """Runs the blocks of a page; returns how many ran, and those that did not. Raises PageError when one of them fails, and when there is none."""
    every = blocks_of(page.read_text(encoding="utf-8"))
    blocks, left = [block for block in every if block.runs], [block for block in every if block.reason]
    if not blocks:
        if not prose:
            raise PageError(f"there is no block marked {RUN}, so nothing of this page was tried")
        return 0, left
    with tempfile.TemporaryDirectory(prefix="docs") as folder:
        room = Path(folder) / "room"
        room.mkdir()
        progress, said, script = Path(folder) / "line", Path(folder) / "said", Path(folder) / "script"
        script.write_text(script_of(blocks, progress), encoding="utf-8")
        environment = dict(os.environ, PATH=f"{programs}:{os.environ.get('PATH', '/usr/bin:/bin')}", HOME=str(room))
        with said.open("wb") as log:
            shell = subprocess.Popen(["bash", str(script)], cwd=room, env=environment, stdin=subprocess.DEVNULL, stdout=log, stderr=log, start_new_session=True)
            try:
                outcome = f"exit code {code}" if (code := shell.wait(timeout=seconds)) != 0 else ""
            except subprocess.TimeoutExpired:
                outcome = f"not done after {seconds:g} s"
            finally:
                end_group(shell)
        if outcome:
            tail = "\n".join("    " + line for line in said.read_text(encoding="utf-8", errors="replace").splitlines()[-30:])
            raise PageError(f"line {progress.read_text().strip() if progress.exists() else '?'}: this block failed, {outcome}; its last words:\n{tail}")
    return len(blocks), left


def pages_of(root: Path, names: list[str]) -> list[Path]:
    """Every page of the project, or those of them that are named; what is built or hidden is none of it."""
    pages = [page for page in sorted(root.rglob("*.md")) if not any(part == "build" or part.startswith(".") or part == "node_modules"
                                                                    for part in page.relative_to(root).parts)]
    return [page for page in pages if page.name in names or page.relative_to(root).as_posix() in names] if names else pages


def main(arguments: list[str]) -> int:
    parser = argparse.ArgumentParser(description="Runs the commands that the documents show.")
    parser.add_argument("programs", type=Path, metavar="BIN", help="the folder of the programs")
    parser.add_argument("root", type=Path, metavar="ROOT", help="the project's folder")
    parser.add_argument("--page", action="append", default=[], metavar="NAME", help="only this page, such as safety.md; may be given several times")
    parser.add_argument("--jobs", type=int, default=2, help="pages that run at once, 2 unless given")
    parser.add_argument("--seconds", type=float, default=600, help="how long a page may take, 600 unless given")
    options = parser.parse_args(arguments)

    pages = pages_of(options.root, options.page)
    if not pages or len(pages) < len(options.page):
        print(f"{options.root}: no such page was found" if options.page else f"{options.root}: no page was found", file=sys.stderr)
        return 1

    def tried(page: Path) -> tuple[int, list[Block] | None, str]:
        name, begin = page.relative_to(options.root).as_posix(), time.monotonic()
        try:
            ran, left = run_page(page, name in PROSE, options.programs.resolve(), options.seconds)
        except PageError as error:
            return 0, None, f"{name}, {error}"
        reasons = "".join(f"\n    line {block.line} not run: {block.reason}" for block in left)
        return ran, left, f"{name}: {ran} blocks, {time.monotonic() - begin:.1f} s{reasons}"

    blocks = not_run = failed = 0
    with ThreadPoolExecutor(max_workers=options.jobs) as pool:
        for ran, left, sentence in pool.map(tried, pages):
            print(sentence, file=sys.stderr if left is None else sys.stdout, flush=True)
            blocks, not_run, failed = blocks + ran, not_run + len(left or []), failed + (left is None)
    print(f"{len(pages)} pages: {blocks} blocks ran, {not_run} are marked {NOT_RUN}, {failed} pages failed", flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
