"""Stands in for labgrid in lab_test.py: an environment whose wires write into a file what is done to them, and any of which can fail.

FAKE_EVENTS is that file, FAKE_CONSOLE what the board says once it is on; FAKE_BREAKS names a wire and what it does: "power on fails", "power on lies",
"power off fails", "last power off fails", "motors fails", "motors lies", "serial fails".
"""

from __future__ import annotations

import json
import os
from pathlib import Path
from types import SimpleNamespace
from typing import Any


class NoDriverFoundError(Exception):
    pass


class TIMEOUT(Exception):
    pass


def record(event: str) -> None:
    with open(os.environ["FAKE_EVENTS"], "a") as events:
        events.write(event + "\n")


def breaks(wire: str) -> bool:
    return os.environ.get("FAKE_BREAKS") == wire


class Switch:
    """A power switch, or a relay."""

    delay = 0.0

    def __init__(self, name: str) -> None:
        self.name, self.level = name, name == "motors"

    def set(self, level: bool) -> None:
        wire = self.name if self.name == "motors" else f"power {'on' if level else 'off'}"
        record(f"{self.name} {'on' if level else 'off'}")
        if breaks(f"{wire} fails") or (self.level and breaks(f"last {wire} fails")):
            raise OSError("no answer from 10.0.0.7")
        if not breaks(f"{wire} lies"):
            self.level = level

    def on(self) -> None:
        self.set(True)

    def off(self) -> None:
        self.set(False)

    def get(self) -> bool:
        return self.level


class Line:
    def __init__(self, power: Switch) -> None:
        self.power, self.said = power, False

    def read(self, size: int, timeout: float) -> bytes:
        if breaks("serial fails"):
            raise OSError("connection reset")
        console = Path(os.environ["FAKE_CONSOLE"])
        if self.said or not self.power.level or not console.stat().st_size:
            Path(os.environ["FAKE_CONSOLE"] + ".heard").touch()
            raise TIMEOUT
        self.said = True
        return console.read_bytes()


class Files:
    def __init__(self, folder: str) -> None:
        self.provider = SimpleNamespace(host="localhost", internal=folder)

    def stage(self, file: str) -> None:
        record(f"stage {Path(file).name}")
        Path(self.provider.internal, Path(file).name).symlink_to(file)   # as labgrid does it: not where there is one


class Target:
    def __init__(self, main: dict[str, Any]) -> None:
        power = Switch("power")
        self.drivers = {"PowerProtocol": power, "ConsoleProtocol": Line(power), "DigitalOutputProtocol": Switch("motors")}
        if "TFTPProvider" in main["resources"]:
            self.drivers["TFTPProviderDriver"] = Files(main["resources"]["TFTPProvider"]["internal"])

    def get_driver(self, protocol: str, name: str | None = None) -> Any:
        if protocol not in self.drivers:
            raise NoDriverFoundError(protocol)
        return self.drivers[protocol]


class Environment:
    def __init__(self, file: str) -> None:
        data = json.loads(Path(file).read_text())
        self.data = data
        self.config = SimpleNamespace(get_targets=lambda: data.get("targets"), get_option=lambda name, default: data.get("options", {}).get(name, default))

    def get_target(self, name: str) -> Target:
        return Target(self.data["targets"][name])

    def cleanup(self) -> None:
        record("cleanup")
