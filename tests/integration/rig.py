"""The controller, the simulated Falcon and the tool in a folder of their own, for the scripts in which they meet.

Each script prints one line for everything that holds. The first thing that does not hold ends it with exit code 1, one sentence, the place in the script, and
the ends of all logs. A script that is ended shows the same, and so does one that takes so long that CTest is about to kill it.
"""

from __future__ import annotations

import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import traceback
from collections.abc import Callable, Sequence
from pathlib import Path
from types import FrameType
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "hil"))
from lib.desk import PATIENCE, Failure, gives_rights, thread_of, within  # noqa: E402

__all__ = ["PATIENCE", "RECORDING_ENDED", "SETTINGS", "Answer", "Controller", "Failure", "Process", "Rig", "check", "code_of", "gives_rights",
           "give_back_memory", "halt", "main", "resident_kb", "thread_of", "within"]

# A machine that runs tests is busy and gives no real-time rights: what is late there may be late for longer.
SETTINGS = "[loop]\npriority = 0\nexchange_priority = 0\nlock_memory = false\n[limits]\nhold_ms = 100\nfault_age_ms = 1000\n"

COMMAND_SECONDS = 300   # that a command may take: then it hangs
LONG_SECONDS = 350      # that a script may take before it shows its place: CTest kills it after 400 (CMakePresets.json), and whoever is killed shows nothing

Word = str | Path
Answer = subprocess.CompletedProcess[str]
Process = subprocess.Popen[bytes]


LEFT_OUT = 77   # the exit code that CTest counts as skipped
RECORDING_ENDED = 4   # the exit code of a controller whose recording ended before its run


def check(condition: object, sentence: str) -> None:
    if not condition:
        raise Failure(sentence)


def code_of(process: Process) -> int:
    """How a process ended; one that a signal killed has the signal's number, negative."""
    return process.wait(timeout=120)


def halt(process: Process) -> None:
    """Returns once it stands still: until then it may still answer."""
    process.send_signal(signal.SIGSTOP)
    os.waitid(os.P_PID, process.pid, os.WSTOPPED | os.WNOWAIT)


def give_back_memory() -> None:
    """For programs started from now on: the address sanitizer keeps what they free, so they would grow although they give everything back."""
    options = (os.environ.get("ASAN_OPTIONS"), "quarantine_size_mb=1", "thread_local_quarantine_size_kb=16")
    os.environ["ASAN_OPTIONS"] = ":".join(filter(None, options))


def resident_kb(process: Process) -> int:
    line = next(line for line in Path(f"/proc/{process.pid}/status").read_text().splitlines() if line.startswith("VmRSS"))
    return int(line.split()[1])


class Rig:
    """The folder, which is the current one as long as the script runs, and every process that was started in it."""

    def __init__(self, emulator: Sequence[str] = ()) -> None:
        self.folder = Path(tempfile.mkdtemp())   # short: the path of a socket has at most 107 characters
        self.emulator = list(emulator)
        self.processes: list[Process] = []
        self.left_out = False
        os.chdir(self.folder)

    def leave_out(self, what: str) -> None:
        """A part that this machine does not allow. The script then ends with LEFT_OUT, unless something else fails."""
        print(f"left out: {what}")
        self.left_out = True

    def clear(self) -> None:
        for process in self.processes:
            process.kill()
            process.wait()
        os.chdir("/")
        shutil.rmtree(self.folder, ignore_errors=True)

    def run(self, *command: Word, **environment: str) -> Answer:
        return subprocess.run([*self.emulator, *map(str, command)], stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False,
                              timeout=COMMAND_SECONDS, env={**os.environ, **environment})

    def done(self, sentence: str, *command: Word, **environment: str) -> str:
        """What a command prints that must end with 0; else the sentence, and what it says."""
        answer = self.run(*command, **environment)
        check(answer.returncode == 0, f"{sentence}: exit code {answer.returncode}, {answer.stdout[-2000:]}{answer.stderr[-2000:]}")
        return answer.stdout

    def start(self, log: str, *command: Word, out: str = "", own_group: bool = False, **environment: str) -> Process:
        """The log takes both outputs of the process; `out`, where it is named, the standard one."""
        with open(log, "ab") as said, open(out or os.devnull, "wb") as printed:
            process = subprocess.Popen([*self.emulator, *map(str, command)], stdin=subprocess.DEVNULL, stdout=printed if out else said, stderr=said,
                                       start_new_session=own_group, env={**os.environ, **environment})
        self.processes.append(process)
        return process

    def start_falcon(self, program: Word, *options: str) -> Process:
        process = self.start("falcon.log", program, "--socket", self.folder / "falcon", *options)
        check(within(PATIENCE, Path("falcon").is_socket), "the simulated Falcon does not listen")
        return process

    def end_falcon(self, process: Process, how: signal.Signals = signal.SIGTERM) -> None:
        process.send_signal(how)
        code_of(process)
        Path("falcon").unlink(missing_ok=True)


