"""What a scenario's console says of its run on a board: the same on the virtual board (rig/run) and on a board in a lab (lab/run)."""

from __future__ import annotations

import subprocess
from pathlib import Path

from lib.console import Console
from lib.outcome import Outcome

RIG = Path(__file__).resolve().parents[1] / "rig"


def head(scenario: str, key: str, default: str) -> str:
    """What the scenario asks for, see rig/head."""
    return subprocess.run([RIG / "head", scenario, key, default], stdout=subprocess.PIPE, text=True, check=True).stdout.strip()


def outcome_of(console: Console, rung: int, scenario: str, seed: int, code: int, equal: bool | None, seconds: int) -> Outcome:
    """code: that of the board. The outcome has it, or 3: not the same twice; 4: ticks came late, or no status was printed; 6: the scenario did not come to its
    end."""
    statuses = console.statuses()   # of all controllers, one after the other
    late = sum(int(status["late"]) for status in statuses) if statuses else None
    ticks = sum(int(status["ticks"]) for status in statuses) if statuses else None
    if ticks is None and (replayed := console.last(r'trace .*"ticks": ([0-9]+).*')):   # no controller
        ticks = int(replayed)
    if code == 0:
        if equal is False:
            code = 3
        elif not console.said("done"):   # a machine that was ended from outside says 0
            code = 6
        elif str("null" if late is None else late) != head(scenario, "late", "0"):
            code = 4
    return Outcome(rung, scenario, seed, code, ticks, late, console.last(r'trace .*"hash": "([0-9a-f]+)".*'), console.hash(),
                   max(map(int, console.said(r"zero .* ticks ([0-9]+)")), default=None), int(console.last(r"cases: [0-9]+ compared, ([0-9]+) skipped.*") or 0),
                   seconds, equal)
