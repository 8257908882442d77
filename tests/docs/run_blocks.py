#!/usr/bin/env python3
"""Runs the commands that the documents show, so that no page teaches a command that fails.

    run_blocks.py BIN ROOT [--page NAME]... [--jobs N] [--seconds N]

BIN is the folder of the programs, ROOT the folder that holds README.md and docs/. The blocks of one page that are marked ```sh run in their order, in one
shell and one empty folder; the shell stops at the first command that fails. A block that a desk cannot run is marked ```text, and the page says why.

Exit code 0: every block of every page succeeded. Exit code 1: a command failed or took too long, a page has no block to run, a block is not marked, or no
page was found. Each problem is one sentence that names the page and the line.
"""

from __future__ import annotations

import argparse
import os
import signal
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

RUN = "sh"
SHOWN = {"text", "toml", "csv", "json"}


class PageError(Exception):
    """What is wrong with a page, as one sentence without the page's name."""


@dataclass(frozen=True)
class Block:
    line: int  # of the opening fence, counted from 1
    language: str
    text: str


def blocks_of(page: str) -> list[Block]:
    """The fenced blocks of a page in their order; raises PageError for a block without a known mark, and for one that does not end."""
    blocks: list[Block] = []
    opened: tuple[int, str, int] | None = None  # line, language, indentation
    lines: list[str] = []
    for number, line in enumerate(page.splitlines(), start=1):
        stripped = line.strip()
        if opened is None:
            if not stripped.startswith("```"):
                continue
            language = stripped.removeprefix("```").strip()
            if language != RUN and language not in SHOWN:
                raise PageError(f"line {number}: this block is marked '{language}'; mark it {RUN} to have it run, or one of {', '.join(sorted(SHOWN))}")
            opened = (number, language, len(line) - len(line.lstrip()))
            lines = []
        elif stripped == "```":
            blocks.append(Block(opened[0], opened[1], "\n".join(lines) + "\n"))
            opened = None
        else:
            indentation = min(opened[2], len(line) - len(line.lstrip()))
            lines.append(line[indentation:])
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


def run_page(page: Path, programs: Path, seconds: float) -> int:
    """Runs the blocks of a page and returns how many they are; raises PageError when one of them fails, and when there is none."""
    blocks = [block for block in blocks_of(page.read_text(encoding="utf-8")) if block.language == RUN]
    if not blocks:
        raise PageError(f"there is no block marked {RUN}, so nothing of this page was tried")
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
    return len(blocks)


def pages_of(root: Path, names: list[str]) -> list[Path]:
    """README.md and every page of docs/, or those of them that are named."""
    pages = [page for page in [root / "README.md", *sorted((root / "docs").glob("*.md"))] if page.is_file()]
    return [page for page in pages if page.name in names] if names else pages


def main(arguments: list[str]) -> int:
    parser = argparse.ArgumentParser(description="Runs the commands that the documents show.")
    parser.add_argument("programs", type=Path, metavar="BIN", help="the folder of the programs")
    parser.add_argument("root", type=Path, metavar="ROOT", help="the folder that holds README.md and docs/")
    parser.add_argument("--page", action="append", default=[], metavar="NAME", help="only this page, such as safety.md; may be given several times")
    parser.add_argument("--jobs", type=int, default=2, help="pages that run at once, 2 unless given")
    parser.add_argument("--seconds", type=float, default=600, help="how long a page may take, 600 unless given")
    options = parser.parse_args(arguments)

    pages = pages_of(options.root, options.page)
    if not pages or len(pages) < len(options.page):
        print(f"{options.root}: no such page was found" if options.page else f"{options.root}: no page was found", file=sys.stderr)
        return 1

    def tried(page: Path) -> tuple[bool, str]:
        name, begin = page.relative_to(options.root), time.monotonic()
        try:
            count = run_page(page, options.programs.resolve(), options.seconds)
        except PageError as error:
            return False, f"{name}, {error}"
        return True, f"{name}: {count} blocks, {time.monotonic() - begin:.1f} s"

    failed = 0
    with ThreadPoolExecutor(max_workers=options.jobs) as pool:
        for good, sentence in pool.map(tried, pages):
            print(sentence, file=sys.stdout if good else sys.stderr, flush=True)
            failed += not good
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
