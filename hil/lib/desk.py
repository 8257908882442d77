"""A controller and, unless a real device is named, the simulated Falcon, in a folder of their own that goes with the script."""

from __future__ import annotations

import contextlib
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from lib import endings

SOAK_HZ = 10_000       # ticks a second that a soak asks for, the most that a controller takes
LAST_LINES = 100       # of its log that are shown when a script fails
PATIENCE = 90          # seconds until what must come counts as missing: thirty other programs may want the same processor
ASK_SECONDS = 120      # that a command of the host tool may take, unless the script says otherwise
MAX_GROWTH_KB = 256   # of the heap of a controller that is flat


class Failure(Exception):
    """Why the script cannot go on, as one clause."""


def within(seconds: float, condition: Callable[[], object]) -> bool:
    """Waits until the condition holds; returns False if it still does not after that many seconds."""
    end = time.monotonic() + seconds
    while not condition():
        if time.monotonic() >= end:
            return False
        time.sleep(0.05)
    return True


def whole_number(text: str, most: int = 1_000_000) -> int:
    """An argument of the command line, from 1 to most."""
    if text.isascii() and text.isdigit() and 1 <= int(text) <= most:
        return int(text)
    raise ValueError(text)


def thread_of(process: int, name: str) -> int:
    """The number of a process's thread, which a controller that listens already may still have to begin."""
    def called_so() -> list[int]:
        found = []
        for comm in Path(f"/proc/{process}/task").glob("*/comm"):
            with contextlib.suppress(FileNotFoundError, ProcessLookupError):   # it has ended meanwhile
                if comm.read_text() == f"{name}\n":
                    found.append(int(comm.parent.name))
        return found
    within(PATIENCE, called_so)
    threads = called_so()
    if len(threads) != 1:
        raise Failure(f"{len(threads)} threads are called {name}")
    return threads[0]


def gives_rights() -> bool:
    """Does this machine give a child real-time rights?"""
    wish = "import os; os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(3))"
    return subprocess.run([sys.executable, "-c", wish], stderr=subprocess.DEVNULL, check=False).returncode == 0


