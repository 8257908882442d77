"""The console of a board: what a scenario says there begins with "hil: "."""

from __future__ import annotations

import hashlib
import json
import re
from pathlib import Path
from typing import Any


class Console:
    def __init__(self, log: Path) -> None:
        self.bytes = log.read_bytes().replace(b"\r", b"")
        self.text = self.bytes.decode(errors="replace")
        self.lines = [line.removeprefix("hil: ") for line in self.text.splitlines() if line.startswith("hil: ")]

    def hash(self) -> str:
        return hashlib.sha256(self.bytes).hexdigest()[:16]

    def said(self, pattern: str) -> list[str]:
        """The first group of the pattern, or all of it where it has none, in each line that it fits as a whole."""
        found = (re.fullmatch(pattern, line) for line in self.lines)
        return [match[match.re.groups and 1] for match in found if match]

    def last(self, pattern: str) -> str | None:
        return next(iter(self.said(pattern)[::-1]), None)

    def statuses(self) -> list[dict[str, Any]]:
        """What `status --json` printed, each time that it was asked; nothing at all where a line of the kernel cut one of them."""
        text = "".join(line.removeprefix("status: ") for line in self.lines if line.startswith("status: "))
        decoder, found, at = json.JSONDecoder(), [], 0
        while (at := text.find("{", at)) >= 0:
            try:
                status, at = decoder.raw_decode(text, at)
            except ValueError:
                return []
            found.append(status)
        return found

    def ends(self, lines: int = 40) -> str:
        return "".join(line + "\n" for line in self.text.splitlines()[-lines:])
