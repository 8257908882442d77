#!/usr/bin/env python3
"""Buffers of any kind into the Python module: each call gives finite numbers, the same as for a plain array, or raises what it documents.

    buffers_test.py FOLDER_OF_GOLDEN_FILES [CALLS [SEED]]
"""

from __future__ import annotations

import gc
import random
import sys
import unittest
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

import isotouch
from isotouch._library import reals

CALLS, SEED = 3000, 1
GOLDEN = Path()

DTYPES = ["<f8", ">f8", "<f4", ">f4", "<f2", "<i8", ">i2", "<u8", "<u1", "?", "<c16", "O", "<U4", "S4", "<M8[s]", "<f8,<f8", "<g"]
SHAPES = [(), (0,), (1,), (2,), (3,), (4,), (0, 3), (1, 3), (5, 3), (3, 5), (5, 4), (5, 0), (0, 0), (2, 3, 1), (1, 1, 3), (0, 3, 7), (100, 3), (1, 0, 3)]
ODD = [np.nan, np.inf, -np.inf, 1e300, -1e300, 5e-324, -0.0, 2.0**53, 2.0**63]


def filled(chance: random.Random, shape: tuple[int, ...], dtype: str) -> np.ndarray[Any, Any]:
    """Places near the field in this type; now and then a number that is odd."""
    array: np.ndarray[Any, Any] = np.zeros(shape, dtype)
    if array.dtype.kind in "fiuc":
        values = np.array([chance.uniform(-40, 40) for _ in range(array.size)]).reshape(shape)
        if array.dtype.kind == "u":
            values = np.abs(values)
        if values.size and array.dtype.kind == "f" and chance.random() < 0.3:
            values.reshape(-1)[chance.randrange(values.size)] = chance.choice(ODD)
        with np.errstate(over="ignore"):
            array[...] = values
    elif array.dtype.kind == "O":
        array.fill(chance.choice([None, "x", 1.5, [], 10**400]))
    return array


def laid_out(chance: random.Random, array: np.ndarray[Any, Any]) -> Any:
    """The same values, otherwise in memory or in another container."""
    way = chance.randrange(12)
    if way == 0:
        return np.asfortranarray(array)
    if way == 1 and array.ndim:   # backwards
        return array[::-1].copy()[::-1]
    if way == 2 and array.ndim:   # every other one
        wide = np.repeat(array, 2, axis=array.ndim - 1)
        return wide[..., ::2]
    if way == 3:
        array.flags.writeable = False
        return array
    if way == 4 and array.ndim:   # one row for all
        return np.broadcast_to(array[:1], array.shape)
    if way == 5 and array.nbytes:   # at an odd address
        room = np.zeros(array.nbytes + 1, np.uint8)
        try:
            moved = room[1:].view(array.dtype).reshape(array.shape)
        except (ValueError, TypeError):   # objects cannot be moved so
            return array
        moved[...] = array
        return moved
    if way == 6:
        return array.tolist()
    if way == 7 and array.ndim:
        return list(array)
    if way == 8:
        return np.ma.masked_array(array)  # type: ignore[no-untyped-call]
    if way == 9 and array.dtype.kind in "fiu":
        try:
            return array.data
        except (ValueError, TypeError, BufferError):
            return array
    if way == 10 and array.ndim == 2 and array.dtype.kind in "fiu":
        return np.asmatrix(array)
    if way == 11:
        return chance.choice([None, "text", b"bytes", 3, 1.5, object(), {}, [[1, 2], [3]], [[1, 2, 3], None], range(3), iter([1, 2, 3]), [[], []]])
    return array


def plain(values: Any) -> np.ndarray[Any, np.dtype[np.float64]]:
    return np.array(np.asarray(values), dtype=np.float64, order="C")


