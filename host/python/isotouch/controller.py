"""A running controller."""

from __future__ import annotations

import ctypes
import json
import os
from collections.abc import Callable
from typing import Any

import numpy as np

from isotouch._library import ON_TICK, TOO_SMALL, ArgumentError, Handle, call, check, core, path_bytes, real, text_bytes, whole
from isotouch.field import Field
from isotouch.touch import FELT, Felt

_ROOM = 1 << 14
_MOST_TICKS = 2**63 - 1


class Controller(Handle):
    """A controller, `isotouchd`, by its socket or over ssh. After a call that failed, the next one connects again.

    address   'unix:PATH', or 'ssh://user@host[:port][/path of the socket]'
    timeout   s, longest time to wait for an answer

    Every call raises ControllerError where the controller does not answer or refuses.
    """

    def __init__(self, address: str, timeout: float = 10.0) -> None:
        handle = ctypes.c_uint64()
        if not 0.001 <= real(timeout, "timeout") <= 3600:
            raise ArgumentError(f"timeout is {timeout} and must be from 0.001 to 3600 s")
        call("controller_connect", text_bytes(address, "address"), round(1000 * timeout), ctypes.byref(handle))
        super().__init__(handle.value)

    def status(self) -> dict[str, Any]:
        """State, faults, field and times, with the keys of `isotouch status --json`."""
        room = _ROOM
        while True:
            text, needed = ctypes.create_string_buffer(room), ctypes.c_size_t()
            answer = core().isotouch_controller_status(self._handle, text, room, ctypes.byref(needed))
            if answer == TOO_SMALL:
                room = 2 * needed.value
                continue
            check(answer)
            status: dict[str, Any] = json.loads(text.value)
            return status

    def set(self, name: str, value: float | str) -> None:
        """Changes a setting of the section [feel] while it is felt; the force follows with a ramp."""
        call("controller_set", self._handle, text_bytes(name, "name"), text_bytes(str(value), "value"))

    def upload(self, field: Field, name: str) -> None:
        """Sends a field; it is felt when this returns."""
        call("controller_upload", self._handle, field._handle, text_bytes(name, "name"))

    def stop(self) -> None:
        """No force from the next tick on, until `resume`."""
        call("controller_stop", self._handle)

    def resume(self) -> None:
        """Leaves a fault, if its cause is gone."""
        call("controller_resume", self._handle)

    def watch(self, ticks: int, every: int = 1, on_tick: Callable[[np.void], bool | None] | None = None) -> tuple[Felt, int]:
        """Follows the ticks: an array of type FELT, and how many ticks were lost because this program read too slowly.

        every     one tick of every so many
        on_tick   is called with each of them as it comes, and the array stays empty; what returns True ends the watching. What it raises ends it, too, and
                  is raised here
        """
        seen: list[np.void] = []
        raised: list[BaseException] = []

        def take(_: int | None, felt: int | None) -> int:
            try:
                one = np.frombuffer(ctypes.string_at(felt or 0, FELT.itemsize), FELT)[0]
                if on_tick is not None:
                    return 1 if on_tick(one) else 0
                seen.append(one)
                return 0
            except BaseException as error:   # no exception passes through C
                raised.append(error)
                return 1

        lost = ctypes.c_uint64()
        wanted = whole(ticks, "ticks", _MOST_TICKS)
        answer = core().isotouch_controller_watch(self._handle, whole(every, "every", 2**32 - 1), wanted, ON_TICK(take), None, ctypes.byref(lost))
        if raised:
            raise raised[0]
        check(answer)
        return np.array(seen, FELT), lost.value

    def record(self, path: str | os.PathLike[str], ticks: int) -> int:
        """Records ticks from now on as a trace that replays to the bit, and returns how many the file holds."""
        recorded = ctypes.c_uint64()
        call("controller_record", self._handle, whole(ticks, "ticks", _MOST_TICKS), path_bytes(path), ctypes.byref(recorded))
        return recorded.value
