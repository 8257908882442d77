#!/usr/bin/env python3
"""What ./dev promises of a build or a check that fails, with programs that are made here."""

from __future__ import annotations

import fcntl
import os
import shutil
import signal
import subprocess
import threading
import unittest
from pathlib import Path

import fakes

PAGE_TEST = "echo \"$0\" >>asked\necho \"${FAKE_SAID:-3 passed, 0 failed, 1 skipped}\"\nexit ${FAKE_PAGE:-0}\n"
# As the real one: it takes the files of its database in which the expression is found.
RUN_CLANG_TIDY = """#!/usr/bin/env python3
import re, sys
for file in open("database").read().splitlines():
    if re.search(sys.argv[-1], file):
        print("clang-tidy-14 -p=build/tidy -quiet", file)
"""

# Takes over what is not longer than -max_len; the edges are as many as the longest input has bytes.
FUZZ = """
for word in "$@"; do case $word in -max_len=*) most=${word#*=} ;; -*) ;; *) folders="$folders $word" ;; esac; done
case $1 in
  -set_cover_merge=1) fresh=${folders# } && fresh=${fresh%% *} && find $folders -type f -size -$((most + 1))c -exec cp {} $fresh \\; ;;
  *) [ -z "${FAKE_CRASH-}" ] || exit 77; [ -z "${FAKE_SILENT-}" ] || exit 0
     echo "#3	DONE   cov: $(find $folders -type f -printf '%s\\n' | sort -n | tail -1) ft: 9 corp: 3/9b" >&2 ;;
esac
"""

# Notes what it was asked, and what of it while anybody could have the lock of that folder.
WATCHES = """case $1 in --build) at=$2 ;; --workflow) at=build/$3 ;; *) at=build/$2 ;; esac
echo "$*" >>asked
! flock -n "$at.lock" true || echo "$*" >>unlocked
"""
# The tests of a preset: one, named FAKE_TESTS, fails; without that name none begins. Once `theirs` is there, whoever tests another preset loses the report of
# release to another terminal.
TESTS = """[ "$1" = --workflow ] || exit 0
[ ! -e theirs ] || [ "$3" = release ] || cp theirs build/release/tests.xml
[ -n "$FAKE_TESTS" ] || exit 1
mkdir -p "build/$3"
cat >"build/$3/tests.xml" <<END
<testsuite name="all"
	tests="5"
	failures="1"
	disabled="0"
	skipped="1"
	><testcase name="$FAKE_TESTS" status="fail"><system-out>because</system-out></testcase></testsuite>
END
exit 1
"""


