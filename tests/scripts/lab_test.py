#!/usr/bin/env python3
"""What hil/lab/run promises, with a labgrid and a board that are made here: what is done to the wires, in which order, and one clear sentence for each trouble."""

from __future__ import annotations

import json
import shutil
import signal
import unittest
from pathlib import Path
from typing import Any

import fakes

BEGIN = "hil: begin tour, root 00000000000000aa\r\n"
STATUS = 'hil: status: {\r\nhil: status:   "ticks": 500,\r\nhil: status:   "late": 0\r\nhil: status: }\r\n'
CONSOLE = f'U-Boot\r\n{BEGIN}hil: trace tour "ticks": 70, "hash": "00000000000000ab" \r\n{STATUS}hil: done\r\nhil: exit 0\r\n'
BOOT = ["motors off", "stage vmlinuz", "stage initramfs.gz", "stage extlinux.conf", "power off", "power on"]
LEFT = ["power off", "cleanup", "release"]

# What labgrid's client prints, and its exit code
CLIENT = """
shift 2   # the coordinator
case $1$3 in
  -pacquire)
    case $FAKE_PLACE in
      unknown) echo "labgrid-client: Error: place pattern $2 matches nothing" >&2; exit 1 ;;
      taken) echo "labgrid-client: Error: Place $2 is already acquired by bench7/mara. To work simultaneously, mara can execute 'labgrid-client' on bench7." >&2; exit 1 ;;
      mine) echo "labgrid-client: Error: You have already acquired place $2." >&2; exit 1 ;;
      away) echo "Server error: Error: Could not connect to coordinator" >&2; exit 1 ;;
      broken) echo "Server error: serial port is broken" >&2; exit 1 ;;
    esac
    echo acquire >>"$FAKE_EVENTS" ;;
  -prelease) echo release >>"$FAKE_EVENTS" ;;
esac
"""


