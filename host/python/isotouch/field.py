"""Fields: made of points, loaded, sampled, touched."""

from __future__ import annotations

import ctypes
import dataclasses
import os
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple, Self

import numpy as np
import numpy.typing as npt

from isotouch._library import ArgumentError, CBuildOptions, CFieldFacts, Handle, Reals, build, call, check, path_bytes, real, reals, whole, yes_or_no
from isotouch.touch import Felt, Settings, Touch

if TYPE_CHECKING:   # a name for bytes, bytearray, memoryview and arrays that only a type checker knows
    from _typeshed import ReadableBuffer as Buffer

_INTERPOLATIONS = ("spline", "trilinear")
_ROOM = 1 << 16


class Samples(NamedTuple):
    """What a field says at n points."""

    distance_mm: Reals
    """(n,), within ± the band; negative inside"""
    gradient: Reals
    """(n, 3), slope of the distance, points out; zero beyond the band"""
    stiffness_n_mm: Reals
    """(n,), of the surface near the point"""
    in_band: npt.NDArray[np.bool_]
    """(n,), where distance and gradient are known: up to a voxel before the band ends. Elsewhere the surface may be farther away"""


@dataclass(frozen=True)
class FieldFacts:
    """What a field says of itself."""

    hash: str
    """of its image, as `isotouch info` shows it"""
    image_bytes: int
    low_mm: tuple[float, float, float]
    """corner of the sampled box"""
    high_mm: tuple[float, float, float]
    voxel_mm: float
    band_mm: float
    """half the width of the layer round the surface in which distances are stored"""
    stiffness_n_mm: float
    """where it varies, the largest"""
    advised_stiffness_n_mm: float
    """largest advisable one by its certificate; 0: it has none"""
    scale: float
    """workspace = scale × scan + offset_mm; 0: not stated"""
    offset_mm: tuple[float, float, float]
    samples: tuple[int, int, int]
    interpolation: str
    """'spline' or 'trilinear'"""
    is_published: bool
    varies_in_stiffness: bool


def _three(values: Any) -> tuple[Any, Any, Any]:
    return values[0], values[1], values[2]


