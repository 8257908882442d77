#!/usr/bin/env python3
"""What hil/starved promises before it starves anybody."""

import unittest

import fakes


class StarvedTest(unittest.TestCase):
    def test_a_number_that_is_none_is_wrong_usage(self) -> None:
        for arguments in (("0",), ("1", "x"), ("1", "2", "3"), ("1234567",)):
            self.assertEqual(fakes.run("starved", "BIN", "a.itf", "b.itf", *arguments)[0], 2)

    def test_a_tool_that_fails_fails_the_script_and_leaves_no_disk_mounted(self) -> None:
        code, said = fakes.run("starved", "BIN", "a.itf", "b.itf", FAKE_FAILS="info")
        self.assertEqual(code, 1, said)
        self.assertIn("starved: isotouch info", said)
        self.assertNotIn("LEFT BEHIND", said)


if __name__ == "__main__":
    unittest.main()
