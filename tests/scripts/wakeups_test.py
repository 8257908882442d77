#!/usr/bin/env python3
"""What hil/wakeups promises, and hil/touch_demo."""

import unittest

import fakes
from lib import desk


def wakeups(*arguments: str, **environment: str) -> tuple[int, str]:
    return fakes.run("wakeups", "BIN", "a.itf", "b.itf", *(arguments or ("1", "1")), **{"FAKE_PRIORITY": "80", **environment})


@unittest.skipUnless(desk.gives_rights(), "this machine gives no real-time rights")
class WakeupsTest(unittest.TestCase):
    def test_a_tick_without_its_priority_fails_the_script(self) -> None:
        code, said = wakeups(FAKE_PRIORITY="79")
        self.assertEqual(code, 1, said)
        self.assertIn("the tick's thread has no real-time priority of 80", said)

    def test_a_good_run_prints_ratios(self) -> None:
        code, said = wakeups()
        self.assertEqual(code, 0, said)
        self.assertIn("1     cyclictest        0.0      0.0       0.0", said)
        self.assertIn("controller (uploads) / cyclictest, median and quartiles of 1 rounds of 1 s:\n  p50    1500.00 (1500.00 to 1500.00)", said)
        self.assertNotIn("LEFT BEHIND", said)

    def test_a_stream_is_shown_beside_a_quiet_controller(self) -> None:
        code, said = wakeups()
        self.assertEqual(code, 0, said)
        self.assertRegex(said, r"1     stream     +1\.5      1\.5       1\.5\n")
        self.assertRegex(said, r"wake-ups later than +quiet +uploads +stream\n +5 us +0\.0000 % +0\.0000 % +0\.0000 %\n")
        self.assertIn("the tick's thread: 0 allocations, 0 page faults in ", said)

    def test_a_wake_up_counts_by_its_bound(self) -> None:
        script = fakes.load("wakeups")
        self.assertEqual([script.later_than(script.Counter({2.0: 3, 20.0: 1}), bound) for bound in (1, 2, 19.9, 20)], [1.0, 0.25, 0.25, 0.0])

    def test_an_allocation_fails_the_script(self) -> None:
        script = fakes.load("wakeups")
        before, after = script.Loop(script.Counter({1.0: 1}), 4, 7), script.Loop(script.Counter({1.0: 3}), 5, 7)
        self.assertEqual(after.since(before), script.Loop(script.Counter({1.0: 2}), 1, 0))
        for what in ("allocations", "page_faults"):
            code, said = wakeups(FAKE_GROWS=what)
            self.assertEqual(code, 1, said)
            self.assertIn("quiet: the tick's thread allocated ", said)

    def test_a_child_that_fails_fails_the_script(self) -> None:
        for child in ("cyclictest", "falcon-sim", "isotouchd", "upload", "latency", "export", "stream"):
            with self.subTest(child):
                code, said = wakeups(FAKE_FAILS=child)
                self.assertEqual(code, 1, said)
                self.assertIn("did not start" if child in ("falcon-sim", "isotouchd") else "it is meant to fail", said)
                self.assertNotIn("LEFT BEHIND", said)

    def test_a_number_that_is_none_is_wrong_usage(self) -> None:
        self.assertEqual(wakeups("-1")[0], 2)

    def test_a_quantile_is_the_bound_that_reaches_its_share(self) -> None:
        script = fakes.load("wakeups")
        self.assertEqual(script.quantiles({2.0: 9, 1.0: 990, 9.0: 1}), (1.0, 1.0, 2.0))
        with self.assertRaises(script.Failure):
            script.quantiles({})

    def test_delays_beyond_the_range_count_at_its_end(self) -> None:
        said = "# Histogram\n000001 000002\n# Histogram Overflows: 00003\n"
        self.assertEqual(fakes.load("wakeups").cyclictest_histogram(said), {0.001: 2, 2000.0: 3})

    def test_quartiles_are_interpolated(self) -> None:
        self.assertEqual(fakes.load("wakeups").summary([4.0, 1.0, 2.0, 3.0], 2), "2.50 (1.75 to 3.25)")


class TouchDemoTest(unittest.TestCase):
    def test_a_child_that_fails_fails_the_script(self) -> None:
        for child in ("", "falcon-sim", "isotouchd", "upload", "record", "status", "latency", "replay"):
            with self.subTest(child):
                code, said = fakes.run("touch_demo", "BIN", "a.itf", "BIN", FAKE_FAILS=child)
                self.assertEqual(code, 1 if child else 0, said)

    def test_without_its_arguments_it_says_its_usage(self) -> None:
        self.assertEqual(fakes.run("touch_demo", "BIN")[0], 2)


if __name__ == "__main__":
    unittest.main()
