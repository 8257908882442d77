#!/usr/bin/env python3
"""hil/rig/fetch asks for the lists of packages until they have come whole, with programs that are made here."""

from __future__ import annotations

import os
import shutil
import unittest

import fakes


class FetchTest(fakes.Tree):
    def test_a_list_that_came_in_part_is_none(self) -> None:
        shutil.copy(fakes.ROOT / "hil/rig/fetch", self.root / "hil/rig/fetch")
        self.script("bin/apt-get", 'case $* in indextargets*) echo http://nowhere ;; *update) echo updated >&2 ;; esac\n')
        self.script("bin/apt-cache", 'echo "$@"\n')
        lists = self.root / "apt/lists"

        def asks() -> bool:
            code, said, complaints = self.call("hil/rig/fetch", str(self.root / "apt"), "bookworm", "arm64", "show", "udev",
                                               PATH=f"{self.root}/bin:{os.environ['PATH']}")
            self.assertEqual((code, said), (0, "show udev\n"), complaints)
            return complaints == "updated\n"

        self.assertTrue(asks(), "there is no list")
        (lists / "partial/nowhere_dists_bookworm_main_binary-arm64_Packages.xz").touch()
        self.assertTrue(asks(), "the list came in part")
        whole = lists / "nowhere_dists_bookworm_main_binary-arm64_Packages"
        whole.touch()
        self.assertFalse(asks(), "the list is whole")
        os.utime(whole, (0, 0))
        self.assertTrue(asks(), "the list is old")


if __name__ == "__main__":
    unittest.main()
