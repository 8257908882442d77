"""The C libraries: where they are found, their structures, and their errors as exceptions."""

from __future__ import annotations

import ctypes
import os
import sys
import weakref
from collections import deque
from functools import cache
from pathlib import Path
from types import TracebackType
from typing import Any, Self

import numpy as np
import numpy.typing as npt

Reals = npt.NDArray[np.float64]

CORE = "libisotouch.so.0"
BUILD = "libisotouch_build.so.0"


class IsotouchError(Exception):
    """What the library says when something fails, in one sentence."""


class ArgumentError(IsotouchError, ValueError):
    """A wrong size, shape or type, or a number that is not finite or out of range."""


class ClosedError(IsotouchError, ValueError):
    """It was closed."""


class BusyError(IsotouchError, RuntimeError):
    """Another thread is using it."""


class DataError(IsotouchError, ValueError):
    """A file cannot be read or written, or what is in it is refused."""


class MissingError(IsotouchError, LookupError):
    """This trace does not hold what was asked for."""


class ControllerError(IsotouchError, OSError):
    """The controller does not answer, or refuses."""


class NoMemoryError(IsotouchError, MemoryError):
    """There is not enough memory, or too much is open."""


TOO_SMALL = 6
_ERRORS: dict[int, type[IsotouchError]] = {
    1: ArgumentError, 2: ClosedError, 3: BusyError, 4: DataError, 5: MissingError, 7: ControllerError, 8: NoMemoryError,
}


class CFieldFacts(ctypes.Structure):
    _fields_ = [
        ("hash", ctypes.c_uint64),
        ("image_bytes", ctypes.c_uint64),
        ("low_mm", ctypes.c_double * 3),
        ("high_mm", ctypes.c_double * 3),
        ("voxel_mm", ctypes.c_double),
        ("band_mm", ctypes.c_double),
        ("stiffness_n_mm", ctypes.c_double),
        ("advised_stiffness_n_mm", ctypes.c_double),
        ("scale", ctypes.c_double),
        ("offset_mm", ctypes.c_double * 3),
        ("samples", ctypes.c_uint32 * 3),
        ("interpolation", ctypes.c_uint32),
        ("is_published", ctypes.c_uint32),
        ("varies_in_stiffness", ctypes.c_uint32),
    ]


class CSettings(ctypes.Structure):
    _fields_ = [
        ("record_ticks", ctypes.c_uint64),
        ("period_ns", ctypes.c_uint32),
        ("device", ctypes.c_uint32),
        *[
            (name, ctypes.c_double)
            for name in (
                "play_mm", "stiffness", "damping", "force_limit_n", "friction", "friction_damping", "hand_damping", "passivity_damping", "weight_n", "ramp_ticks",
                "device_damping", "delay_ticks",
            )
        ],
    ]


class CTraceFacts(ctypes.Structure):
    _fields_ = [
        ("ticks", ctypes.c_uint64),
        ("field_hash", ctypes.c_uint64),
        ("replay_hash", ctypes.c_uint64),
        ("period_ns", ctypes.c_uint32),
        ("has_packets", ctypes.c_uint32),
        ("has_outputs", ctypes.c_uint32),
        ("is_cut_off", ctypes.c_uint32),
    ]


class CBuildOptions(ctypes.Structure):
    _fields_ = [
        ("voxel_mm", ctypes.c_double),
        ("band", ctypes.c_double),
        ("stiffness_n_mm", ctypes.c_double),
        ("fit_mm", ctypes.c_double),
        ("mm_per_unit", ctypes.c_double),
        ("viewpoint", ctypes.c_double * 3),
        ("has_viewpoint", ctypes.c_uint32),
        ("grid", ctypes.c_uint32),
        ("interpolation", ctypes.c_uint32),
        ("threads", ctypes.c_uint32),
        ("accept_implausible", ctypes.c_uint32),
        ("reserved", ctypes.c_uint32),
    ]


ON_TICK = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_void_p)

_HANDLE, _SIZE, _TEXT, _POINTER = ctypes.c_uint64, ctypes.c_size_t, ctypes.c_char_p, ctypes.c_void_p
_U32, _U64 = ctypes.c_uint32, ctypes.c_uint64

