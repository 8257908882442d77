#!/usr/bin/env python3
"""What scenarios of the virtual board promise, where what they look at shows nothing: the real script, with the board's functions replaced. And what those
with the world outside promise of a board that leaves a fault by itself.
"""

from __future__ import annotations

import subprocess
import tempfile
import unittest
from pathlib import Path

RIG = Path(__file__).resolve().parents[2] / "hil/rig"
BOARD = """
make_lines() { :; }
press() { :; }
feel() { :; }
tell_status() { :; }
beats() { return ${BEATS:-0}; }
trace_lines() { :; }
mark() { :; }
kill() { :; }
wait() { :; }
sleep() { :; }
edges() { :; }
line() { echo 0; }
start_controller() { :; }
homed() { :; }
reach() { :; }
record() { :; }
zeros() { :; }
conclude() { :; }
tail() { [ "$1" != /dev/zero ] || return 0; command tail "$@"; }
dmesg() { echo 'Out of memory: Killed process 7 (tail)'; }
status_of() { echo 0; }
controller_process=7 falcon_process=8
"""
# The fault is left where nobody resumed, but not before the hand of the device has homed it.
OUTSIDE = """
for name in start_falcon start_board mark feel happened eventually kill_falcon release_stop conclude say; do eval "$name() { :; }"; done
board() { [ "$1" != sleep ] || slept=yes; }
does() { [ "$*" = 'is_in fault' ] && [ "${slept:-no}" != "$leaves" ]; }
beats() { [ "$1" = 0.1 ]; }
fail() { echo "FAILED: $*"; exit 1; }
room=.
"""
TRACED = "1000 mark traced\n" + "".join(f"{2000 + 1000 * n} 2 {n % 2}\n" for n in range(100)) + "102000 mark killed\n102500 2 0\n103000 mark gone\n200000 mark end\n"
CRASHED = "the previous run crashed, was killed, lost power or ended before a person had resumed; no force until 'resume'\n"
LOCKED = "Name:\tisotouchd\nVmLck:\t   70000 kB\n"


