"""How a script is ended from outside: Ctrl-C, SIGTERM, or its terminal closes."""

from __future__ import annotations

import signal
from collections.abc import Callable
from types import FrameType


def on(handler: Callable[[int, FrameType | None], object], *signals: signal.Signals) -> None:
    """Calls the handler where one of them comes. What is ignored stays ignored, as SIGHUP is under nohup."""
    for each in signals:
        if signal.getsignal(each) != signal.SIG_IGN:
            signal.signal(each, handler)