class Field(Handle):
    """A field in memory. It may be used by several threads at once."""

    warnings: tuple[str, ...]
    """what `build` has put right or found doubtful, one sentence each"""

    def __init__(self, handle: int, warnings: tuple[str, ...] = ()) -> None:
        super().__init__(handle)
        self.warnings = warnings

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Self:
        """Loads a field file (.itf, .itfi), checked as a controller checks it. Raises DataError."""
        handle = ctypes.c_uint64()
        call("field_load", path_bytes(path), ctypes.byref(handle))
        return cls(handle.value)

    @classmethod
    def read(cls, data: Buffer) -> Self:
        """The same from the bytes of such a file, or any buffer that holds them. Raises ArgumentError, DataError."""
        try:
            held = bytes(memoryview(data))
        except (TypeError, ValueError, BufferError):
            raise ArgumentError(f"data is a {type(data).__name__} and must be bytes, or a buffer of them") from None
        handle = ctypes.c_uint64()
        call("field_read", held, len(held), ctypes.byref(handle))
        return cls(handle.value)

    @classmethod
    def build(
        cls,
        points: npt.ArrayLike,
        normals: npt.ArrayLike | None = None,
        *,
        stiffness: npt.ArrayLike | None = None,
        stiffness_n_mm: float = 0.0,
        voxel_mm: float = 0.0,
        grid: int = 0,
        band: float = 3.0,
        fit_mm: float = 70.0,
        mm_per_unit: float = 0.0,
        viewpoint: npt.ArrayLike | None = None,
        interpolation: str = "spline",
        threads: int = 0,
        accept_implausible: bool = False,
    ) -> Self:
        """Builds a field from a scan, as `isotouch build` does.

        points              (n, 3), any unit
        normals             (n, 3), outward; None: they are estimated
        stiffness           (n,), N/mm, where the points have their own
        stiffness_n_mm      of the surface, or the largest; 0: theirs, or 0.8
        voxel_mm            edge of a voxel; 0: `grid` voxels along the longest side
        grid                0: as fine as the scan supports
        band                half width of the stored layer, voxels
        fit_mm              the longest side is scaled to this length
        mm_per_unit         instead: the true size, 1 for points in mm
        viewpoint           the sensor's place: every normal is turned towards it
        accept_implausible  make a field that is judged to be probably wrong

        Raises ArgumentError, and DataError with every reason where no plausible field comes of it. Takes seconds.
        """
        if interpolation not in _INTERPOLATIONS:
            raise ArgumentError(f"interpolation is {interpolation!r} and must be one of {', '.join(_INTERPOLATIONS)}")
        places = reals(points, "points", 3)
        outward = None if normals is None else reals(normals, "normals", 3)
        own = None if stiffness is None else reals(stiffness, "stiffness", None)
        for name, array in (("normals", outward), ("stiffness", own)):
            if array is not None and len(array) != len(places):
                raise ArgumentError(f"there are {len(places)} points and {len(array)} {name}; give one for each point")
        options = CBuildOptions()
        check(build().isotouch_build_default(ctypes.byref(options), ctypes.sizeof(options)))
        for name, value in (("stiffness_n_mm", stiffness_n_mm), ("voxel_mm", voxel_mm), ("band", band), ("fit_mm", fit_mm), ("mm_per_unit", mm_per_unit)):
            setattr(options, name, real(value, name))
        options.grid, options.threads = whole(grid, "grid", 2**32 - 1), whole(threads, "threads", 2**32 - 1)
        options.interpolation, options.accept_implausible = _INTERPOLATIONS.index(interpolation), yes_or_no(accept_implausible, "accept_implausible")
        if viewpoint is not None:
            place = reals(viewpoint, "viewpoint", None)
            if place.shape != (3,):
                raise ArgumentError(f"viewpoint has {place.size} numbers and must have 3: x, y, z")
            options.viewpoint, options.has_viewpoint = (ctypes.c_double * 3)(*place), 1
        handle, said = ctypes.c_uint64(), ctypes.create_string_buffer(_ROOM)
        check(build().isotouch_build(
            len(places), places.ctypes.data, None if outward is None else outward.ctypes.data, None if own is None else own.ctypes.data,
            ctypes.byref(options), ctypes.sizeof(options), ctypes.byref(handle), said, _ROOM))
        return cls(handle.value, tuple(said.value.decode("utf-8", "replace").splitlines()))

    @property
    def facts(self) -> FieldFacts:
        """Raises ClosedError."""
        found = CFieldFacts()
        call("field_describe", self._handle, ctypes.byref(found), ctypes.sizeof(found))
        return FieldFacts(
            hash=f"{found.hash:016x}", image_bytes=found.image_bytes, low_mm=_three(found.low_mm), high_mm=_three(found.high_mm), voxel_mm=found.voxel_mm,
            band_mm=found.band_mm, stiffness_n_mm=found.stiffness_n_mm, advised_stiffness_n_mm=found.advised_stiffness_n_mm, scale=found.scale,
            offset_mm=_three(found.offset_mm), samples=_three(found.samples), interpolation=_INTERPOLATIONS[found.interpolation],
            is_published=bool(found.is_published), varies_in_stiffness=bool(found.varies_in_stiffness))

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the packed form (.itf): the whole file or none. Raises DataError."""
        call("field_save", self._handle, path_bytes(path))

    def sample(self, points_mm: npt.ArrayLike) -> Samples:
        """Distance, gradient and stiffness at points of shape (n, 3), in the workspace, by the arithmetic of the controller's tick. Raises ArgumentError."""
        points = reals(points_mm, "points_mm", 3)
        count = len(points)
        distance, gradient, stiffness, known = np.zeros(count), np.zeros((count, 3)), np.zeros(count), np.zeros(count, np.uint8)
        call("field_sample", self._handle, count, points.ctypes.data, distance.ctypes.data, gradient.ctypes.data, stiffness.ctypes.data, known.ctypes.data)
        return Samples(distance, gradient, stiffness, known.astype(np.bool_))

    def begin(self, settings: Settings | None = None) -> Touch:
        """A hand that begins to touch it. Raises ArgumentError, and DataError where a controller would refuse the stiffness."""
        return Touch(self._handle, settings or Settings())

    def touch(self, path_mm: npt.ArrayLike, settings: Settings | None = None, *, save: str | os.PathLike[str] | None = None) -> Felt:
        """What a hand feels on a path of shape (n, 3), mm, one position a tick: an array of n elements of type FELT.

        save      writes the ticks as a trace that replays to the bit
        Raises ArgumentError, DataError, and MissingError where an empty path is to be saved.
        """
        path = reals(path_mm, "the path", 3)
        wanted = settings or Settings()
        if save is not None:
            wanted = dataclasses.replace(wanted, record_ticks=len(path))
        with self.begin(wanted) as touch:
            felt = touch.path(path)
            if save is not None:
                touch.save(save)
        return felt
