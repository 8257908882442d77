"""A running controller."""

from __future__ import annotations

import contextlib
import ctypes
import json
import os
import signal
import threading
from collections.abc import Callable, Iterator
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
                  is raised here. The controller ends it where `on_tick` takes longer than 10 s

        Where it raises, also because the controller ends or at Ctrl-C, the exception has what came until then: `felt`, the array, and `lost`.
        """
        seen: list[np.void] = []

        def take(one: np.void) -> bool | None:
            if on_tick is not None:
                return on_tick(one)
            seen.append(one)
            return False

        lost = ctypes.c_uint64()
        try:
            wanted, one_of = whole(ticks, "ticks", _MOST_TICKS), whole(every, "every", 2**32 - 1)
            with _called_from_c(take) as each:
                answer = core().isotouch_controller_watch(self._handle, one_of, wanted, each, None, ctypes.byref(lost))
            check(answer)
        except BaseException as error:
            vars(error).update(felt=np.array(seen, FELT), lost=lost.value)
            raise
        return np.array(seen, FELT), lost.value

    def record(self, path: str | os.PathLike[str], ticks: int, on_tick: Callable[[np.void], bool | None] | None = None) -> int:
        """Records ticks from now on as a trace that replays to the bit, and returns how many the file holds.

        on_tick   is called with each of them, numbered from 0; what returns True ends the recording after this tick. What it raises ends it, too, and is
                  raised here, as is Ctrl-C: the file holds the ticks until then. The controller ends it where `on_tick` takes longer than 10 s
        """
        recorded = ctypes.c_uint64()
        wanted, file = whole(ticks, "ticks", _MOST_TICKS), path_bytes(path)
        with _called_from_c(on_tick or (lambda _: False)) as each:
            answer = core().isotouch_controller_record(self._handle, wanted, file, each, None, ctypes.byref(recorded))
        check(answer)
        return recorded.value


@contextlib.contextmanager
def _called_from_c(on_tick: Callable[[np.void], bool | None]) -> Iterator[Any]:
    """A function for C, which ends the call where on_tick says so or raises, and on Ctrl-C; what was raised is raised at the end of the block.

    C passes no exceptions on, and a signal's is raised before the first line of a function that C calls. So Ctrl-C waits for the next
    tick that is followed, and until the block ends.
    """
    raised: list[BaseException] = []
    interrupts: list[int] = []

    def take(_: int | None, felt: int | None) -> int:
        if interrupts:
            return 1
        try:
            return 1 if on_tick(np.frombuffer(ctypes.string_at(felt or 0, FELT.itemsize), FELT)[0]) else 0
        except BaseException as error:
            raised.append(error)
            return 1

    handler = signal.getsignal(signal.SIGINT)
    if threading.current_thread() is not threading.main_thread() or not callable(handler):   # then no signal arrives here
        yield ON_TICK(take)
    else:
        signal.signal(signal.SIGINT, lambda number, _: interrupts.append(number))
        try:
            yield ON_TICK(take)
        finally:
            signal.signal(signal.SIGINT, handler)
        if interrupts:
            handler(signal.SIGINT, None)
    if raised:
        raise raised[0]
