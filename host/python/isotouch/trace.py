"""Recordings as arrays."""

from __future__ import annotations

import ctypes
import os
import warnings
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from isotouch._library import ArgumentError, CTraceFacts, Handle, MissingError, call, core, path_bytes, text_bytes


class CutOffWarning(UserWarning):
    """The file of a trace ends before it should."""


@dataclass(frozen=True)
class TraceFacts:
    """What a trace says of itself."""

    ticks: int
    period_ns: int
    has_packets: bool
    """packets of a device; else positions of a hand"""
    has_outputs: bool
    """forces, proxies and commands are recorded"""
    is_cut_off: bool
    """the file ends before it should; the whole ticks of it are there"""
    field_hash: str
    """of the field that was touched; '' where none is named"""
    replay_hash: str
    """the chain after the last tick; '' without outputs"""


class _Trace(Handle):
    def __init__(self, path: str | os.PathLike[str]) -> None:
        handle = ctypes.c_uint64()
        call("trace_load", path_bytes(path), ctypes.byref(handle))
        super().__init__(handle.value)

    def facts(self) -> TraceFacts:
        found = CTraceFacts()
        call("trace_describe", self._handle, ctypes.byref(found), ctypes.sizeof(found))
        return TraceFacts(
            ticks=found.ticks, period_ns=found.period_ns, has_packets=bool(found.has_packets), has_outputs=bool(found.has_outputs),
            is_cut_off=bool(found.is_cut_off), field_hash=f"{found.field_hash:016x}" if found.field_hash else "",
            replay_hash=f"{found.replay_hash:016x}" if found.replay_hash else "")

    def column(self, name: str, is_integer: bool, ticks: int) -> npt.NDArray[np.generic]:
        values: npt.NDArray[np.generic] = np.zeros(ticks, np.int64 if is_integer else np.float64)
        call("trace_integers" if is_integer else "trace_doubles", self._handle, text_bytes(name, "the column"), 0, ticks, values.ctypes.data)
        return values.view(np.uint64) if name == "chain" else values


def _columns() -> dict[str, bool]:
    """The name of each column, and whether it holds whole numbers."""
    known: dict[str, bool] = {}
    for number in range(core().isotouch_trace_columns()):
        is_integer = ctypes.c_uint32()
        name: bytes = core().isotouch_trace_column(number, ctypes.byref(is_integer))
        known[name.decode()] = is_integer.value == 1
    return known


def describe_trace(path: str | os.PathLike[str]) -> TraceFacts:
    """Raises DataError."""
    with _Trace(path) as trace:
        return trace.facts()


def load_trace(path: str | os.PathLike[str], columns: Iterable[str] | None = None) -> npt.NDArray[np.void]:
    """A trace as a structured array, one element a tick.

    columns   their names, as `isotouch trace show --columns` knows them, all but `packet`; None: all that this trace has
    Whole numbers are int64, hashes uint64, all others float64. A value that a single tick lacks is -1.

    Warns (CutOffWarning) of a file that ends before it should; its whole ticks are returned.

    Raises DataError, ArgumentError for a column that nobody knows, and MissingError for one that this trace does not have.
    """
    known = _columns()
    wanted = None if columns is None else list(columns)
    for name in wanted or ():
        if not isinstance(name, str) or name not in known:
            raise ArgumentError(f"no column is named {name!r}; choose among {', '.join(known)}")
    with _Trace(path) as trace:
        facts = trace.facts()
        if facts.is_cut_off:
            warnings.warn(f"{os.fspath(path)!s}: the file is cut off; its {facts.ticks} whole ticks are returned", CutOffWarning, stacklevel=2)
        ticks = facts.ticks
        found: dict[str, npt.NDArray[np.generic]] = {}
        for name in known if wanted is None else wanted:
            try:
                found[name] = trace.column(name, known[name], ticks)
            except MissingError:
                if wanted is not None:
                    raise
    table = np.zeros(ticks, np.dtype([(name, values.dtype) for name, values in found.items()]))
    for name, values in found.items():
        table[name] = values
    return table