_FUNCTIONS: dict[str, list[Any]] = {
    "free": [_HANDLE],
    "field_load": [_TEXT, _POINTER],
    "field_read": [_TEXT, _SIZE, _POINTER],
    "field_save": [_HANDLE, _TEXT],
    "field_describe": [_HANDLE, _POINTER, _SIZE],
    "field_sample": [_HANDLE, _SIZE, _POINTER, _POINTER, _POINTER, _POINTER, _POINTER],
    "settings_default": [_POINTER, _SIZE],
    "touch_new": [_HANDLE, _POINTER, _SIZE, _POINTER],
    "touch_position": [_HANDLE, _POINTER, _U32, _POINTER, _SIZE],
    "touch_counts": [_HANDLE, _POINTER, _U32, _U32, _POINTER, _SIZE],
    "touch_missed": [_HANDLE, _POINTER, _SIZE],
    "touch_request": [_HANDLE, _U32],
    "touch_path": [_HANDLE, _SIZE, _POINTER, _POINTER, _SIZE],
    "touch_save": [_HANDLE, _TEXT, _POINTER],
    "trace_load": [_TEXT, _POINTER],
    "trace_describe": [_HANDLE, _POINTER, _SIZE],
    "trace_doubles": [_HANDLE, _TEXT, _U64, _SIZE, _POINTER],
    "trace_integers": [_HANDLE, _TEXT, _U64, _SIZE, _POINTER],
    "controller_connect": [_TEXT, _U32, _POINTER],
    "controller_status": [_HANDLE, _TEXT, _SIZE, _POINTER],
    "controller_set": [_HANDLE, _TEXT, _TEXT],
    "controller_upload": [_HANDLE, _HANDLE, _TEXT],
    "controller_stop": [_HANDLE],
    "controller_resume": [_HANDLE],
    "controller_watch": [_HANDLE, _U32, _U64, ON_TICK, _POINTER, _POINTER],
    "controller_record": [_HANDLE, _U64, _TEXT, ON_TICK, _POINTER, _POINTER],
}


def _places(name: str) -> list[str]:
    """Where a library may be, the first that exists is taken: what ISOTOUCH_LIBRARY names, beside this package, below Python's prefix, where the system looks."""
    named = os.environ.get("ISOTOUCH_LIBRARY")
    if named:
        place = Path(named).absolute()   # of a name without a folder the system would look elsewhere
        if place.is_dir():
            return [str(place / name)]
        return [str(place if name == CORE else place.with_name(name))]
    near = [Path(__file__).parent / name, Path(sys.prefix) / "lib" / name]
    return [*(str(place) for place in near if place.is_file()), name]


def _loaded(name: str) -> ctypes.CDLL:
    said: list[str] = []
    for place in _places(name):
        try:
            return ctypes.CDLL(place)
        except OSError as error:
            said.append(str(error))
    raise ImportError(f"{name} cannot be loaded ({'; '.join(said)}); install isotouch and run ldconfig, or set ISOTOUCH_LIBRARY to the path of {CORE}")


@cache
def core() -> ctypes.CDLL:
    """libisotouch with the types of its functions. Raises ImportError where it is not found."""
    library = _loaded(CORE)
    for name, arguments in _FUNCTIONS.items():
        function = getattr(library, f"isotouch_{name}")
        function.argtypes, function.restype = arguments, ctypes.c_int
    for name in ("last_error", "version"):
        function = getattr(library, f"isotouch_{name}")
        function.argtypes, function.restype = [], ctypes.c_char_p
    library.isotouch_state_name.argtypes, library.isotouch_state_name.restype = [_U32], ctypes.c_char_p
    library.isotouch_trace_columns.argtypes, library.isotouch_trace_columns.restype = [], _SIZE
    library.isotouch_trace_column.argtypes, library.isotouch_trace_column.restype = [_SIZE, _POINTER], ctypes.c_char_p
    return library


@cache
def build() -> ctypes.CDLL:
    """libisotouch_build. Raises ImportError where it is not found."""
    core()   # it is found by its name when the other one is loaded
    library = _loaded(BUILD)
    library.isotouch_build_default.argtypes, library.isotouch_build_default.restype = [_POINTER, _SIZE], ctypes.c_int
    library.isotouch_build.argtypes = [_SIZE, _POINTER, _POINTER, _POINTER, _POINTER, _SIZE, _POINTER, _TEXT, _SIZE]
    library.isotouch_build.restype = ctypes.c_int
    return library


def last_error() -> str:
    said: bytes = core().isotouch_last_error()
    return said.decode("utf-8", "replace")