class Buffers(unittest.TestCase):
    def setUp(self) -> None:
        self.chance = random.Random(SEED)
        self.field = isotouch.Field.load(GOLDEN / "field_1_1.itf")
        self.outcomes: Counter[str] = Counter()

    def outcome(self, call: Callable[[Any], Any], values: Any) -> Any:
        """What a call returns, or None where it raises an error of the module; nothing else may be raised."""
        try:
            returned = call(values)
        except isotouch.IsotouchError as error:
            self.assertTrue(str(error), "an error has its sentence")
            self.outcomes[type(error).__name__] += 1
            return None
        self.outcomes["returned"] += 1
        return returned

    def each(self) -> Any:
        for _ in range(CALLS):
            values = filled(self.chance, self.chance.choice(SHAPES), self.chance.choice(DTYPES))
            yield laid_out(self.chance, values)

    def saw(self, *outcomes: str) -> None:
        """A test that has not seen each of these has tried nothing."""
        for name in outcomes:
            self.assertGreater(self.outcomes[name], CALLS // 100, f"{name} is too rare: {self.outcomes}")

    def saw_some(self, *outcomes: str) -> None:
        for name in outcomes:
            self.assertGreater(self.outcomes[name], 0, f"{name} has never come: {self.outcomes}")

    def test_samples(self) -> None:
        for values in self.each():
            samples = self.outcome(self.field.sample, values)
            if samples is None:
                continue
            self.assertTrue(all(np.isfinite(part).all() for part in samples))
            again = self.field.sample(plain(values).reshape(-1, 3))
            for part, same in zip(samples, again):
                np.testing.assert_array_equal(part, same)
        self.saw("returned", "ArgumentError")

    def test_numbers_at_odd_addresses_are_moved_for_c(self) -> None:
        room = np.zeros(31 * 8, np.uint8)
        shapes: list[tuple[tuple[int, ...], int | None]] = [((10, 3), 3), ((30,), None)]
        for shape, columns in shapes:
            for by in range(1, 8):
                odd = room[by:by + 240].view(np.float64).reshape(shape)
                odd[...] = np.arange(30.0).reshape(shape)
                passed = reals(odd, "numbers", columns)
                self.assertEqual(passed.ctypes.data % passed.itemsize, 0, f"moved by {by}")
                np.testing.assert_array_equal(passed, odd)

    def test_paths(self) -> None:
        for values in self.each():
            felt = self.outcome(self.field.touch, values)
            if felt is None:
                continue
            self.assertTrue(np.isfinite(felt["force_n"]).all() and np.isfinite(felt["proxy_mm"]).all())
            np.testing.assert_array_equal(felt, self.field.touch(plain(values).reshape(-1, 3)))
        self.saw("returned", "ArgumentError")

    def test_single_positions_and_counts(self) -> None:
        for values in self.each():
            for call in (lambda places: self.field.begin().position(places), lambda counts: self.field.begin().counts(counts)):
                felt = self.outcome(call, values)
                if felt is not None:
                    self.assertTrue(np.isfinite(felt["force_n"]).all())
        self.saw("returned", "ArgumentError")

    def test_numbers_of_settings(self) -> None:
        names = [name for name in isotouch.Settings.__dataclass_fields__ if name != "device"]
        odd = [*ODD, 0, 1, -1, 10**30, 10**400, True, None, "1", 1.5, np.float32(0.1), np.int8(3), np.array(1.0), np.array([1.0]), 1j]
        for _ in range(CALLS):
            wish = {self.chance.choice(names): self.chance.choice(odd) for _ in range(2)}
            self.outcome(lambda settings: self.field.begin(isotouch.Settings(**settings)).position([0, 0, 0]), wish)
        self.saw("returned", "ArgumentError")

    def test_points_that_a_field_is_built_of(self) -> None:
        for number, values in enumerate(self.each()):
            if number >= CALLS // 30:   # a field takes its time
                break
            self.outcome(lambda points: isotouch.Field.build(points, grid=8, accept_implausible=True), values)
            for name in ("normals", "stiffness", "viewpoint"):
                wrong: dict[str, Any] = {name: values}
                self.outcome(lambda what: isotouch.Field.build(np.zeros((9, 3)), grid=8, **what), wrong)
        self.saw_some("ArgumentError")

    def test_numbers_of_a_build(self) -> None:
        points = np.zeros((9, 3))
        odd: list[Any] = [*ODD, 0, -1, 10**30, 10**400, True, None, "1", np.float32(0.1), np.array([1.0]), 1j, [], {}]
        for name in ("stiffness_n_mm", "voxel_mm", "band", "fit_mm", "mm_per_unit", "grid", "threads", "interpolation"):
            for value in odd:
                wrong: dict[str, Any] = {name: value}
                self.outcome(lambda what: isotouch.Field.build(points, **what), wrong)
        self.assertGreater(self.outcomes["ArgumentError"], 50)

    def test_bytes_of_a_field(self) -> None:
        held = (GOLDEN / "field_1_1.itf").read_bytes()
        held += bytes(-len(held) % 8)
        wanted = self.outcome(isotouch.Field.read, held)
        for same in (bytearray(held), memoryview(held), np.frombuffer(held, np.uint8), np.frombuffer(held, "<f8"), memoryview(held).cast("H"), np.frombuffer(held * 2, np.uint8)[::2]):
            field = self.outcome(isotouch.Field.read, same)
            if isinstance(same, np.ndarray) and same.strides != (same.itemsize,):
                self.assertIsNone(field)   # other bytes
            else:
                self.assertEqual(field is None, wanted is None)
        for other in (3, 2**62, -1, None, "text", [1, 2], [], object(), held[:100], b"", np.zeros(3, "O")):
            self.assertIsNone(self.outcome(isotouch.Field.read, other))
        self.saw_some("ArgumentError", "DataError")

    def test_texts(self) -> None:
        odd: list[Any] = [3, b"/nowhere/a", "/nowhere/\udcff", "\ud800", "a\0b", "", "/nowhere/" + 5000 * "a", [], Path("/nowhere/a"), object()]
        touch = self.field.begin(isotouch.Settings(record_ticks=1))
        touch.position([0, 0, 0])
        for text in odd:
            calls: tuple[Callable[[Any], Any], ...] = (
                isotouch.Field.load, isotouch.load_trace, isotouch.describe_trace, touch.save, isotouch.Controller,
                         lambda name: isotouch.load_trace(GOLDEN / "positions.trace", [name]), lambda data: isotouch.Field.read(data))
            for call in calls:
                with self.subTest(f"{call} {text!r:.40}"):
                    self.assertIsNone(self.outcome(call, text))

    def test_things_that_were_closed(self) -> None:
        for values in self.each():
            field = isotouch.Field.load(GOLDEN / "field_1_1.itf") if self.chance.random() < 0.05 else self.field
            touch = field.begin()
            if field is not self.field:
                field.close()
            if self.chance.random() < 0.5:
                touch.close()
            uses: tuple[Callable[[Any], Any], ...] = (field.sample, touch.path, touch.position)
            for call in uses:
                self.outcome(call, values)
            if self.chance.random() < 0.01:
                gc.collect()
        self.saw("returned", "ArgumentError", "ClosedError")


if __name__ == "__main__":
    GOLDEN, CALLS, SEED = Path(sys.argv[1]), int((sys.argv[2:] + [str(CALLS)])[0]), int((sys.argv[3:] + [str(SEED)])[0])
    unittest.main(argv=sys.argv[:1])
