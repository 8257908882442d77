#!/usr/bin/env python3
"""What hil/rig/make promises of a program at the desk that fails, with programs that are made here."""

from __future__ import annotations

import os
import shutil
import unittest

import fakes

SERVES = """exec python3 - "$1" <<'END'
import signal, socket, sys
door = socket.socket(socket.AF_UNIX)
door.bind(sys.argv[1])
signal.signal(signal.SIGTERM, lambda *_: sys.exit(int("${FAKE_ENDS:-0}")))
signal.pause()
END
"""
WORDS = """for word in "$@"; do
  case $before in --control | --socket) socket=$word ;; --record) record=$word ;; -o | --first) echo something >"$word" ;; esac
  before=$word
done
"""


class RigMakeTest(fakes.Tree):
    def setUp(self) -> None:
        super().setUp()
        shutil.copy(fakes.ROOT / "hil/rig/make", self.root / "hil/rig/make")
        self.script("bin/serves", SERVES.replace("<<'END'", "<<END"))
        self.script("bin/cmake", "! flock -n build/release.lock true || echo another could build, too >&2\n")
        self.script("build/release/bin/falcon-sim", WORDS + "exec serves $socket\n")
        self.script("build/release/bin/isotouch", WORDS + 'case $* in *hash*) echo 0123456789abcdef ;; esac\nexit 0\n')
        self.script("build/release/bin/isotouchd", WORDS + """case $* in *--lockstep*) exit ${FAKE_LOCKSTEP:-0} ;; esac
echo something >"${record%.trace}.patches"
FAKE_ENDS=$FAKE_CONTROLLER exec serves $socket
""")
        self.script("hil/rig/guest/dialogue", 'echo what they said\nexit ${FAKE_DIALOGUE:-0}\n')

    def make(self, **environment: str) -> tuple[int, str]:
        """Exit code and complaints. Without a scenario it makes the fields, and what is said at the desk."""
        code, _, complaints = self.call("hil/rig/make", PATH=f"{self.root}/bin:{os.environ['PATH']}", TMPDIR=str(self.root), **environment)
        return code, complaints

    def kept(self, ending: str) -> list[str]:
        return sorted(file.name for file in (self.root / "build/rig/fields").glob(f"*.{ending}"))

    def test_what_is_said_at_the_desk_is_kept(self) -> None:
        self.assertEqual(self.make(), (0, ""))
        self.assertEqual(self.kept("dialogue"), ["bomberman.dialogue", "hydrant.dialogue", "owl.dialogue", "published.dialogue"])
        self.assertEqual(self.kept("patches"), ["stream.patches"])

    def test_a_controller_or_a_dialogue_that_fails_leaves_nothing_that_looks_whole(self) -> None:
        for fails in ("FAKE_LOCKSTEP", "FAKE_DIALOGUE"):
            self.assertNotEqual(self.make(**{fails: "1"})[0], 0, fails)
            self.assertEqual(self.kept("dialogue"), [], fails)

    def test_a_controller_that_crashes_at_its_end_is_noticed(self) -> None:
        self.assertEqual(self.make(FAKE_CONTROLLER="134"), (1, "rig: the controller that was streamed to ended with 134\n"))
        self.assertEqual(self.kept("patches"), [])


if __name__ == "__main__":
    unittest.main()
