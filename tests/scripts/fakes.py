"""Programs that stand in for ours, so that a script of hil/ can be tried in a second and any of its children can fail.

FAKE_FAILS names the one that fails after its work, by its program or by a command of the tool; FAKE_STATUS is JSON that replaces values of the controller's status;
FAKE_GAP makes the followed ticks miss one; FAKE_CALLS is what strace sees.
"""

from __future__ import annotations

import importlib.util
import os
import subprocess
import sys
import tempfile
from importlib.machinery import SourceFileLoader
from pathlib import Path
from types import ModuleType

ROOT = Path(__file__).resolve().parents[2]
PROGRAMS = ("isotouch", "isotouchd", "falcon-sim", "strace", "cyclictest")
CALLS = "futex(0x1, FUTEX_WAIT_BITSET_PRIVATE|F, 1) = 0\nfutex(0x1, FUTEX_WAKE_PRIVATE, 1) = 1\nclock_nanosleep(CLOCK_MONOTONIC, 0) = 0\n"


def load(script: str) -> ModuleType:
    """A script of hil/ as a module; its name has no ending."""
    path = ROOT / "hil" / script
    sys.path.insert(0, str(ROOT / "hil"))
    loader = SourceFileLoader(script.replace("/", "_"), str(path))
    spec = importlib.util.spec_from_loader(loader.name, loader)
    assert spec
    module = sys.modules[loader.name] = importlib.util.module_from_spec(spec)
    loader.exec_module(module)
    return module


def run(script: str, *arguments: str, **environment: str) -> tuple[int, str]:
    """Exit code, and everything that a script of hil/ prints, with the fakes for all that it starts. Every argument BIN is their folder."""
    with tempfile.TemporaryDirectory() as folder:
        for name in PROGRAMS:
            Path(folder, name).symlink_to(Path(__file__).resolve().parent / "fake_program")
        path = f"{folder}:{os.environ['PATH']}"
        command = [str(ROOT / "hil" / script), *(folder if word == "BIN" else word for word in arguments)]
        ended = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False, timeout=60,
                               env={**os.environ, "PATH": path, "TMPDIR": folder, "FAKE_CALLS": CALLS, **environment})
        left = [entry.name for entry in Path(folder).iterdir() if entry.name not in PROGRAMS]
    assert "Traceback" not in ended.stdout, ended.stdout
    return ended.returncode, ended.stdout + "".join(f"LEFT BEHIND: {name}\n" for name in left)
