#!/usr/bin/env python3
"""The Python module, on the library that ISOTOUCH_LIBRARY names: module_test.py FOLDER_OF_GOLDEN_FILES"""

from __future__ import annotations

import copy
import ctypes
import gc
import os
import pickle
import re
import shutil
import subprocess
import sys
import tempfile
import threading
import unittest
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

import isotouch
from isotouch._library import build, check

Numbers = npt.NDArray[np.float64]
GOLDEN = Path(sys.argv.pop()) if len(sys.argv) > 1 else Path()
FIELD = GOLDEN / "field_1_1.itf"


def ball(count: int = 2000, radius: float = 25.0) -> Numbers:
    """Points of a sphere, evenly spread; divided by the radius they are its normals."""
    number = np.arange(count) + 0.5
    height, turn = 1 - 2 * number / count, np.pi * (1 + 5**0.5) * number
    around = np.sqrt(1 - height**2)
    points: Numbers = radius * np.stack([around * np.cos(turn), height, around * np.sin(turn)], axis=1)
    return points


def way_in(field: isotouch.Field, ticks: int = 500) -> Numbers:
    low, high = np.array(field.facts.low_mm), np.array(field.facts.high_mm)
    middle = (low + high) / 2
    path: Numbers = np.linspace([middle[0], high[1], middle[2]], middle, ticks)
    return path


