#!/usr/bin/env python3
"""Prints the state of a running controller and the largest force of the next second: watch_controller.py unix:SOCKET"""

from __future__ import annotations

import sys

import isotouch
import numpy as np


def main(address: str) -> None:
    with isotouch.Controller(address) as controller:
        status = controller.status()
        print(f"{status['sentence']}; {status['ticks']} ticks, field {status['field_name'] or 'none'}")
        felt, lost = controller.watch(ticks=1000)
        print(f"{len(felt)} ticks, {lost} lost, largest force {np.linalg.norm(felt['force_n'], axis=1).max():.3f} N")


if __name__ == "__main__":
    main(sys.argv[1])
