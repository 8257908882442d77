#!/usr/bin/env python3
"""The disk that packaging/in_machine keeps is that of its scripts and of its packages' versions, with programs that are made here."""

from __future__ import annotations

import os
import shutil
import unittest

import fakes

FETCH = """mkdir -p "$1" && echo "deb http://nowhere $2 main" >"$1/sources.list"
case $4 in
  depends) echo "  Depends: linux-image-6-rt (= 6)" ;;
  download) touch kernel.deb ;;
  show) [ -z "${FAKE_NO_NETWORK-}" ] || exit 100
        shift 5 && for package; do printf 'Package: %s\\nVersion: %s\\nSize: 1\\n\\n' "$package" "${FAKE_VERSION:-1}"; done ;;
esac
"""
UNPACK = """mkdir -p "$3/boot" "$3/bin" "$3/lib/modules/6-rt"
touch "$3/boot/vmlinuz-6-rt" "$3/bin/busybox" "$3/lib/modules/6-rt/modules.order" "$3/lib/modules/6-rt/modules.builtin"
"""
DEBOOTSTRAP = """echo "$*" >>"$(dirname "$0")/../made"
while [ $# -gt 2 ]; do shift; done
mkdir -p "$1/etc"
"""


class InMachineTest(fakes.Tree):
    def setUp(self) -> None:
        super().setUp()
        (self.root / "packaging").mkdir()
        for name in ("in_machine", "with_each_start"):
            shutil.copy(fakes.ROOT / "packaging" / name, self.root / "packaging" / name)
        self.script("hil/rig/fetch", FETCH)
        for program, does in (("dpkg-deb", UNPACK), ("debootstrap", DEBOOTSTRAP), ("dpkg", "echo amd64\n"), ("cpio", "cat\n"), ("mkfs.ext4", ""), ("debugfs", ""),
                              ("depmod", ""), ("modprobe", ""), ("qemu-system-x86_64", "echo in_machine: said; echo in_machine ends with 7\n")):
            self.script(f"bin/{program}", does)
        (self.root / "room").mkdir()

    def made(self, packages: str = "udev", **environment: str) -> int:
        """How many disks were made until now, after one more run."""
        code, said, complaints = self.call("packaging/in_machine", "bookworm", "amd64", packages, str(self.root / "room"), "true",
                                           PATH=f"{self.root}/bin:{os.environ['PATH']}", **environment)
        log = self.root / "build/package/machines/bookworm-amd64.log"
        self.assertEqual((code, said), (7, "said\n"), complaints + log.read_text())
        return len((self.root / "made").read_text().splitlines())

    def test_a_disk_is_made_anew_when_what_it_is_made_of_changes(self) -> None:
        self.assertEqual((self.made(), self.made()), (1, 1))
        self.assertEqual((self.made(FAKE_VERSION="2"), self.made(FAKE_VERSION="2")), (2, 2), "a package in another version")
        self.assertEqual((self.made("udev,dbus"), self.made("udev,dbus")), (3, 3), "another package")
        for number, script in enumerate(("in_machine", "with_each_start"), 4):
            with (self.root / "packaging" / script).open("a") as file:
                file.write("# something else\n")
            self.assertEqual((self.made("udev,dbus"), self.made("udev,dbus")), (number, number), script)

    def test_without_its_packages_nothing_is_kept_or_made(self) -> None:
        self.made()
        code, said, _ = self.call("packaging/in_machine", "bookworm", "amd64", "udev", str(self.root / "room"), "true",
                                  PATH=f"{self.root}/bin:{os.environ['PATH']}", FAKE_NO_NETWORK="1")
        self.assertEqual((code, said), (1, ""))
        self.assertEqual(self.made(), 1)


if __name__ == "__main__":
    unittest.main()