class Desk:
    """bin is the folder of the programs, room a short temporary folder: the path of a socket has at most 107 characters."""

    def __init__(self, programs: str) -> None:
        self.bin = Path(programs)
        self.room = Path(tempfile.mkdtemp())
        self.control = f"unix:{self.room}/control"
        self.started: list[subprocess.Popen[bytes]] = []
        self.simulated = False
        self.resumed = 0

    def __enter__(self) -> Desk:
        return self

    def __exit__(self, *_: object) -> None:
        try:
            self.end_controller()
        finally:
            shutil.rmtree(self.room, ignore_errors=True)

    def end_controller(self) -> None:
        """Ends the controller first, so that its last commands reach the device; then what was started with it. All must end in order."""
        bad = []
        for process in reversed(self.started):
            had_ended = process.poll() is not None   # the script judges that
            process.terminate()
            try:
                code = process.wait(30)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
                bad.append(f"{process.args!r} was killed, because it did not end within 30 s of SIGTERM")
            else:
                if code != 0 and not had_ended:
                    bad.append(f"{process.args!r} ended with {code} after SIGTERM")
        self.started.clear()
        if bad:
            sys.exit("; ".join(bad))

    def start(self, log: str, *command: str | Path) -> None:
        with open(self.room / log, "wb") as said:
            self.started.append(subprocess.Popen(command, stdout=said, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL))

    def start_controller(self, device: str, *options: str | Path, simulated: Sequence[str | Path] = ()) -> None:
        """device is usb, usb:SERIAL, or sim: the simulated Falcon, with these options too, and a hand that tours the object. Returns when it is homed."""
        what = f"{device}: pull the grip out as far as it goes, then push it in"
        self.simulated = device == "sim"
        if self.simulated:
            self.start("falcon.log", self.bin / "falcon-sim", "--socket", self.room / "falcon", "--hand", "tour", *simulated)
            self._await_socket("falcon", "the simulated Falcon")
            device, what = f"sim:{self.room}/falcon", "a simulated Falcon, booted with a synthetic image and homed by its hand"
        self.start("controller.log", self.bin / "isotouchd", "--device", device, "--control", self.room / "control", *options)
        self._await_socket("control", "the controller")
        print(f"controller    on {what}", flush=True)
        if not within(120, self.is_homed):
            raise Failure("the device was not homed")

    def _await_socket(self, name: str, who: str) -> None:
        ended = self.started[-1].poll
        if not within(PATIENCE, lambda: (self.room / name).is_socket() or ended() is not None) or ended() is not None:
            raise Failure(f"{who} did not start")

    def ask(self, *command: str | Path, timeout: float = 0) -> subprocess.CompletedProcess[str]:
        """The host tool's answer to a command, whatever its exit code. A command that hangs ends the script."""
        return subprocess.run([self.bin / "isotouch", *command], capture_output=True, text=True, check=False, timeout=timeout or ASK_SECONDS)

    def tell(self, what: str, *command: str | Path, timeout: float = 0) -> str:
        """What the host tool prints; a command that fails ends the script with `what` and the tool's own sentence."""
        answer = self.ask(*command, timeout=timeout)
        if answer.returncode != 0:
            raise Failure(f"{what}: {answer.stderr.strip() or f'exit code {answer.returncode}'}")
        return answer.stdout

    def json(self, command: str) -> dict[str, Any]:
        """A command of the host tool to the controller, answered in JSON."""
        answer: dict[str, Any] = json.loads(self.tell(f"isotouch {command}", command, "--to", self.control, "--json"))
        return answer

    def status(self) -> dict[str, Any]:
        return self.json("status")

    def is_in(self, *states: str) -> bool:
        """Is the controller in one of these states? One that does not answer is in none."""
        answer = self.ask("status", "--to", self.control, "--json")
        return answer.returncode == 0 and json.loads(answer.stdout).get("state") in states

    def upload(self, field: str | Path) -> str:
        return self.tell("an upload was refused", "upload", field, "--to", self.control)

    def is_homed(self) -> bool:
        """A simulated device that a busy machine made silent before, or late, is resumed."""
        if not self.is_in("fault"):
            return self.is_in("idle", "ready", "active", "hold")
        self.resume_after(self.status(), "late", "silent", "stopped")
        return False

    def is_felt(self) -> bool:
        """Does the hand feel the field? Where a busy machine's late ticks led to a fault, it is resumed. A recording that begins in a fault turns its reason
        into "stopped"."""
        status = self.status()
        self.resume_after(status, "late", "stopped")
        return bool(status["state"] == "active")

    def resume_after(self, status: dict[str, Any], *faults: str) -> None:
        """The simulated person resumes after these faults, which counts in `resumed`; a real person does so by hand."""
        if self.simulated and status["state"] == "fault" and set(faults) & set(status["faults"]):
            self.resumed += self.ask("resume", "--to", self.control).returncode == 0

    def await_touch(self) -> None:
        if not within(20, self.is_felt):
            raise Failure("the field was not felt")

    def thread(self, name: str) -> int:
        """The number of a thread of the controller."""
        return thread_of(self.started[-1].pid, name)

    def descriptors(self) -> list[str]:
        """What the controller has open."""
        found = []
        for entry in Path(f"/proc/{self.started[-1].pid}/fd").iterdir():
            with contextlib.suppress(FileNotFoundError):   # it was closed meanwhile
                found.append(os.readlink(entry))
        return sorted(found)

    def descriptors_at_rest(self) -> list[str]:
        """The same, once those are closed whose clients have gone."""
        before: list[str] = []
        while before != (before := self.descriptors()):
            time.sleep(0.5)
        return before

    def heap_kb(self) -> int:
        """What the controller has of memory for data."""
        found = re.search(r"^VmData:\s+(\d+)", Path(f"/proc/{self.started[-1].pid}/status").read_text(), re.MULTILINE)
        assert found
        return int(found[1])

    def controller_log(self) -> str:
        log = self.room / "controller.log"
        return log.read_text(errors="replace") if log.exists() else ""


def at_desk(name: str, programs: str, work: Callable[[Desk], None]) -> int:
    """The exit code of work: 1, with the controller's log, where it failed. A script that is ended ends what it started."""
    endings.on(lambda number, _: sys.exit(128 + number), signal.SIGTERM, signal.SIGHUP)
    with Desk(programs) as desk:
        try:
            work(desk)
        except (Failure, OSError, subprocess.TimeoutExpired) as failure:   # OSError: a program is missing
            said = desk.controller_log().splitlines(keepends=True)[-LAST_LINES:]
            print(f"{name}: {failure}; the controller said:\n{''.join(said)}", end="", file=sys.stderr)
            return 1
    return 0
