"""One run at a time in a folder of this checkout."""

from __future__ import annotations

import fcntl
import sys
from pathlib import Path
from typing import IO


def alone(script: str, folder: Path) -> IO[str]:
    """Waits until no other run uses the folder, since each would take the other's files away; none begins before the file is closed."""
    lock = (folder / "lock").open("w")
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        print(f"{script}: another run uses {folder}; waiting until it has ended", file=sys.stderr, flush=True)
        fcntl.flock(lock, fcntl.LOCK_EX)
    return lock
