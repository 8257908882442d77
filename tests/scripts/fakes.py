"""Programs that stand in for ours, so that a script of hil/ can be tried in a second and any of its children can fail.

FAKE_FAILS names the one that fails after its work, by its program or by a command of the tool; FAKE_CRASHES one that crashes once it is told to end; FAKE_STATUS is
JSON that replaces values of the controller's status; FAKE_GROWS names a count of it that grows; FAKE_GAP makes the followed ticks miss one, FAKE_TICKS is their
state; FAKE_CALLS is what strace sees; FAKE_PRIORITY is that of the tick's thread.
"""

from __future__ import annotations

import fcntl
import importlib.util
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from importlib.machinery import SourceFileLoader
from pathlib import Path
from types import ModuleType

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "hil"))   # where its scripts find their lib
PROGRAMS = ("isotouch", "isotouchd", "falcon-sim", "strace", "cyclictest")
SLEEPS = "sleep 30 & echo $! >child\nwait\n"   # in a Tree's root, see Tree.interrupt
CALLS = "futex(0x1, FUTEX_WAIT_BITSET_PRIVATE|F, 1) = 0\nfutex(0x1, FUTEX_WAKE_PRIVATE, 1) = 1\nclock_nanosleep(CLOCK_MONOTONIC, 0) = 0\n"


def load(script: str) -> ModuleType:
    """A script of hil/ as a module; its name has no ending."""
    path = ROOT / "hil" / script
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


def appears(file: Path, seconds: float = 20) -> bool:
    """Waits for a file."""
    end = time.monotonic() + seconds
    while not file.exists() and time.monotonic() < end:
        time.sleep(0.05)
    return file.exists()


class Tree(unittest.TestCase):
    """A copy of the scripts in a folder of its own, in which everything that they start can be replaced."""

    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        shutil.copytree(ROOT / "hil/lib", self.root / "hil/lib", ignore=shutil.ignore_patterns("__pycache__"))
        for name in ("run", "desk/run", "mutants/run", "cases/run", "instructions/ceilings", "rig/run", "outside/run", "lab/run", "bare_metal/run", "farm/programs", "farm/cost"):
            (self.root / "hil" / name).parent.mkdir(exist_ok=True)
            shutil.copy(ROOT / "hil" / name, self.root / "hil" / name)

    def script(self, path: str, text: str) -> None:
        file = self.root / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text("#!/bin/sh\n" + text)
        file.chmod(0o755)

    def start(self, *command: str, **environment: str) -> subprocess.Popen[str]:
        return subprocess.Popen([self.root / command[0], *command[1:]], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                env={**os.environ, **environment})

    def interrupt(self, how: signal.Signals, *command: str, **environment: str) -> int:
        """The exit code of a script that gets a signal once a program that it started has begun SLEEPS; what sleeps then must end, too."""
        file = self.root / "child"
        file.unlink(missing_ok=True)
        with self.start(*command, **environment) as process:
            while not file.exists() or not file.read_text():
                self.assertIsNone(process.poll(), "nothing sleeps")
                time.sleep(0.05)
            process.send_signal(how)
            process.communicate(timeout=20)
        stat = Path("/proc", file.read_text().strip(), "stat")
        end = time.monotonic() + 5
        while runs := stat.exists() and stat.read_text().split()[2] != "Z":
            if time.monotonic() > end:
                break
            time.sleep(0.05)
        self.assertFalse(runs, f"what it started still runs after {how.name}")
        return process.returncode

    def wait_for_lock(self, folder: str, name: str, *command: str, **environment: str) -> str:
        """What a script prints that must wait until another run has ended, and then end well."""
        with (self.root / folder / "lock").open("w") as first:
            fcntl.flock(first, fcntl.LOCK_EX)
            with self.start(*command, **environment) as second:
                assert second.stderr
                self.assertEqual(second.stderr.readline(), f"{name}: another run uses {folder}; waiting until it has ended\n")
                with self.assertRaises(subprocess.TimeoutExpired):
                    second.wait(timeout=1)
                fcntl.flock(first, fcntl.LOCK_UN)
                said, _ = second.communicate(timeout=60)
        self.assertEqual(second.returncode, 0)
        return said

    def call(self, *command: str, **environment: str) -> tuple[int, str, str]:
        """Exit code, output, complaints."""
        with self.start(*command, **environment) as process:
            said, complaints = process.communicate(timeout=60)
        self.assertNotIn("Traceback", complaints)
        return process.returncode, said, complaints
