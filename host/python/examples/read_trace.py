#!/usr/bin/env python3
"""Prints what a trace holds, and where its hand touched: read_trace.py TRACE"""

from __future__ import annotations

import sys

import isotouch
import numpy as np


def main(path: str) -> None:
    facts, table = isotouch.describe_trace(path), isotouch.load_trace(path)
    print(f"{facts.ticks} ticks of {facts.period_ns / 1e6:g} ms, {'packets of a device' if facts.has_packets else 'positions of a hand'}")
    if not facts.has_outputs:
        print("inputs only: compute the forces with isotouch replay FIELD TRACE -o")
        return
    force = np.sqrt(table["force_x_n"] ** 2 + table["force_y_n"] ** 2 + table["force_z_n"] ** 2)
    begins = np.flatnonzero(np.diff(table["contact"], prepend=0) == 1)
    print(f"{len(begins)} contacts, the first at ticks {begins[:5].tolist()}, largest force {force.max():.3f} N, replay hash {facts.replay_hash}")


if __name__ == "__main__":
    main(sys.argv[1])
