"""A hand on a field, tick by tick."""

from __future__ import annotations

import ctypes
import enum
import os
from collections.abc import Sequence
from dataclasses import dataclass, fields

import numpy as np
import numpy.typing as npt

from isotouch._library import ArgumentError, CSettings, Handle, call, core, path_bytes, real, reals, whole


class Status(enum.IntFlag):
    """What is true in a tick: `Status(felt["status"])`. A limit at work is no fault."""

    CONTACT = 1 << 0   # the surface holds the proxy back
    FOLLOWING = 1 << 1   # the proxy is on its way to the hand in free space: no force
    OUTSIDE_GRID = 1 << 2   # the hand is outside the sampled box
    HELD_INSIDE = 1 << 3   # the hand began inside the object: no force until it has left
    RAMPING = 1 << 4   # the force is below its full value, because contact did not begin at rest
    FORCE_LIMITED = 1 << 5   # the force was shortened to the limit, its direction kept
    STALE = 1 << 6   # no fresh sample came
    INPUT_CLAMPED = 1 << 7   # the hand was outside ±512 mm and was moved to the border
    BAD_REPLY = 1 << 8   # the device's packet was malformed and counts as none
    COUNT_JUMP = 1 << 9   # the encoders took another reference: the pose is sought anew
    POSE_UNCERTAIN = 1 << 10   # it is not known where the hand is: no force
    NEAR_SINGULAR = 1 << 11   # the arms are nearly stretched: torques are smaller than asked for
    TOO_FAST = 1 << 12   # the hand is faster than the device's limit
    COMMANDS_LIMITED = 1 << 13   # the motor commands were shortened to the limit
    SLEW_LIMITED = 1 << 14   # the change of the motor commands was shortened
    HEAT_LIMITED = 1 << 20   # the motors are warm, and their limit is lowered
    LATE = 1 << 21   # periods were left out before this tick
    DAMPED = 1 << 24   # the passivity controller adds damping
    LAGGING = 1 << 25   # the surface has moved by itself, and the force has not followed yet


class Fault(enum.IntFlag):
    """Why the supervisor is in fault; kept until it is resumed."""

    STOPPED = 1 << 0   # somebody asked for it
    SILENT = 1 << 1   # no fresh sample for too long
    PENETRATION = 1 << 2   # the hand was too deep in the object
    ENCODERS = 1 << 3   # the encoders jumped while there was force
    POSE = 1 << 4   # it was not known for too long where the hand is
    SPEED = 1 << 5   # the hand was too fast for too long
    LATE = 1 << 6   # ticks were late for too long
    EMERGENCY = 1 << 7   # the emergency stop
    ENABLE = 1 << 8   # the motors' enable line reads back wrong
    MEMORY = 1 << 9   # memory has changed by itself
    GUARD = 1 << 10   # the guard took the force away


FELT = np.dtype([
    ("tick", "u8"),
    ("hip_mm", "f8", (3,)),
    ("proxy_mm", "f8", (3,)),
    ("force_n", "f8", (3,)),
    ("penetration_mm", "f8"),
    ("contact", "u4"),
    ("status", "u4"),
    ("state", "u4"),
    ("faults", "u4"),
    ("buttons", "u4"),
    ("commands", "i4", (3,)),
])
"""What a tick answers. hip_mm: where the hand is; zeros while encoder counts do not tell. proxy_mm: the point on the surface that holds it. force_n: on the
hand. penetration_mm: from the hand to the proxy, in contact. contact: 1 where the surface holds the proxy back. status, faults: bits of `Status` and `Fault`.
state: see `state_name`. commands: of the motors. state, faults and commands are 0 with positions."""

Felt = npt.NDArray[np.void]

_DEVICES = ("libnifalcon", "martin-hillier")
_MOST_U64 = 2**64 - 1


