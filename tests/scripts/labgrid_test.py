#!/usr/bin/python3
"""Rung 5 with labgrid itself: its coordinator, exporter, client and drivers, and a bench whose board only prints what this test made. Left out where hil/lab/labgrid
has unpacked no labgrid yet."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

import fakes

LABGRID = fakes.ROOT / "build/lab/labgrid"
CONSOLE = ('hil: begin tour, root 00000000000000aa\r\nhil: trace tour "ticks": 70, "hash": "00000000000000ab" \r\nhil: status: {"ticks": 500, "late": 0}\r\n'
           'hil: \xff telnet\r\nhil: done\r\nhil: exit 0\r\n').encode("latin-1")
OFF_ON_OFF = ["motors off", "power off", "power on", "power off"]


class LabgridTest(unittest.TestCase):
    """The tests share one lab, and run in the order of their names."""

    root: Path
    paths: dict[str, str]
    lab: subprocess.Popen[str]
    environment: str
    coordinator: str

    @classmethod
    def setUpClass(cls) -> None:
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.root = Path(folder.name)
        shutil.copytree(fakes.ROOT / "hil/lib", cls.root / "hil/lib", ignore=shutil.ignore_patterns("__pycache__"))
        for name in ("lab/run", "lab/virtual_lab", "lab/bench", "rig/head", "rig/command_line", "rig/machine", "rig/scenarios/tour"):
            (cls.root / "hil" / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(fakes.ROOT / "hil" / name, cls.root / "hil" / name)
        board = cls.root / "build/rig/arm64"
        board.mkdir(parents=True)
        for file, text in (("vmlinuz", "kernel"), ("initramfs.gz", "root"), ("root_id", "00000000000000aa\n")):
            (board / file).write_text(text)
        (cls.root / "build/lab").mkdir()
        (cls.root / "build/lab/labgrid").symlink_to(LABGRID)
        qemu = cls.root / "bin/qemu-system-aarch64"
        qemu.parent.mkdir()
        qemu.write_text(f'#!/bin/sh\necho "$@" >{cls.root}/booted\ncat {cls.root}/console\nexec sleep 100\n')
        qemu.chmod(0o755)
        cls.paths = {**os.environ, "PATH": f"{qemu.parent}:{os.environ['PATH']}"}
        cls.lab = subprocess.Popen([cls.root / "hil/lab/virtual_lab", cls.root / "v", "arm64", "64", "1"], stdout=subprocess.PIPE, env=cls.paths, text=True)
        cls.addClassCleanup(cls.end)
        assert cls.lab.stdout and cls.lab.stdout.readline() == "ready\n"
        cls.environment = (cls.root / "v/env.yaml").read_text()
        cls.coordinator = cls.environment.split("coordinator_address: ")[1].split()[0]

    @classmethod
    def end(cls) -> None:
        cls.lab.terminate()
        cls.lab.communicate()

    def setUp(self) -> None:
        (self.root / "console").write_bytes(CONSOLE)
        self.before = len(self.bench())

    def bench(self) -> list[str]:
        """What was done to switch and relay since the test began."""
        return (self.root / "v/bench.log").read_text().splitlines()[2:][getattr(self, "before", 0):]

    def run_lab(self, environment: str) -> tuple[int, str]:
        (self.root / "env.yaml").write_text(environment)
        done = subprocess.run([self.root / "hil/lab/run", "tour", "1"], capture_output=True, text=True, check=False, timeout=120,
                              env={**self.paths, "HIL_ENV": f"{self.root}/env.yaml", "HIL_SILENCE": "3", "HIL_LIMIT": "20"})
        self.assertNotIn("Traceback", done.stderr)
        return done.returncode, done.stderr

    def client(self, *command: str, **who: str) -> int:
        command_line = [sys.executable, str(LABGRID / "usr/bin/labgrid-client"), "-x", self.coordinator, "-p", "virtual-board", *command]
        return subprocess.run(command_line, capture_output=True, check=False, env={**os.environ, **who, "PYTHONPATH": f"{LABGRID}/usr/lib/python3/dist-packages"}).returncode

    def test_1_every_byte_of_the_console_comes_through_and_the_board_is_left_off(self) -> None:
        self.assertEqual(self.run_lab(self.environment), (0, ""))
        self.assertEqual((self.root / "build/lab/tour-1.log").read_bytes(), CONSOLE)
        self.assertEqual(self.bench(), OFF_ON_OFF)
        self.assertIn("hil=tour", (self.root / "booted").read_text())

    def test_2_a_place_that_somebody_has_is_not_touched(self) -> None:
        mara = {"LG_USERNAME": "mara", "LG_HOSTNAME": "bench7"}
        self.assertEqual(self.client("acquire", **mara), 0)
        code, said = self.run_lab(self.environment)
        self.assertEqual((code, said), (1, "hil: the place 'virtual-board' is taken by bench7/mara; wait until it is released there\n"))
        self.assertEqual((self.client("release", **mara), self.bench()), (0, []))   # 0: it is still hers

    def test_3_an_unknown_place_and_a_coordinator_that_is_away_are_named(self) -> None:
        code, said = self.run_lab(self.environment.replace("name: virtual-board", "name: nowhere"))
        self.assertEqual((code, f"the coordinator at {self.coordinator} has no place 'nowhere'" in said), (1, True), said)
        code, said = self.run_lab(self.environment.replace(self.coordinator, "127.0.0.1:1"))
        self.assertEqual((code, "no coordinator of labgrid answers at 127.0.0.1:1" in said), (1, True), said)
        self.assertEqual(self.bench(), [])

    def test_4_a_file_that_is_no_environment_or_lacks_a_driver_is_named(self) -> None:
        for change, words in ((("targets:", "targets: ["), "not an environment of labgrid"), (("SerialDriver: {}", "NoSuchDriver: {}"), "NoSuchDriver"),
                              (("      SerialDriver: {}\n", ""), "a serial line for 'virtual-board' cannot be used; add a driver such as SerialDriver")):
            code, said = self.run_lab(self.environment.replace(*change))
            self.assertEqual((code, words in said, said.count("\n")), (1, True, 1), said)
        self.assertEqual(self.bench(), [])

    def test_5_a_silent_board_is_turned_off_and_its_place_released(self) -> None:
        (self.root / "console").write_bytes(b"")
        code, said = self.run_lab(self.environment)
        self.assertEqual((code, "said nothing on its serial line" in said, self.bench()), (1, True, OFF_ON_OFF), said)
        self.assertEqual((self.client("acquire"), self.client("release")), (0, 0))

    def test_6_a_switch_or_a_relay_that_does_not_answer_is_named(self) -> None:
        power = "      NetworkPowerPort:\n        {name: dead, model: rest, host: 'http://127.0.0.1:1/power', index: '0'}\n"
        relay = "      HttpDigitalOutput:\n        {name: dead, url: 'http://127.0.0.1:1/motors', body_asserted: '1', body_deasserted: '0'}\n"
        code, said = self.run_lab(self.dead("port", "NetworkPowerDriver:", power))
        self.assertEqual((code, said.count("\n")), (1, 1), said)
        self.assertIn("hil: the power switch did not turn 'virtual-board' off; turn it off by hand: HTTPConnectionPool", said)
        self.assertEqual(self.bench(), ["motors off"])
        code, said = self.run_lab(self.dead("http", "name: motors", relay))
        self.assertEqual((code, said.count("\n")), (1, 1), said)
        self.assertIn("hil: the relay in the motors' enable line of 'virtual-board' did not open: HTTPConnectionPool", said)
        self.assertEqual(self.bench(), ["motors off"])

    def dead(self, what: str, driver: str, resource: str) -> str:
        """An environment in which this driver has a resource where nobody answers."""
        return self.environment.replace("    drivers:\n", f"{resource}    drivers:\n").replace(driver, f"{driver}\n        bindings: {{{what}: dead}}")

    def test_7_a_serial_line_that_is_gone_is_named(self) -> None:
        os.kill(next(int(entry.name) for entry in Path("/proc").iterdir() if entry.name.isdigit() and self.is_bench(entry)), 15)
        time.sleep(1)
        code, said = self.run_lab(self.environment)
        self.assertEqual((code, "a serial line for 'virtual-board' cannot be used" in said, said.count("\n")), (1, True, 1), said)

    def is_bench(self, process: Path) -> bool:
        """Is it the bench of this test's own lab?"""
        try:
            return f"{self.root}/hil/lab/bench" in (process / "cmdline").read_text().split("\0")
        except OSError:
            return False


if __name__ == "__main__":
    if not (LABGRID / "version").exists():
        print("left out: hil/lab/labgrid has unpacked no labgrid")
        sys.exit(77)
    unittest.main()