class FieldTest(unittest.TestCase):
    def test_points_become_the_ball_that_they_came_from(self) -> None:
        points = ball()
        field = isotouch.Field.build(points, points / 25, mm_per_unit=1, grid=48)
        self.assertEqual(field.facts.scale, 1.0)
        places = np.array([[0.0, 25.5, 0.0], [0.0, 24.0, 0.0], [0.0, 0.0, 25.0], [25.2, 0.0, 0.0]]) + field.facts.offset_mm
        samples = field.sample(places)
        np.testing.assert_allclose(samples.distance_mm, [0.5, -1.0, 0.0, 0.2], atol=0.05)
        np.testing.assert_allclose(samples.gradient[0], [0, 1, 0], atol=0.05)
        np.testing.assert_allclose(samples.stiffness_n_mm, 0.8, atol=1e-4)
        self.assertTrue(samples.in_band.all())

    def test_a_built_field_is_saved_loaded_and_the_same_again(self) -> None:
        points = ball(1000)
        first, second = (isotouch.Field.build(points, points / 25, grid=32, threads=threads) for threads in (1, 2))
        self.assertEqual(first.facts.hash, second.facts.hash)
        with tempfile.TemporaryDirectory() as folder:
            first.save(Path(folder) / "ball.itf")
            self.assertEqual(isotouch.Field.load(Path(folder) / "ball.itf").facts, first.facts)
            self.assertEqual(isotouch.Field.read((Path(folder) / "ball.itf").read_bytes()).facts, first.facts)

    def test_normals_that_are_missing_are_estimated_and_that_is_said(self) -> None:
        field = isotouch.Field.build(ball(1000), grid=32)
        self.assertIn("normals were estimated from the points", field.warnings)

    def test_a_scan_of_nothing_is_refused_with_its_reasons(self) -> None:
        random = np.random.default_rng(1)
        points, normals = random.uniform(-30, 30, (500, 3)), random.normal(size=(500, 3))
        normals /= np.linalg.norm(normals, axis=1, keepdims=True)
        with self.assertRaisesRegex(isotouch.DataError, "points: "):
            isotouch.Field.build(points, normals, grid=32)

    def test_sentences_name_arguments_and_no_options_of_the_command(self) -> None:
        points = ball(300)
        fine = isotouch.Field.build(points, points / 25, grid=200)
        self.assertRegex(" ".join(fine.warnings), r"; grid \d+ shows as much")
        x, y = np.meshgrid(np.arange(20.0), np.arange(20.0))
        with self.assertRaisesRegex(isotouch.DataError, "the sensor's place with viewpoint, or scan all round"):
            isotouch.Field.build(np.stack([x.ravel(), y.ravel(), 0.01 * x.ravel() * y.ravel()], axis=1), grid=32)
        normals = np.random.default_rng(1).normal(size=points.shape)
        normals /= np.linalg.norm(normals, axis=1, keepdims=True)
        with self.assertRaisesRegex(isotouch.DataError, "or try no normals or viewpoint; ") as refused:
            isotouch.Field.build(points, normals, grid=32)
        self.assertNotIn("--", str(refused.exception))

    def test_wrong_sizes_types_and_numbers_are_errors(self) -> None:
        points = ball(100)
        wrong: dict[str, dict[str, Any]] = {
            "shape": {"points": points.ravel()},
            r"shape \(n, 3\)": {"points": points[:, :2]},
            "there are 100 points and 99 normals": {"normals": points[:99]},
            "there are 100 points and 3 stiffness": {"stiffness": [1.0, 1.0, 1.0]},
            "complex128": {"points": points.astype(complex)},
            "bool": {"points": points > 0},
            "object": {"points": points.astype(object)},
            "different lengths": {"points": [[0, 0, 0], [1, 1]]},
            "not finite": {"points": np.where(points > 24, np.nan, points)},
            "normals: number 0": {"normals": np.full((100, 3), np.inf)},
            "band": {"band": 9},
            "voxel_mm": {"voxel_mm": np.nan},
            "grid is 3.5": {"grid": 3.5},
            "grid": {"grid": 4},
            "grid is -1": {"grid": -1},
            "interpolation": {"interpolation": "cubic"},
            "accept_implausible is 'no'": {"accept_implausible": "no"},
            "accept_implausible is 2": {"accept_implausible": 2},
            "viewpoint has 2 numbers": {"viewpoint": [0, 0]},
            "viewpoint: its three numbers must lie within ±1e100": {"viewpoint": [0, 0, 2e100]},
        }
        for words, change in wrong.items():
            with self.subTest(words), self.assertRaisesRegex(isotouch.ArgumentError, words):
                arguments: dict[str, Any] = {"points": points, "normals": points / 25, **change}
                isotouch.Field.build(**arguments)
        longer = points / 25
        longer[99] *= 3
        with self.assertRaisesRegex(isotouch.DataError, r"^points: point 99 \(counted from 0\): the normal has length 3\.0"):
            isotouch.Field.build(points, longer)
        with self.assertRaises(isotouch.DataError):
            isotouch.Field.build(points[:3], points[:3] / 25)
        with self.assertRaises(isotouch.DataError):
            isotouch.Field.build(points, points / 2500)

    def test_masked_values_are_an_error(self) -> None:
        with self.assertRaisesRegex(isotouch.ArgumentError, "masked"):
            isotouch.Field.load(FIELD).sample(np.ma.MaskedArray([[0.0, 0, 0]], [[True, False, False]]))   # type: ignore[no-untyped-call]

    def test_masked_values_within_lists_are_an_error(self) -> None:
        row: Any = np.ma.MaskedArray([0.0, 0, 0], [True, False, False])   # type: ignore[no-untyped-call]
        whole: Any = np.ma.MaskedArray([0.0, 0, 0], [False, False, False])   # type: ignore[no-untyped-call]
        field = isotouch.Field.load(FIELD)
        places: list[Any] = [[whole, row], (row,), [[0.0, 1.0, 2.0], [3.0, np.ma.masked, 4.0]]]
        for wrong in places:
            with self.subTest(wrong), warnings.catch_warnings(), self.assertRaisesRegex(isotouch.ArgumentError, "masked"):
                warnings.simplefilter("ignore")   # numpy's own
                field.sample(wrong)
        self.assertEqual(field.sample([whole, [1.0, 2.0, 3.0]]).distance_mm.shape, (2,))

    def test_samples_of_single_precision_and_whole_numbers_are_those_of_doubles(self) -> None:
        field = isotouch.Field.load(FIELD)
        whole = np.array([[0, 20, 0], [3, 10, -4]])
        for kind in (np.int32, np.float32, np.uint8):
            np.testing.assert_array_equal(field.sample(np.abs(whole).astype(kind)).distance_mm, field.sample(np.abs(whole).astype(float)).distance_mm)
        turned = np.asfortranarray(way_in(field))
        np.testing.assert_array_equal(field.sample(turned).distance_mm, field.sample(way_in(field)).distance_mm)
        self.assertEqual(field.sample([]).distance_mm.shape, (0,))
        self.assertEqual(field.sample(np.zeros((0, 3))).gradient.shape, (0, 3))

    def test_rows_of_nothing_are_no_points(self) -> None:
        field = isotouch.Field.load(FIELD)
        for shape in ((600, 0), (1, 0), (0, 0), (0, 2), (0, 3, 1)):
            words = re.escape(f"points_mm has shape {shape} and must be an array of shape (n, 3)")
            with self.subTest(shape), self.assertRaisesRegex(isotouch.ArgumentError, words):
                field.sample(np.zeros(shape))
        with self.assertRaisesRegex(isotouch.ArgumentError, "must be a list of numbers"):
            isotouch.Field.build(ball(100), stiffness=np.zeros((100, 0)))

    def test_files_that_are_no_fields_are_refused(self) -> None:
        for path in ("/nowhere.itf", str(GOLDEN / "positions.trace"), ""):
            with self.assertRaises((isotouch.DataError, isotouch.ArgumentError)):
                isotouch.Field.load(path)
        with self.assertRaisesRegex(isotouch.ArgumentError, "holds a zero"):
            isotouch.Field.load("a\0b")
        with self.assertRaises(isotouch.DataError):
            isotouch.Field.read(b"")


