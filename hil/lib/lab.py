"""A board in a lab, as labgrid reaches it: its place, its power switch, the relay in the motors' enable line, its serial line, and what it boots from."""

from __future__ import annotations

import importlib
import logging
import os
import re
import subprocess
import sys
import threading
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any, TypeVar

ROOT = Path(__file__).resolve().parents[2]
LABGRID = ROOT / "build/lab/labgrid/usr"   # what hil/lab/labgrid unpacks
PACKAGES = LABGRID / "lib/python3/dist-packages"
Answer = TypeVar("Answer")


class LabError(Exception):
    """What is wrong with the lab and what to do, as one sentence."""


def program(name: str) -> list[str]:
    """A program of labgrid."""
    return ["env", f"PYTHONPATH={PACKAGES}", "/usr/bin/python3", str(LABGRID / "bin" / name)]


def client(coordinator: str, *command: str) -> tuple[int, str]:
    """Exit code of labgrid's client, and what it printed."""
    done = subprocess.run([*program("labgrid-client"), "-x", coordinator, *command], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True, check=False)
    return done.returncode, done.stdout


def in_one_line(text: object) -> str:
    """An exception, or what a program printed."""
    return " ".join(str(text).split()).rstrip(".")[:300] or type(text).__name__


class Place:
    """One board, ours while the block lasts. It is left without power if its switch was touched, else as it was found.

    file      an environment of labgrid, whose target `main` has the drivers: see docs/boards-in-a-lab.md
    """

    def __init__(self, file: Path) -> None:
        self.file = file
        self.acquired = self.touched = False
        self.environment: Any = None

    def __enter__(self) -> Place:
        try:
            self._open()
        except BaseException:
            self._release()
            raise
        return self

    def __exit__(self, kind: object, reason: BaseException | None, _: object) -> None:
        try:
            if self.touched:
                self._switch(False)
        except LabError as error:
            if not isinstance(reason, LabError):
                raise
            if str(error) != str(reason):
                raise LabError(f"{reason}; and {error}") from reason
        finally:
            self._release()

    # ---- the place ------------------------------------------------------------------------------------------------------------------

    def _open(self) -> None:
        if not self.file.is_file():
            raise LabError(f"{self.file}: there is no such file; name a labgrid environment, such as the one in docs/boards-in-a-lab.md")
        sys.path.insert(0, str(PACKAGES))
        logging.getLogger().setLevel(logging.CRITICAL)   # what labgrid says of trouble is in the exception, too
        threading.excepthook = lambda _: None   # and what a thread of its serial line says
        try:
            self.environment = importlib.import_module("labgrid").Environment(str(self.file))
        except ImportError as error:
            raise LabError(f"labgrid cannot be loaded ({in_one_line(error)}); ./dev hil 5 installs it") from error
        except Exception as error:
            raise LabError(f"{self.file}: not an environment of labgrid: {in_one_line(error)}") from error
        config = self.environment.config
        main = (config.get_targets() or {}).get("main")
        if not isinstance(main, dict):
            raise LabError(f"{self.file}: there is no target 'main'; describe the board under 'targets: main:'")
        self.name = self._place_of(main)
        self.board: str = (main.get("options") or {}).get("board", "arm64")
        self.console_name: str = (main.get("options") or {}).get("console", "ttyAMA0")
        if self.name:
            self.coordinator: str = config.get_option("coordinator_address", os.environ.get("LG_COORDINATOR", "127.0.0.1:20408"))
            self._acquire()
        self.who = f"'{self.name or 'main'}'"
        try:
            self.target = self.environment.get_target("main")
        except Exception as error:
            raise LabError(f"{self.file}: {in_one_line(error)}") from error
        self.power = self._driver("PowerProtocol", "a power switch", "NetworkPowerDriver")
        self.console = self._driver("ConsoleProtocol", "a serial line", "SerialDriver")
        self.files = self._driver("TFTPProviderDriver", "a folder to boot from", "TFTPProviderDriver")
        self.motors = self._driver("DigitalOutputProtocol", "", "", name="motors") if "motors" in self._names(main) else None

    @staticmethod
    def _place_of(main: dict[str, Any]) -> str:
        """The name of the remote place; empty where all wires end at this machine."""
        resources = main.get("resources") or {}
        each = resources if isinstance(resources, list) else [{name: values} for name, values in resources.items()]
        return next((str((entry["RemotePlace"] or {}).get("name", "")) for entry in each if "RemotePlace" in entry), "")

    @staticmethod
    def _names(main: dict[str, Any]) -> set[str]:
        """The names that the file gives to drivers."""
        drivers = main.get("drivers") or {}
        each = drivers if isinstance(drivers, list) else [{kind: values} for kind, values in drivers.items()]
        return {str(values["name"]) for entry in each for values in entry.values() if isinstance(values, dict) and "name" in values}

    def _acquire(self) -> None:
        code, said = client(self.coordinator, "-p", self.name, "acquire")
        if code == 0:
            self.acquired = True
            return
        if "matches nothing" in said or "not found" in said:
            raise LabError(f"the coordinator at {self.coordinator} has no place '{self.name}'; 'labgrid-client places' lists those it has")
        if "already acquired" in said:
            holder = re.search(r"acquired by (\S+?)\.?(\s|$)", said)
            raise LabError(f"the place '{self.name}' is taken by " + (f"{holder[1]}; wait until it is released there" if holder else
                           f"yourself; if nothing of yours uses it, release it with 'labgrid-client -p {self.name} release'"))
        if "connect" in said.lower():
            raise LabError(f"no coordinator of labgrid answers at {self.coordinator}; correct coordinator_address in {self.file}, or start labgrid-coordinator there")
        raise LabError(f"the place '{self.name}' cannot be had: {in_one_line(said)}")

    def _release(self) -> None:
        if self.environment is not None:
            try:
                self.environment.cleanup()
            except Exception as error:   # the place is to be released whatever a driver says
                print(f"hil: {self.file}: {in_one_line(error)}", file=sys.stderr)
        if self.acquired:
            self.acquired = False
            client(self.coordinator, "-p", self.name, "release")

    def _driver(self, protocol: str, what: str, example: str, name: str | None = None) -> Any:
        try:
            return self.target.get_driver(protocol, name=name)
        except Exception as error:
            absent = re.findall(r"name='([^']*)', state=", str(error)) if "Not all resources are available" in str(error) else []
            advice = (f"plug in what the exporter does not have now: {' '.join(absent)}" if absent else
                      f"add a driver such as {example}" if "NoDriver" in type(error).__name__ else in_one_line(error))
            raise LabError(f"{self.file}: {what or f'driver {name}'} for {self.who} cannot be used; {advice}") from error

    # ---- its wires ------------------------------------------------------------------------------------------------------------------

    def _ask(self, what: str, wire: Callable[[], Answer]) -> Answer:
        try:
            return wire()
        except Exception as error:
            raise LabError(f"{what}: {in_one_line(error)}") from error

    def _switch(self, on: bool) -> None:
        level = "on" if on else "off"
        trouble = f"the power switch did not turn {self.who} {level}" + ("" if on else "; turn it off by hand")
        self._ask(trouble, self.power.on if on else self.power.off)
        if hasattr(self.power, "get") and self._ask(trouble, self.power.get) != on:
            raise LabError(f"{trouble}: it says that the board is {'off' if on else 'on'}")

    def open_motors(self) -> None:
        """Opens the relay in the motors' enable line, if the lab has one: whatever a scenario does, no real device gets force."""
        if self.motors is None:
            return
        trouble = f"the relay in the motors' enable line of {self.who} did not open"
        self._ask(trouble, partial(self.motors.set, False))
        if self._ask(trouble, self.motors.get):
            raise LabError(f"{trouble}: it says that it is closed")

    def stage(self, files: list[Path]) -> None:
        """Puts the files where the board boots from, each by its own name."""
        for file in files:
            self._ask(f"{file.name} cannot be put where {self.who} boots from", partial(self._link, file))

    def _link(self, file: Path) -> None:
        if self.files.provider.host == "localhost":   # labgrid replaces a link on another machine, but not here
            link = Path(self.files.provider.internal) / file.name
            if link.is_symlink():
                link.unlink()
        self.files.stage(str(file))

    def restart(self) -> None:
        """Turns the board off and on again."""
        self.touched = True
        self._switch(False)
        time.sleep(getattr(self.power, "delay", 2.0))
        self._switch(True)

    def listen(self, log: Path, until: str, silence: float, limit: float) -> str:
        """Writes what the board says into the log until a line matches, and returns the match's first group.

        silence   so many seconds without a letter after the power came on mean that nobody speaks
        limit     so many seconds are the most that the board may take
        """
        begin, said, pattern = time.monotonic(), b"", re.compile(until.encode())
        with open(log, "wb") as out:
            while (elapsed := time.monotonic() - begin) < (limit if said else silence):
                more = self._hear(1.0)
                out.write(more)
                out.flush()
                tail, said = said[-200:], said + more
                if more and (found := pattern.search(tail + more)):
                    return found[1].decode()
        if not said:
            raise LabError(f"the board {self.who} said nothing on its serial line for {elapsed:.0f} s after it was turned on; "
                           f"check the line, its speed, and that the board has power")
        raise LabError(f"the board {self.who} did not end its scenario within {limit:.0f} s; {log} has what it said")

    def _hear(self, seconds: float) -> bytes:
        try:
            return bytes(self.console.read(size=1, timeout=seconds))
        except Exception as error:
            if type(error).__name__ == "TIMEOUT":
                return b""
            raise LabError(f"the serial line of {self.who} was lost: {in_one_line(error)}") from error