@dataclass(frozen=True)
class Settings:
    """How a field feels. Ranges are those of the controller's settings; the library refuses what is outside."""

    stiffness: float = 0.0
    """N/mm; 0: the field's own"""
    damping: float = 0.0
    """N s/mm, between proxy and hand"""
    force_limit_n: float = 8.0
    friction: float = 0.0
    """Coulomb's coefficient"""
    friction_damping: float = 0.0
    """N s/mm, of a hand that slides"""
    hand_damping: float = 0.0
    """N s/mm, of a hand in contact"""
    passivity_damping: float = 0.0
    """N s/mm, the largest that may be added against trembling"""
    weight_n: float = 0.0
    """of the handle; only with encoder counts"""
    ramp_ticks: int = 50
    """from no force to full force if contact did not begin at rest"""
    device_damping: float = 0.0
    """of the device; 0: not known, and no stiffness is refused"""
    delay_ticks: int = 0
    """from a sample to its force being felt"""
    play_mm: float = 0.046
    """a smaller movement of the hand counts as rest"""
    period_ns: int = 1_000_000
    """from one tick to the next"""
    device: str = "libnifalcon"
    """whose numbers turn encoder counts into positions: 'libnifalcon' or 'martin-hillier'"""
    record_ticks: int = 0
    """ticks that are kept for `Touch.save`, from the first on"""

    def as_c(self) -> CSettings:
        """Raises ArgumentError for what C cannot hold."""
        if self.device not in _DEVICES:
            raise ArgumentError(f"device is {self.device!r} and must be one of {', '.join(_DEVICES)}")
        made = CSettings()
        for each in fields(self):
            value = getattr(self, each.name)
            if each.name == "device":
                made.device = _DEVICES.index(value)
            elif each.name in ("period_ns", "record_ticks"):
                setattr(made, each.name, whole(value, each.name, _MOST_U64 if each.name == "record_ticks" else 2**32 - 1))
            else:
                setattr(made, each.name, real(value, each.name))
        return made


def state_name(state: int) -> str:
    """'boot' to 'fault', for the column `state` of a device."""
    name: bytes = core().isotouch_state_name(whole(state, "state", 2**32 - 1))
    return name.decode()


class Touch(Handle):
    """A hand that begins to touch a field: `Field.begin` makes one. Each tick gives one element of type FELT."""

    def __init__(self, field_handle: int, settings: Settings) -> None:
        made, handle = settings.as_c(), ctypes.c_uint64()
        call("touch_new", field_handle, ctypes.byref(made), ctypes.sizeof(made), ctypes.byref(handle))
        super().__init__(handle.value)

    def position(self, hip_mm: npt.ArrayLike, buttons: int = 0) -> np.void:
        """One tick of a hand at a place, mm. Raises ArgumentError."""
        hip = reals(hip_mm, "hip_mm", None)
        if hip.shape != (3,):
            raise ArgumentError(f"hip_mm has {hip.size} numbers and must have 3: x, y, z")
        felt = np.zeros(1, FELT)
        call("touch_position", self._handle, hip.ctypes.data, whole(buttons, "buttons", 15), felt.ctypes.data, felt.nbytes)
        return _only(felt)

    def counts(self, counts: Sequence[int], homed: int = 7, buttons: int = 0) -> np.void:
        """One tick of a device with these encoder counts. Raises ArgumentError.

        homed     bits 0 to 2: this leg has its reference
        """
        three = (ctypes.c_int32 * 3)(*_three_counts(counts))
        felt = np.zeros(1, FELT)
        call("touch_counts", self._handle, three, whole(homed, "homed", 7), whole(buttons, "buttons", 15), felt.ctypes.data, felt.nbytes)
        return _only(felt)

    def missed(self) -> np.void:
        """One tick for which no new sample came. Raises ArgumentError before the first sample."""
        felt = np.zeros(1, FELT)
        call("touch_missed", self._handle, felt.ctypes.data, felt.nbytes)
        return _only(felt)

    def path(self, hips_mm: npt.ArrayLike) -> Felt:
        """A tick for each position of an array of shape (n, 3), mm. Raises ArgumentError, before the first tick."""
        hips = reals(hips_mm, "the path", 3)
        felt = np.zeros(len(hips), FELT)
        call("touch_path", self._handle, len(hips), hips.ctypes.data, felt.ctypes.data, felt.nbytes)
        return felt

    def stop(self) -> None:
        """No force of a device from the next tick on, until `resume`."""
        call("touch_request", self._handle, 1)

    def resume(self) -> None:
        """A device leaves a fault in the next tick, if its cause is gone."""
        call("touch_request", self._handle, 2)

    def save(self, path: str | os.PathLike[str]) -> int:
        """Writes the ticks that were kept (`Settings.record_ticks`) as a trace that replays to the bit, and returns how many. Raises DataError, MissingError."""
        ticks = ctypes.c_uint64()
        call("touch_save", self._handle, path_bytes(path), ctypes.byref(ticks))
        return ticks.value


def _three_counts(counts: Sequence[int]) -> list[int]:
    """Raises ArgumentError, also for what is no sequence."""
    try:
        array = np.asarray(counts)
    except ValueError:   # lists of different lengths
        array = np.zeros(0)
    if array.shape != (3,) or array.dtype.kind not in "iu" or any(abs(int(count)) > 2**31 - 1 for count in array):
        raise ArgumentError(f"counts is {counts!r} and must be 3 whole numbers of 16 bits")
    return [int(count) for count in array]


def _only(felt: Felt) -> np.void:
    element: np.void = felt[0]
    return element
