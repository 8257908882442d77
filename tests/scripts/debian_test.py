#!/usr/bin/env python3
"""Debian's packages are built with the libraries that ./dev installs, and nothing that lintian says is overridden."""

from __future__ import annotations

import os
import pathlib
import re
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).parents[2]
OF_TESTS = {"libgtest-dev", "libgmock-dev"}


def libraries(text: str) -> set[str]:
    return set(re.findall(r"\b(?:lib[a-z0-9.+-]+|nlohmann-json3)-dev\b", text))


class DebianTest(unittest.TestCase):
    def test_libraries_are_those_of_dev(self) -> None:
        lists = re.findall(r"^(?:libraries|packages_build)=\((.*)\)", (ROOT / "dev").read_text(), re.MULTILINE)
        self.assertEqual(len(lists), 2)
        wanted = (ROOT / "packaging/debian/control").read_text().split("Package:")[0]
        self.assertEqual(libraries(wanted), libraries(" ".join(lists)) - OF_TESTS)

    def test_nothing_is_overridden(self) -> None:
        self.assertEqual([str(file) for file in (ROOT / "packaging/debian").rglob("*lintian*")], [])

    def purge(self, room: pathlib.Path, **environment: str) -> None:
        """What a purge does, with a folder of ours for the state and ourselves for the service."""
        script = (ROOT / "packaging/debian/isotouchd.postrm").read_text().replace("/var/lib/isotouch", f"{room}/state")
        script = script.replace("-user isotouch", f"-user {os.geteuid()}")
        subprocess.run(["sh", "-c", script, "postrm", "purge"], check=True, stderr=subprocess.DEVNULL, env={**os.environ, **environment})

    def test_a_purge_takes_the_state_and_never_fails(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            room = pathlib.Path(folder)
            for state in (room / "state", room / "disk"):   # a folder; a link to one
                (state / "faults").mkdir(parents=True)
                (state / "faults/fault-1.trace").touch()
                (state / "active").touch()
                if state.name == "disk":
                    (room / "state").symlink_to(state)
                    (state / "theirs").touch()
                    theirs = True
                    try:
                        os.chown(state / "theirs", 12345, 12345)
                    except OSError:   # only the superuser can give a file away, and not in every container
                        theirs = False
                self.purge(room)
                self.assertFalse((room / "state").is_symlink() or (room / "state").exists())
            self.assertEqual([file.name for file in (room / "disk").iterdir()], ["theirs"] if theirs else [])
            self.purge(room)   # there is nothing
            (room / "state").symlink_to(room / "nowhere")
            self.purge(room)

            # A mount point cannot be removed; what it holds goes.
            (room / "state").unlink(missing_ok=True)
            (room / "state").mkdir()
            (room / "state/active").touch()
            (room / "bin").mkdir()
            (room / "bin/rm").write_text("#!/bin/sh\nexit 1\n")
            (room / "bin/rm").chmod(0o755)
            self.purge(room, PATH=f"{room}/bin:{os.environ['PATH']}")
            self.assertEqual(list((room / "state").iterdir()), [])


if __name__ == "__main__":
    unittest.main()