def check(status: int) -> None:
    """Raises what a status other than 0 means."""
    if status != 0:
        raise _ERRORS.get(status, IsotouchError)(last_error())


def call(name: str, *arguments: Any) -> None:
    """A function of libisotouch. Raises IsotouchError."""
    check(getattr(core(), f"isotouch_{name}")(*arguments))


def version() -> str:
    """Program, version and commit of the library."""
    said: bytes = core().isotouch_version()
    return said.decode()


def path_bytes(path: str | os.PathLike[str]) -> bytes:
    """Raises ArgumentError where it cannot be the name of a file."""
    try:
        name = os.fsencode(path)
    except (TypeError, UnicodeEncodeError):
        raise ArgumentError(f"{path!r} is no name of a file; give a text or a Path") from None
    if b"\0" in name:
        raise ArgumentError(f"{os.fsdecode(name)!r} holds a zero and is no name of a file; choose another one")
    return name


def text_bytes(text: str, name: str) -> bytes:
    """Raises ArgumentError."""
    try:
        encoded = text.encode("utf-8")
    except (AttributeError, UnicodeEncodeError):
        raise ArgumentError(f"{name} is {text!r} and must be a text in UTF-8") from None
    if b"\0" in encoded:
        raise ArgumentError(f"{name} holds a zero; leave it out")
    return encoded


def whole(value: int, name: str, most: int) -> int:
    """A number that C takes as it is. Raises ArgumentError."""
    if isinstance(value, bool) or not isinstance(value, (int, np.integer)):
        raise ArgumentError(f"{name} is {value!r} and must be a whole number")
    if not 0 <= value <= most:
        raise ArgumentError(f"{name} is {value} and must be from 0 to {most}")
    return int(value)


def real(value: float, name: str) -> float:
    """A number that C takes as it is; whether it is finite and in range the library looks at itself. Raises ArgumentError."""
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, (int, float, np.integer, np.floating)):
        raise ArgumentError(f"{name} is {value!r} and must be a number")
    try:
        return float(value)
    except OverflowError:
        raise ArgumentError(f"{name} is a whole number beyond 1e308; give a smaller one") from None


def yes_or_no(value: bool, name: str) -> int:
    """As C takes it. Raises ArgumentError."""
    if not isinstance(value, (bool, np.bool_)):
        raise ArgumentError(f"{name} is {value!r} and must be True or False")
    return int(value)


def _has_masked(values: object) -> bool:
    if isinstance(values, np.ma.MaskedArray):
        return bool(np.any(values.mask))
    return isinstance(values, (list, tuple, deque)) and any(map(_has_masked, values))


def reals(values: npt.ArrayLike, name: str, columns: int | None) -> Reals:
    """Values as C reads them.

    columns   numbers of a row, and a list of nothing has no rows; None: a list of numbers
    Raises ArgumentError: of another shape, or no real numbers. Whether they are finite the library looks at itself.
    """
    try:
        array = np.asarray(values)
    except ValueError:
        raise ArgumentError(f"{name} has rows of different lengths; give each row {columns or 1} numbers") from None
    if array.dtype.kind not in "fiu":
        raise ArgumentError(f"{name} holds values of type {array.dtype}, not real numbers; convert them to float64")
    if _has_masked(values):
        raise ArgumentError(f"{name} has masked values; fill them or leave them out")
    wanted = "a list of numbers" if columns is None else f"an array of shape (n, {columns})"
    if columns is not None and array.shape == (0,):
        array = array.reshape(0, columns)
    if array.ndim != (1 if columns is None else 2) or (columns is not None and array.shape[1] != columns):
        raise ArgumentError(f"{name} has shape {array.shape} and must be {wanted}")
    return np.require(array, np.float64, ["C_CONTIGUOUS", "ALIGNED"])


class Handle:
    """Something of the library that must be closed; garbage collection and the end of a `with` do it, too."""

    def __init__(self, handle: int) -> None:
        self._handle = handle
        self._free = weakref.finalize(self, core().isotouch_free, handle)

    def __reduce__(self) -> Any:
        raise TypeError(f"a {type(self).__name__} can be neither copied nor pickled: it is a number that only this process knows; load or read it again there")

    def close(self) -> None:
        """Frees it. Whatever is asked of it afterwards raises ClosedError."""
        if self._free.alive:
            call("free", self._handle)
            self._free.detach()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, value: BaseException | None, trace: TracebackType | None) -> None:
        self.close()