class TouchTest(unittest.TestCase):
    def test_a_path_is_felt_and_its_trace_is_the_same(self) -> None:
        field = isotouch.Field.load(FIELD)
        with tempfile.TemporaryDirectory() as folder:
            felt = field.touch(way_in(field), isotouch.Settings(friction=0.3), save=Path(folder) / "felt.trace")
            trace, facts = isotouch.load_trace(Path(folder) / "felt.trace"), isotouch.describe_trace(Path(folder) / "felt.trace")
        self.assertEqual(felt["contact"][0], 0)
        self.assertEqual(felt["contact"][-1], 1)
        self.assertGreater(felt["force_n"][-1, 1], 0)
        self.assertEqual(facts.ticks, 500)
        self.assertEqual(facts.field_hash, field.facts.hash)
        for axis, name in enumerate("xyz"):
            np.testing.assert_array_equal(felt["force_n"][:, axis], trace[f"force_{name}_n"])
            np.testing.assert_array_equal(felt["proxy_mm"][:, axis], trace[f"proxy_{name}_mm"])

    def test_tick_by_tick_is_the_same_to_the_bit(self) -> None:
        field = isotouch.Field.load(FIELD)
        whole = field.touch(way_in(field))
        with field.begin() as touch:
            for tick, hip in enumerate(way_in(field)):
                self.assertEqual(touch.position(hip), whole[tick])

    def test_a_device_becomes_active_stops_and_resumes(self) -> None:
        with isotouch.Field.load(FIELD).begin(isotouch.Settings(device="martin-hillier", record_ticks=100)) as touch:
            states = [isotouch.state_name(touch.counts([0, 0, 0], homed=homed)["state"]) for homed in [0] * 2 + [7] * 30]
            self.assertEqual((states[0], states[-1]), ("homing", "active"))
            touch.stop()
            self.assertEqual(isotouch.state_name(touch.counts([0, 0, 0])["state"]), "fault")
            touch.resume()
            self.assertNotEqual(isotouch.state_name(touch.counts((0, 0, 0))["state"]), "fault")
            self.assertEqual(touch.missed()["tick"], 34)
            with tempfile.TemporaryDirectory() as folder:
                self.assertEqual(touch.save(Path(folder) / "a.trace"), 35)
                self.assertIn("command_1", isotouch.load_trace(Path(folder) / "a.trace").dtype.names or ())

    def test_wrong_arguments_are_errors(self) -> None:
        field = isotouch.Field.load(FIELD)
        for settings, words in (
            (isotouch.Settings(friction=2), "friction is 2"),
            (isotouch.Settings(friction=float("nan")), "friction"),
            (isotouch.Settings(device="phantom"), "device"),
            (isotouch.Settings(period_ns=-1), "period_ns is -1"),
            (isotouch.Settings(ramp_ticks=2.5), "a whole number"),  # type: ignore[arg-type]
            (isotouch.Settings(stiffness="hard"), "must be a number"),  # type: ignore[arg-type]
        ):
            with self.subTest(words), self.assertRaisesRegex(isotouch.ArgumentError, words):
                field.begin(settings)
        with self.assertRaisesRegex(isotouch.DataError, "too stiff"):
            field.begin(isotouch.Settings(stiffness=50, device_damping=0.003))
        touch = field.begin()
        hips: list[Any] = [[0, 0], [0, 0, np.nan], [[0, 0, 0]], "abc", [0, 0, 1j]]
        for hip in hips:
            with self.assertRaises(isotouch.ArgumentError):
                touch.position(hip)
        legs: list[Any] = [[0, 0], [0, 0, 0.5], [0, 0, 40000], [0, 0, 2**40]]
        for counts in legs:
            with self.assertRaises(isotouch.ArgumentError):
                touch.counts(counts)
        with self.assertRaises(isotouch.ArgumentError):
            touch.path(np.array([[0, 0, 0], [0, 0, np.inf]]))
        self.assertEqual(touch.position([0, 60, 0])["tick"], 0)
        with self.assertRaisesRegex(isotouch.ArgumentError, "begun with positions"):
            touch.counts([0, 0, 0])
        with self.assertRaisesRegex(isotouch.MissingError, "record_ticks"):
            touch.save("/tmp/never.trace")
        with self.assertRaises(isotouch.MissingError):
            field.touch(np.zeros((0, 3)), save="/tmp/never.trace")