class LabTest(fakes.Tree):
    def setUp(self) -> None:
        super().setUp()
        self.script("hil/rig/head", 'case $2 in board) echo "${FAKE_BOARD:-arm64}" ;; *) echo "$3" ;; esac\n')
        self.script("hil/rig/command_line", 'echo "console=$2 hil=$1"\n')
        for file, text in (("vmlinuz", "kernel"), ("initramfs.gz", "root"), ("root_id", "00000000000000aa\n")):
            self.write(f"build/rig/arm64/{file}", text)
        self.script("build/lab/labgrid/usr/bin/labgrid-client", "")
        (self.root / "build/lab/labgrid/usr/bin/labgrid-client").write_text(  # it is started with Python
            f"import subprocess, sys\nsys.exit(subprocess.run(['sh', '-c', '''{CLIENT}''', 'client', *sys.argv[1:]]).returncode)\n")
        packages = self.root / "build/lab/labgrid/usr/lib/python3/dist-packages"
        packages.mkdir(parents=True)
        shutil.copy(Path(__file__).with_name("fake_labgrid.py"), packages / "labgrid.py")
        (self.root / "boot").mkdir()
        self.main: dict[str, Any] = {"options": {"console": "ttyS2,115200"}, "resources": {"RemotePlace": {"name": "bench-3"}, "TFTPProvider": {"internal": f"{self.root}/boot"}},
                     "drivers": [{"SerialDriver": {}}, {"HttpDigitalOutputDriver": {"name": "motors"}}]}
        self.events = self.root / "events"
        self.describe()
        self.write("console", CONSOLE)

    def write(self, path: str, text: str) -> None:
        file = self.root / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(text.encode())

    def describe(self) -> None:
        self.write("env.yaml", json.dumps({"options": {"coordinator_address": "lab:20408"}, "targets": {"main": self.main}}))

    def environment(self, **more: str) -> dict[str, str]:
        self.events.write_text("")
        return {"HIL_ENV": f"{self.root}/env.yaml", "FAKE_EVENTS": str(self.events), "FAKE_CONSOLE": f"{self.root}/console", "HIL_SILENCE": "0.2", "HIL_LIMIT": "0.3", **more}

    def run_lab(self, **more: str) -> tuple[int, dict[str, Any], str]:
        code, said, complaints = self.call("hil/lab/run", "tour", "7", **self.environment(**more))
        outcome = json.loads(said)
        self.assertEqual((outcome["rung"], outcome["scenario"], outcome["seed"], outcome["exit"]), (5, "tour", 7, code))
        return code, outcome, complaints

    def done(self) -> list[str]:
        return self.events.read_text().splitlines()

    def refused(self, *words: str, **more: str) -> None:
        """One sentence, with these words, and exit code 1."""
        code, _, complaints = self.run_lab(**more)
        self.assertEqual((code, complaints.count("\n"), complaints[:5]), (1, 1, "hil: "), complaints)
        for word in words:
            self.assertIn(word, complaints)

    # ---- a run ----------------------------------------------------------------------------------------------------------------------

    def test_a_scenario_is_booted_heard_and_judged_and_the_board_is_left_off(self) -> None:
        code, outcome, _ = self.run_lab()
        self.assertEqual((code, self.done()), (0, ["acquire", *BOOT, *LEFT]))
        self.assertEqual([outcome[key] for key in ("ticks", "missed", "trace_hash", "equal")], [500, 0, "00000000000000ab", None])
        self.assertEqual((self.root / "boot/extlinux.conf").read_text(), "default hil\nlabel hil\n  kernel vmlinuz\n  initrd initramfs.gz\n  append console=ttyS2,115200 hil=tour\n")
        self.assertEqual((self.root / "build/lab/tour-7.log").read_bytes(), CONSOLE.encode())

    def test_what_was_staged_before_is_replaced(self) -> None:
        self.assertEqual((self.run_lab()[0], self.run_lab()[0]), (0, 0))

    def test_a_lab_without_a_coordinator_or_without_a_relay_runs(self) -> None:
        del self.main["resources"]["RemotePlace"]
        del self.main["drivers"]
        self.describe()
        self.assertEqual((self.run_lab()[0], self.done()), (0, [*BOOT[1:], *LEFT[:-1]]))

    def test_a_scenario_that_fails_or_never_says_done_fails(self) -> None:
        self.write("console", CONSOLE.replace("exit 0", "exit 5"))
        self.assertEqual((self.run_lab()[0], self.done()[-3:]), (5, LEFT))
        self.write("console", CONSOLE.replace("hil: done\r\n", ""))
        self.assertEqual(self.run_lab()[0], 6)
        self.write("console", CONSOLE.replace('"late": 0', '"late": 1'))
        self.assertEqual(self.run_lab()[0], 4)

    def test_another_root_another_scenario_or_a_second_start_fails(self) -> None:
        for begin in (BEGIN.replace("aa", "ab"), BEGIN.replace("tour", "boot"), BEGIN + "panic\r\n" + BEGIN):
            self.write("console", CONSOLE.replace(BEGIN, begin))
            code, _, complaints = self.run_lab()
            self.assertEqual((code, "it booted something else, or more than once" in complaints), (7, True), begin)

    def test_without_an_environment_a_virtual_lab_is_taken_and_compared_with_rung_2(self) -> None:
        self.script("hil/lab/virtual_lab", 'mkdir -p "$1" && cp "$FAKE_ENV" "$1/env.yaml" && echo "$2 $3 $4" >"$1/kind" && echo ready && exec sleep 30\n')
        self.describe()
        virtual = {"HIL_ENV": "", "FAKE_ENV": f"{self.root}/env.yaml"}
        self.assertEqual(self.run_lab(**virtual)[1]["equal"], None)
        self.assertEqual((self.root / "build/lab/virtual/kind").read_text(), "arm64 256 7\n")
        self.write("build/rig/out/tour-7-1.log", CONSOLE)
        self.assertEqual(self.run_lab(**virtual)[1]["equal"], True)
        self.write("build/rig/out/tour-7-1.log", CONSOLE.replace("70", "71"))
        self.assertEqual(self.run_lab(**virtual)[:1], (3,))
        self.write("build/rig/out/tour-7-1.log", CONSOLE.replace("70", "71").replace("aa", "ab"))   # left by another root
        self.assertEqual(self.run_lab(**virtual)[1]["equal"], None)
        self.script("hil/lab/virtual_lab", "echo no ser2net >&2\nexit 1\n")
        self.refused("the virtual lab did not start: no ser2net", **virtual)

    # ---- trouble with the lab: nothing is touched ----------------------------------------------------------------------------------------

    def test_a_file_that_is_missing_or_describes_no_board_is_refused(self) -> None:
        self.refused("there is no such file", "docs/boards-in-a-lab.md", HIL_ENV=f"{self.root}/nowhere.yaml")
        self.write("env.yaml", "{")
        self.refused("env.yaml: not an environment of labgrid")
        self.write("env.yaml", '{"targets": {"board": {}}}')
        self.refused("there is no target 'main'")
        del self.main["resources"]["TFTPProvider"]
        self.describe()
        self.refused("a folder to boot from for 'bench-3' cannot be used; add a driver such as TFTPProviderDriver")
        self.assertEqual(self.done(), ["acquire", "cleanup", "release"])

    def test_a_place_that_cannot_be_had_is_refused(self) -> None:
        for how, words in (("unknown", "the coordinator at lab:20408 has no place 'bench-3'"), ("taken", "the place 'bench-3' is taken by bench7/mara; wait"),
                           ("mine", "is taken by yourself"), ("away", "no coordinator of labgrid answers at lab:20408"),
                           ("broken", "the place 'bench-3' cannot be had: Server error: serial port is broken")):
            self.refused(words, FAKE_PLACE=how)
            self.assertEqual(self.done(), ["cleanup"], how)

    def test_a_board_of_another_kind_is_refused(self) -> None:
        self.refused("the scenario 'tour' needs a board 'armhf'", FAKE_BOARD="armhf")
        self.assertEqual(self.done(), ["acquire", "cleanup", "release"])

    def test_labgrid_that_is_not_there_is_named(self) -> None:
        (self.root / "build/lab/labgrid/usr/lib/python3/dist-packages/labgrid.py").write_text("import no_such_package\n")
        self.refused("labgrid cannot be loaded (No module named 'no_such_package'); ./dev hil 5 installs it")

    def test_a_relay_that_does_not_open_keeps_the_board_as_it_was(self) -> None:
        self.refused("the relay in the motors' enable line of 'bench-3' did not open: no answer from 10.0.0.7", FAKE_BREAKS="motors fails")
        self.assertEqual(self.done(), ["acquire", "motors off", "cleanup", "release"])
        self.refused("did not open: it says that it is closed", FAKE_BREAKS="motors lies")
        self.assertEqual(self.done(), ["acquire", "motors off", "cleanup", "release"])

    # ---- trouble with the board: it is left off --------------------------------------------------------------------------------------------

    def test_a_silent_board_is_turned_off(self) -> None:
        self.write("console", "")
        code, _, complaints = self.run_lab(HIL_LIMIT="15")
        self.assertIn("the board 'bench-3' said nothing on its serial line for ", complaints)
        self.assertTrue(complaints.endswith(" after it was turned on; check the line, its speed, and that the board has power\n"), complaints)
        self.assertEqual((code, "for 15 s" in complaints), (1, False), complaints)   # a silent board is not waited for as long as one that speaks
        self.assertEqual(self.done(), ["acquire", *BOOT, *LEFT])

    def test_a_board_that_never_ends_and_a_line_that_breaks_turn_it_off(self) -> None:
        self.write("console", CONSOLE.replace("hil: exit 0", ""))
        self.refused("did not end its scenario within", "build/lab/tour-7.log has what it said")
        self.assertEqual(self.done()[-3:], LEFT)
        self.refused("the serial line of 'bench-3' was lost: connection reset", FAKE_BREAKS="serial fails")
        self.assertEqual(self.done()[-3:], LEFT)

    def test_a_power_switch_that_fails_is_named_and_tried_once_more(self) -> None:
        self.refused("the power switch did not turn 'bench-3' on: no answer from 10.0.0.7", FAKE_BREAKS="power on fails")
        self.assertEqual(self.done(), ["acquire", *BOOT, *LEFT])
        self.refused("did not turn 'bench-3' on: it says that the board is off", FAKE_BREAKS="power on lies")
        self.assertEqual(self.done(), ["acquire", *BOOT, *LEFT])

    def test_a_board_that_cannot_be_turned_off_is_a_failure(self) -> None:
        said = "the power switch did not turn 'bench-3' off; turn it off by hand: no answer from 10.0.0.7\n"
        self.assertEqual(self.run_lab(FAKE_BREAKS="power off fails")[::2], (1, "hil: " + said))
        self.assertEqual(self.done(), ["acquire", *BOOT[:-1], *LEFT])
        self.write("console", "")
        code, _, complaints = self.run_lab(FAKE_BREAKS="last power off fails")
        self.assertEqual((code, complaints.count("\n"), complaints.endswith("has power; and " + said)), (1, 1, True), complaints)
        self.assertEqual(self.done(), ["acquire", *BOOT, *LEFT])
        self.write("console", CONSOLE)
        self.refused(said.strip(), FAKE_BREAKS="last power off fails")

    def test_an_interrupt_turns_the_board_off_and_releases_the_place(self) -> None:
        self.write("console", "")
        with self.start("hil/lab/run", "tour", "7", **self.environment(HIL_SILENCE="30")) as process:
            self.assertTrue(fakes.appears(self.root / "console.heard"), "nobody listens")
            process.send_signal(signal.SIGTERM)
            process.communicate(timeout=20)
        self.assertEqual((process.returncode, self.done()), (130, ["acquire", *BOOT, *LEFT]))


if __name__ == "__main__":
    unittest.main()