class DevTest(fakes.Tree):
    def setUp(self) -> None:
        super().setUp()
        self.take("dev")
        for program in ("npm", "tsc", "mypy", "shellcheck", "git", "clang-format"):
            self.script(f"bin/{program}", "exit 0\n")
        self.script("bin/dpkg-query", "echo installed\n")
        self.script("bin/sudo", 'exec "$@"\n')
        self.script("bin/cmake", 'case "$*" in *"${FAKE_CMAKE:-nothing}"*) exit 1 ;; esac\n')

    def take(self, name: str) -> None:
        (self.root / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(fakes.ROOT / name, self.root / name)

    def dev(self, *words: str, **environment: str) -> tuple[int, str, str]:
        return self.call("dev", *words, PATH=f"{self.root}/bin:{os.environ['PATH']}", CI="true", ISOTOUCH_DATA="none", **environment)

    def view(self, **environment: str) -> tuple[int, str]:
        """Exit code and last line."""
        self.take("tests/integration/not_passed")
        for name in ("bundle_check", "view_test.mjs"):
            self.script(f"tests/host/page/{name}", PAGE_TEST)
        code, said, _ = self.dev("test", "view", **environment)
        return code, said.splitlines()[-1]

    def test_a_page_is_not_tested_with_the_programs_of_an_earlier_build(self) -> None:
        for fails in ("--preset release", "--build build/release"):
            self.assertEqual(self.view(FAKE_CMAKE=fails), (1, "0 passed, 1 failed, 0 skipped"), fails)
        self.assertFalse((self.root / "asked").exists())
        self.assertEqual(self.view(), (0, "6 passed, 0 failed, 2 skipped"))

    def test_a_test_of_the_page_that_fails_uncounted_counts(self) -> None:
        self.assertEqual(self.view(FAKE_PAGE="1"), (1, "6 passed, 2 failed, 2 skipped"))
        self.assertEqual(self.view(FAKE_PAGE="1", FAKE_SAID="1 passed, 2 failed, 0 skipped"), (1, "2 passed, 4 failed, 0 skipped"))
        self.assertEqual(self.view(FAKE_SAID="nothing"), (1, "0 passed, 2 failed, 0 skipped"))

    def test_kept_inputs_of_the_fuzzer_reach_what_all_inputs_reach(self) -> None:
        self.script("tests/fuzz/seeds", 'mkdir -p "$2/field"\nhead -c 22144 /dev/zero >"$2/field/ball"\n')
        self.script("build/sanitize/bin/fuzz_field", FUZZ)
        kept = self.root / "tests/fuzz/corpus/field"
        kept.mkdir(parents=True)
        (kept / "before").write_bytes(bytes(9))
        code, said, _ = self.dev("fuzz", "minimise", "field")
        self.assertEqual((code, said.splitlines()[-1]), (0, "field         2 inputs of 22153 bytes reach 22144 of 22144 edges"))
        (self.root / "build/fuzz/found/field/long").write_bytes(bytes(70_000))   # longer than what a door takes
        code, _, complaints = self.dev("fuzz", "minimise", "field")
        self.assertEqual(code, 1)
        self.assertEqual(complaints, "dev: field: the inputs in build/fuzz/minimised reach 22144 of 70000 edges; tests/fuzz/corpus/field stays as it was\n")
        self.assertEqual(len(list(kept.iterdir())), 2)

    def test_inputs_of_the_fuzzer_whose_edges_are_unknown_replace_none(self) -> None:
        self.script("tests/fuzz/seeds", 'mkdir -p "$2/field"\necho seed >"$2/field/ball"\n')
        self.script("build/sanitize/bin/fuzz_field", FUZZ)
        kept = self.root / "tests/fuzz/corpus/field"
        kept.mkdir(parents=True)
        (kept / "before").write_bytes(bytes(9))
        for how in ("FAKE_CRASH", "FAKE_SILENT"):
            code, _, complaints = self.dev("fuzz", "minimise", "field", **{how: "1"})
            self.assertEqual((code, complaints), (1, "dev: field: an input ends the program, or libFuzzer names no edges, see build/fuzz/field.log; "
                                                     "tests/fuzz/corpus/field stays as it was\n"), how)
            self.assertEqual([file.name for file in kept.iterdir()], ["before"], how)

    def test_clang_tidy_checks_shared_and_firmware_wherever_the_checkout_is(self) -> None:
        usual, self.root = self.root, self.root / "c++ [of 2] (a|b) $x^.{1}?*"
        shutil.copytree(usual, self.root, ignore=shutil.ignore_patterns("c++*"))
        (self.root / "bin/run-clang-tidy").write_text(RUN_CLANG_TIDY)
        (self.root / "bin/run-clang-tidy").chmod(0o755)
        (self.root / "database").write_text("\n".join(str(self.root / file) for file in ("shared/a.cpp", "firmware/core/b.cpp", "host/shared/c.cpp")))
        code, said, complaints = self.dev("tidy")
        log = (self.root / "build/tidy.log").read_text()
        self.assertEqual((code, complaints), (0, ""), said + log)
        self.assertEqual([line.rsplit("/", 1)[1] for line in log.splitlines()], ["a.cpp", "b.cpp"])

    def test_a_path_that_pkg_config_cannot_read_is_refused_before_anything_is_built(self) -> None:
        self.script("bin/cmake", 'echo "$*" >>asked\n')
        for program in ("apt-get", "apt-config"):
            self.script(f"bin/{program}", "echo http://nowhere\n")
        self.script("bin/mmdebstrap", "tar -c -T /dev/null\n")   # the libraries of the target
        usual = self.root
        for name, reads in (("plain", True), ("a b", False), ("a:b", False)):
            self.root = usual / "checkouts" / name
            self.take("dev")
            self.take("hil/lib/build.sh")
            for words in (("setup",), ("test",), ("test", "arm64"), ("hil", "2")):
                _, _, complaints = self.call("dev", *words, PATH=f"{usual}/bin:{os.environ['PATH']}", CI="true")
                said = f"dev: the build for arm64 works below no path with a space or a colon; move this checkout from '{self.root}'\n"
                self.assertEqual(said in complaints, not reads, f"{name}: {words}: {complaints}")
            self.assertEqual((self.root / "asked").exists(), reads, name)
            self.call("dev", "build", PATH=f"{usual}/bin:{os.environ['PATH']}", CI="true")   # for this machine
            self.assertTrue((self.root / "asked").exists(), name)
        self.root = usual

    def waits(self, lock: str, said: str, theirs: Path, *words: str) -> None:
        """A word waits until whoever has the lock has ended, and leaves theirs alone until then."""
        (self.root / lock).parent.mkdir(parents=True, exist_ok=True)
        with (self.root / lock).open("w") as first:
            fcntl.flock(first, fcntl.LOCK_EX)
            ended = threading.Timer(20, fcntl.flock, (first, fcntl.LOCK_UN))   # so that whoever waits and says nothing ends, too
            ended.start()
            self.addCleanup(ended.cancel)
            with self.start("dev", *words, PATH=f"{self.root}/bin:{os.environ['PATH']}", CI="true") as second:
                assert second.stderr
                self.assertEqual(second.stderr.readline(), f"dev: {said}; waiting until it has ended\n")
                with self.assertRaises(subprocess.TimeoutExpired):
                    second.wait(timeout=1)
                self.assertTrue(theirs.exists())
                ended.cancel()
                fcntl.flock(first, fcntl.LOCK_UN)
                second.communicate(timeout=60)
        self.assertEqual(second.returncode, 0)
        self.assertFalse(theirs.exists())

    def test_two_terminals_build_one_after_the_other(self) -> None:
        theirs = self.root / "build/package/bookworm/theirs.deb"
        theirs.parent.mkdir(parents=True)
        theirs.touch()
        for program in ("debian_source", "in_root"):
            self.script(f"packaging/{program}", "exit 0\n")
        self.waits("build/package/bookworm.lock", "another ./dev package is building in build/package/bookworm", theirs, "package", "bookworm")
        self.script("bin/cmake", "rm -f theirs\n")
        (self.root / "theirs").touch()
        self.waits("build/release.lock", "another ./dev builds in build/release", self.root / "theirs", "build")

    def test_whoever_waits_is_told_so_where_the_build_speaks_into_a_log(self) -> None:
        self.script("tests/fuzz/seeds", 'mkdir -p "$2/field"\necho seed >"$2/field/ball"\n')
        self.script("build/sanitize/bin/fuzz_field", FUZZ)
        self.script("hil/cases/run", "exit 0\n")
        self.script("bin/cmake", "rm -f theirs\n")
        for words in (("fuzz", "minimise", "field"), ("hil", "--accept", "a-case", "--reason", "none")):
            (self.root / "theirs").touch()
            self.waits("build/release.lock", "another ./dev builds in build/release", self.root / "theirs", *words)

    def test_a_lock_that_cannot_be_taken_is_not_said_to_be_anothers(self) -> None:
        self.script("bin/cmake", 'echo "$*" >>asked\n')
        (self.root / "build").mkdir(exist_ok=True)
        (self.root / "build/release.lock").symlink_to("nowhere/lock")   # not by its mode: root may open whatever is there
        code, _, complaints = self.dev("build")
        self.assertEqual((code, complaints.splitlines()[1:]),
                         (1, ["dev: build/release.lock cannot be locked; if build/ belongs to another user, remove it, or run this as that user"]))
        self.assertFalse((self.root / "asked").exists())

    def test_a_build_that_waits_leaves_the_log_of_the_first_one_alone(self) -> None:
        self.script("bin/cmake", 'echo begun\ntouch begun\nuntil [ -e go ]; do sleep 0.05; done\necho "$FAKE_SAYS"\nexit 1\n')
        environment = {"PATH": f"{self.root}/bin:{os.environ['PATH']}", "CI": "true"}
        with self.start("dev", "build", FAKE_SAYS="the first one's reason", **environment) as first:
            self.assertTrue(fakes.appears(self.root / "begun"))
            with self.start("dev", "build", FAKE_SAYS="the second one's", **environment) as second:
                assert second.stderr
                told = second.stderr.readline()
                (self.root / "go").touch()
                said = [terminal.communicate(timeout=60)[0] for terminal in (first, second)]
        self.assertEqual(told, "dev: another ./dev builds in build/release; waiting until it has ended\n")
        self.assertEqual(said, ["begun\nthe first one's reason\n", "begun\nthe second one's\n"])

    def test_a_preset_that_does_not_come_to_its_tests_takes_none_from_another_terminal(self) -> None:
        self.take("tests/integration/not_passed")
        self.script("bin/cmake", TESTS)
        self.assertEqual(self.dev("test", "release", FAKE_TESTS="theirs")[1].splitlines()[-1], "3 passed, 1 failed, 1 skipped")
        report = self.root / "build/release/tests.xml"
        theirs = report.read_text()
        with (self.root / "build/release.lock").open("w") as first:
            fcntl.flock(first, fcntl.LOCK_EX)
            with self.start("dev", "test", "release", PATH=f"{self.root}/bin:{os.environ['PATH']}", CI="true", FAKE_TESTS="") as second:
                assert second.stderr
                second.stderr.readline()   # it waits
                report.write_text(theirs)
                fcntl.flock(first, fcntl.LOCK_UN)
                said, _ = second.communicate(timeout=60)
        self.assertEqual((second.returncode, said.splitlines()[-1]), (1, "0 passed, 1 failed, 0 skipped"))

    def test_what_failed_is_named_though_another_terminal_tests_the_preset_again(self) -> None:
        self.take("tests/integration/not_passed")
        self.script("bin/cmake", TESTS)
        (self.root / "theirs").touch()
        _, said, _ = self.dev("test", "release", "host", FAKE_TESTS="ours", TMPDIR=str(self.root / "bin"))
        self.assertEqual([line for line in said.splitlines() if line.startswith("failed in")], ["failed in release: ours", "failed in host: ours"])
        self.assertEqual(list(self.root.glob("bin/tmp*")), [])

    def test_nobody_builds_without_the_lock(self) -> None:
        self.script("bin/cmake", WATCHES)
        for program in ("apt-get", "apt-config"):
            self.script(f"bin/{program}", "echo http://nowhere\n")
        self.script("bin/mmdebstrap", "! flock -n build/sysroot/armhf.lock true || echo sysroot >>unlocked\ntar -c -T /dev/null\n")
        for name in ("bin/run-clang-tidy", "hil/rig/make", "hil/outside/pack", "build/release/bin/isotouch"):
            self.script(name, "exit 0\n")
        for rung in ("desk", "processors", "outside", "bare_metal"):
            self.take(f"hil/{rung}/make")
        path = f"{self.root}/bin:{os.environ['PATH']}"
        self.call("dev", "tidy", PATH=path)
        self.call("dev", "test", "armhf", PATH=path)
        for rung in ("processors", "outside", "bare_metal"):   # the first one makes the desk, too
            self.call(f"hil/{rung}/make", "replay-arm64", "replay-arm64-trixie", "replay-armhf", "replay-riscv64", "replay-wasm32", PATH=path)
        asked = (self.root / "asked").read_text()
        for preset in ("release", "arm64", "arm64-trixie", "armhf", "riscv64", "wasm32", "cortex-m7"):
            self.assertIn(f"--preset {preset}\n--build build/{preset} --target ", asked)
        self.assertIn("--preset tidy\n", asked)
        self.assertIn("--workflow --preset armhf\n", asked)
        self.assertTrue((self.root / "build/sysroot/armhf/.content").exists())
        self.assertFalse((self.root / "unlocked").exists() and (self.root / "unlocked").read_text())

    def test_what_a_build_leaves_running_keeps_nobody_waiting(self) -> None:
        self.script("bin/cmake", 'sleep 30 >/dev/null 2>&1 & echo $! >>left\n')
        self.assertEqual(self.dev("build"), (0, "", ""))
        self.assertEqual(self.dev("build"), (0, "", ""))
        for process in (self.root / "left").read_text().split():
            os.kill(int(process), signal.SIGKILL)

    def test_clang_tidy_that_checks_nothing_fails(self) -> None:
        self.script("bin/run-clang-tidy", "exit 0\n")
        code, _, complaints = self.dev("tidy")
        self.assertEqual((code, complaints), (1, "clang-tidy checked no file; see build/tidy.log\n"))


if __name__ == "__main__":
    unittest.main()