def value_in(status: dict[str, Any], name: str) -> Any:
    """Of an object within objects by its path, as "field.hash"; None where there is none."""
    found: Any = status
    for part in name.split("."):
        found = found.get(part) if isinstance(found, dict) else None
    return found


class Controller:
    """isotouchd with its socket, and the tool that talks to it, where a script wants one."""

    def __init__(self, rig: Rig, daemon: Word, client: Word = "") -> None:
        self.rig, self.daemon, self.client = rig, daemon, client
        self.to = f"unix:{rig.folder}/control"

    def start(self, *options: Word) -> None:
        Path("control").unlink(missing_ok=True)
        self.process = self.rig.start("daemon.log", self.daemon, "--config", "config.toml", "--device", f"sim:{self.rig.folder}/falcon", "--control",
                                      self.rig.folder / "control", *options)
        within(PATIENCE, lambda: Path("control").is_socket() or self.process.poll() is not None)
        check(Path("control").is_socket(), f"the controller does not listen; its exit code is {self.process.poll()}")

    def ended(self, how: signal.Signals = signal.SIGTERM) -> int:
        """The code that it ends with."""
        self.process.send_signal(how)
        return code_of(self.process)

    def end(self, how: signal.Signals = signal.SIGTERM, wanted: int = 0) -> None:
        code = self.ended(how)
        check(code != RECORDING_ENDED or code == wanted, f"the recording ended before the run: {self.end_of_recording()}")
        check(code == (-how if how in (signal.SIGKILL, signal.SIGSEGV) else wanted), f"the controller ends with {code} after {how.name}")

    def end_of_recording(self) -> str:
        """Why, as the log says it; empty where it says nothing."""
        return "".join(re.findall(r" ticks recorded; (.*)", self.log())[-1:])

    @staticmethod
    def log() -> str:
        return Path("daemon.log").read_text(errors="replace")

    def tool(self, *command: Word) -> Answer:
        return self.rig.run(self.client, *command, "--to", self.to)

    def ask(self, sentence: str, *command: Word) -> str:
        return self.rig.done(sentence, self.client, *command, "--to", self.to)

    def status(self) -> dict[str, Any]:
        """Empty where nobody answers."""
        answer = self.tool("status", "--json")
        return dict(json.loads(answer.stdout)) if answer.returncode == 0 else {}

    def value(self, name: str) -> Any:
        return value_in(self.status(), name)

    def wait_for(self, name: str, value: object) -> None:
        """Until the status has this value. A fault that only says that the machine was busy is resumed meanwhile."""
        status: dict[str, Any] = {}

        def has_come() -> bool:
            nonlocal status
            status = self.status()
            if value_in(status, name) == value:
                return True
            if status.get("faults") == ["late"]:
                self.tool("resume")
            return False
        check(within(PATIENCE, has_come), f"{name} is not {value} but {value_in(status, name)}")

    def refuses(self, words: str, *command: Word, to: str | None = None) -> None:
        """A command that must end with exit code 1 and one sentence that holds these words."""
        answer = self.rig.run(self.client, *command, "--to", to or self.to)
        check(answer.returncode == 1 and answer.stderr.count("\n") == 1 and words in answer.stderr,
              f"exit code {answer.returncode} from {' '.join(map(str, command))}: {answer.stderr}")


def main(name: str, work: Callable[[Rig], None], emulator: Sequence[str] = ()) -> int:
    rig = Rig(emulator)

    def show(sentence: str, place: str) -> None:
        print(f"{name}: {sentence}\n{place}", end="", file=sys.stderr)
        for log in sorted(rig.folder.glob("*.log")):
            print(f"==> {log.name}\n" + "\n".join(log.read_text(errors="replace").splitlines()[-30:]), file=sys.stderr)
        sys.stderr.flush()

    def ended(*_: object) -> None:
        raise Failure("it was ended by SIGTERM")

    def takes_long(_: int, frame: FrameType | None) -> None:
        show(f"still at work after {LONG_SECONDS} s", "".join(traceback.format_stack(frame)))

    signal.signal(signal.SIGTERM, ended)
    signal.signal(signal.SIGALRM, takes_long)
    signal.alarm(LONG_SECONDS)
    try:
        work(rig)
    except Exception as failure:   # whatever it is: the logs say why
        show(f"{type(failure).__name__}: {failure}", traceback.format_exc())
        return 1
    finally:
        rig.clear()
    return LEFT_OUT if rig.left_out else 0