class ScenariosTest(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.room = Path(folder.name)
        (self.room / "run").mkdir()
        (self.room / "proc/7").mkdir(parents=True)

    def scenario(self, name: str, more: str = "") -> tuple[int, str]:
        """Exit code, and what it says; /run and /proc are folders of the test."""
        script = (RIG / "scenarios" / name).read_text().replace(". /lib/board.sh\n", (RIG / "guest/board.sh").read_text() + BOARD + more)
        script = script.replace("/run/", f"{self.room}/run/").replace("/proc/", f"{self.room}/proc/").replace("/fields/", f"{self.room}/fields/")
        ended = subprocess.run(["sh", "-c", script], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=60)
        return ended.returncode, ended.stdout

    def test_killed_needs_a_heartbeat_in_the_trace_before_the_signal(self) -> None:
        (self.room / "run/falcon.log").write_text("falcon-sim: 9 packets, torque until the 7th, ran out 1 times, ...\n")
        edges, log = self.room / "run/edges", self.room / "run/controller.log"
        edges.write_text(TRACED)
        log.write_text("state: active\n")
        code, said = self.scenario("killed")
        self.assertEqual(code, 1, said)
        self.assertIn("the start after a kill does not know of it", said)
        log.write_text(CRASHED)
        code, said = self.scenario("killed")
        self.assertEqual(code, 0, said)
        self.assertIn("the heartbeat's last edge 500 us after the signal", said)
        for empty in ("", "1000 mark traced\n102000 mark killed\n103000 mark gone\n200000 mark end\n"):
            edges.write_text(empty)
            code, said = self.scenario("killed")
            self.assertEqual(code, 1, said)
            self.assertIn("the trace shows no heartbeat before the signal", said)
        edges.write_text(TRACED.replace("200000", "150000 2 1\n200000"))
        self.assertIn("the heartbeat goes on", self.scenario("killed")[1])

    def test_emergency_stop_waits_until_the_motors_are_enabled(self) -> None:
        """The line is low when it is first looked at, and high from the third time on."""
        slow = """
line() { echo >>/run/looked; [ $(wc -l </run/looked) -lt 3 ] && echo 0 || echo 1; }
press_stop() { exit 9; }
"""
        code, said = self.scenario("emergency-stop", slow)
        self.assertEqual(code, 9, said)

    def test_stream_needs_the_last_field_and_a_hand_that_feels_it(self) -> None:
        (self.room / "fields").mkdir()
        (self.room / "fields/stream.hash").write_text("0123456789abcdef\n")
        board = """
start_falcon() { :; }
within() { :; }
isotouchctl() { echo "$1"; [ "$1" != "$refused" ]; }
status_of() { case $1 in field_hash) echo $felt_field ;; allocations) echo $allocations ;; *) echo 0 ;; esac; }
commands_in() { command seq $ticks; }
refused=none felt_field=0123456789abcdef allocations=0 ticks=1000
"""
        self.assertEqual(self.scenario("stream", board)[0], 0)
        for change, sentence in (("refused=upload", "upload: upload"), ("refused=replay", "replay: replay"), ("felt_field=0", "0 is felt instead of 0123456789abcdef"),
                                 ("allocations=1", "the tick allocates"), ("ticks=500", "felt the object in 500 ticks only")):
            code, said = self.scenario("stream", board + change + "\n")
            self.assertEqual(code, 1, said)
            self.assertIn(sentence, said)

    def test_low_memory_needs_locked_memory(self) -> None:
        status = self.room / "proc/7/status"
        status.write_text(LOCKED)
        code, said = self.scenario("low-memory")
        self.assertEqual(code, 0, said)
        for unlocked in (LOCKED.replace("70000", "0"), LOCKED.replace("70000", "16000"), "Name:\tisotouchd\n"):
            status.write_text(unlocked)
            code, said = self.scenario("low-memory")
            self.assertEqual(code, 1, said)
            self.assertIn("the controller's memory is not locked", said)

    def test_a_board_outside_that_leaves_a_fault_once_the_device_is_homed_is_noticed(self) -> None:
        for name in ("controller-killed", "firmware-lost", "killed", "unplug"):
            for leaves, code, said in (("never", 0, "^$"), ("yes", 1, "^FAILED: (left the fault by itself|forces came back by themselves)\n$")):
                script = f"leaves={leaves}\n{OUTSIDE}{(RIG.parent / 'outside/scenarios' / name).read_text()}"
                ended = subprocess.run(["bash", "-c", script], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=60, cwd=self.room)
                self.assertEqual(ended.returncode, code, name)
                self.assertRegex(ended.stdout, said)

    def terminated(self, packets: int, torque: int, commands: str) -> tuple[int, str]:
        (self.room / "run/falcon.log").write_text(f"falcon-sim: {packets} packets, torque until the {torque}th, ran out 0 times, ...\n")
        (self.room / "run/controller.log").write_text("state: active\n")
        tool = f"isotouchctl() {{ case $* in *command_1*) printf 'tick,c1,c2,c3\\n{commands}' ;; *) printf 'tick\\n1\\n2\\n3\\n' ;; esac; }}\n"
        return self.scenario("terminated", tool + "BEATS=1\n")

    def test_terminated_counts_its_ticks(self) -> None:
        code, said = self.terminated(100, 97, "1,0,0,0\\n2,5,0,0\\n3,5,0,0\\n")
        self.assertEqual(code, 0, said)
        self.assertIn("zero SIGTERM: the next packet, ticks 1\n", said)
        for packets, torque, commands, why in ((100, 96, "3,5,0,0\\n", "not three packets without torque at the end but 4"), (100, 97, "2,5,0,0\\n3,0,0,0\\n", "the last of 3 ticks with motor commands is 2"),
                                               (100, 97, "3,0,0,0\\n", "the last of 3 ticks with motor commands is none")):
            code, said = self.terminated(packets, torque, commands)
            self.assertEqual(code, 1, said)
            self.assertIn(why, said)


if __name__ == "__main__":
    unittest.main()