class TraceTest(unittest.TestCase):
    def test_a_trace_that_is_cut_off_is_read_with_a_warning(self) -> None:
        with tempfile.TemporaryDirectory() as folder, warnings.catch_warnings():
            warnings.simplefilter("error")
            whole = isotouch.load_trace(GOLDEN / "positions.trace")
            cut = Path(folder) / "cut.trace"
            cut.write_bytes((GOLDEN / "positions.trace").read_bytes()[:-50])
            with self.assertRaisesRegex(isotouch.CutOffWarning, rf"cut\.trace: the file is cut off; its {len(whole) - 1} whole ticks are returned"):
                isotouch.load_trace(cut)
            warnings.simplefilter("ignore")
            self.assertEqual(len(isotouch.load_trace(cut)), len(whole) - 1)
            self.assertTrue(isotouch.describe_trace(cut).is_cut_off)

    def test_columns_are_those_that_the_trace_has(self) -> None:
        positions, packets = (isotouch.load_trace(GOLDEN / name) for name in ("positions.trace", "packets.trace"))
        self.assertNotIn("state", positions.dtype.names or ())
        self.assertEqual(packets["chain"].dtype, np.uint64)
        self.assertEqual(packets["command_1"].dtype, np.int64)
        self.assertEqual(packets["force_x_n"].dtype, np.float64)
        np.testing.assert_array_equal(packets["tick"], np.arange(len(packets)))
        some = isotouch.load_trace(GOLDEN / "packets.trace", columns=["force_y_n", "tick"])
        self.assertEqual(some.dtype.names, ("force_y_n", "tick"))
        np.testing.assert_array_equal(some["force_y_n"], packets["force_y_n"])
        self.assertEqual(f"{packets['chain'][-1]:016x}", isotouch.describe_trace(GOLDEN / "packets.trace").replay_hash)

    def test_names_of_columns_may_come_one_by_one(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "felt.trace"
            field = isotouch.Field.load(FIELD)
            field.touch(way_in(field, 10), save=file)
            columns = isotouch.load_trace(file).dtype.names or ()
            self.assertEqual(isotouch.load_trace(file, (name for name in columns[:3])).dtype.names, columns[:3])
            self.assertEqual(isotouch.load_trace(file, []).dtype.names, ())

    def test_what_is_not_there_is_said(self) -> None:
        with self.assertRaisesRegex(isotouch.MissingError, "positions of a hand"):
            isotouch.load_trace(GOLDEN / "positions.trace", columns=["state"])
        with self.assertRaisesRegex(isotouch.ArgumentError, "choose among tick"):
            isotouch.load_trace(GOLDEN / "positions.trace", columns=["colour"])
        with self.assertRaisesRegex(isotouch.ArgumentError, "packet"):   # the one that `isotouch trace show` has besides
            isotouch.load_trace(GOLDEN / "packets.trace", columns=["packet"])
        for path in ("/nowhere.trace", str(FIELD)):
            with self.assertRaises(isotouch.DataError):
                isotouch.load_trace(path)


class HandleTest(unittest.TestCase):
    def test_what_is_closed_is_an_error_and_closing_twice_is_none(self) -> None:
        field = isotouch.Field.load(FIELD)
        touch = field.begin()
        field.close()
        field.close()
        places: list[npt.ArrayLike] = [[[0, 0, 0]], []]
        for points in places:
            with self.assertRaises(isotouch.ClosedError):
                field.sample(points)
        with self.assertRaises(isotouch.ClosedError):
            field.begin()
        self.assertEqual(touch.position([0, 60, 0])["tick"], 0)   # it keeps what it needs
        with touch:
            pass
        uses: list[Callable[[], object]] = [touch.missed, lambda: touch.position([0, 0, 0]), lambda: touch.path([[0, 0, 0]]), touch.stop, lambda: touch.save("/tmp/never.trace")]
        for use in uses:
            with self.assertRaises(isotouch.ClosedError):
                use()

    def test_what_only_this_process_knows_is_neither_copied_nor_pickled(self) -> None:
        field = isotouch.Field.load(FIELD)
        for thing in (field, field.begin()):
            uses: tuple[Callable[[object], object], ...] = (copy.copy, copy.deepcopy, pickle.dumps)
            for use in uses:
                with self.assertRaisesRegex(TypeError, "neither copied nor pickled"):
                    use(thing)
        self.assertEqual(len(field.sample([[0, 0, 0]]).distance_mm), 1)

    def test_bits_have_the_values_of_the_header(self) -> None:
        header = (GOLDEN.resolve().parents[1] / "host/library/isotouch.h").read_text()
        for prefix, bits in (("STATUS", isotouch.Status), ("FAULT", isotouch.Fault)):
            promised = {name: 1 << int(bit) for name, bit in re.findall(rf"ISOTOUCH_{prefix}_(\w+) = 1 << (\d+)", header)}
            self.assertEqual({bit.name: bit.value for bit in bits}, promised)

    def test_the_options_of_the_first_version_are_taken(self) -> None:
        size = 88   # of isotouch_build_options in 0.9.0
        room = (ctypes.c_uint8 * (size + 256))(*[0xA5] * (size + 256))
        points, handle = np.ascontiguousarray(ball(1000)), ctypes.c_uint64()
        check(build().isotouch_build_default(room, size))
        check(build().isotouch_build(len(points), points.ctypes.data, None, None, room, size, ctypes.byref(handle), None, 0))
        isotouch.Field(handle.value).close()
        self.assertEqual(bytes(room)[size:], b"\xa5" * 256)
        with self.assertRaisesRegex(isotouch.ArgumentError, "isotouch_build_options is a null pointer"):
            check(build().isotouch_build(len(points), points.ctypes.data, None, None, None, size, ctypes.byref(handle), None, 0))

    def test_more_than_there_is_room_for_is_one_of_our_errors_and_a_memory_error(self) -> None:
        field, touches = isotouch.Field.load(FIELD), []
        with self.assertRaisesRegex(isotouch.NoMemoryError, "4096 handles") as refused:
            while True:
                touches.append(field.begin())
        self.assertIsInstance(refused.exception, isotouch.IsotouchError)
        self.assertIsInstance(refused.exception, MemoryError)
        self.assertGreater(len(touches), 3000)

    def test_what_is_no_number_of_a_state_is_an_error(self) -> None:
        wrong: list[Any] = ["boot", None, -1, 2**32, 4.5]
        for state in wrong:
            with self.subTest(state), self.assertRaises(isotouch.ArgumentError):
                isotouch.state_name(state)

    def test_forgotten_things_free_themselves(self) -> None:
        for _ in range(5000):   # more than there are handles
            isotouch.Field.load(FIELD).begin() if _ % 10 == 0 else None
        gc.collect()
        isotouch.Field.load(FIELD)

    def test_threads_may_sample_one_field(self) -> None:
        field, right = isotouch.Field.load(FIELD), []
        path = way_in(field, 2000)
        wanted = field.sample(path).distance_mm

        def sample() -> None:
            right.append(all(np.array_equal(field.sample(path).distance_mm, wanted) for _ in range(20)))

        threads = [threading.Thread(target=sample) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(right, [True] * 4)

    def test_a_library_that_is_not_there_is_a_sentence(self) -> None:
        said = subprocess.run([sys.executable, "-c", "import isotouch; isotouch.version()"], env={"ISOTOUCH_LIBRARY": "/nowhere/libisotouch.so.0", "PYTHONPATH": ":".join(sys.path)},
                              capture_output=True, text=True, check=False)
        self.assertEqual(said.returncode, 1)
        self.assertIn("set ISOTOUCH_LIBRARY", said.stderr.splitlines()[-1])

    def test_the_library_that_is_named_is_the_one_that_is_loaded(self) -> None:
        library = Path(os.environ["ISOTOUCH_LIBRARY"]).resolve()
        show = ("from isotouch._library import build, core; core(), build()\n"
                "for file in {line.split()[-1] for line in open('/proc/self/maps')}:\n"
                "    if 'libisotouch' in file: print(file)")
        paths = ":".join(map(os.path.abspath, sys.path))
        with tempfile.TemporaryDirectory() as folder:
            own = Path(folder).resolve() / "my_libisotouch.so"
            shutil.copy(library, own)
            shutil.copy(library.with_name("libisotouch_build.so.0"), folder)
            for named, core in (("my_libisotouch.so", own), (str(own), own), (str(library), library)):
                with self.subTest(named):
                    loaded = subprocess.run([sys.executable, "-c", show], env={"ISOTOUCH_LIBRARY": named, "PYTHONPATH": paths}, cwd=folder,
                                            capture_output=True, text=True, check=True).stdout.split()
                    self.assertIn(str(core), loaded)
                    self.assertEqual(len(loaded), 2)

    def test_wrong_addresses_are_sentences(self) -> None:
        with self.assertRaisesRegex(isotouch.ControllerError, "start isotouchd"):
            isotouch.Controller("unix:/nowhere/control")
        with self.assertRaisesRegex(isotouch.ArgumentError, "timeout"):
            isotouch.Controller("unix:/nowhere/control", timeout=0)


if __name__ == "__main__":
    unittest.main()
