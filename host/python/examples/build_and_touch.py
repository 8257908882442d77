#!/usr/bin/env python3
"""Builds a field of a ball from points, presses a hand into it, and writes the touch as a trace: build_and_touch.py FOLDER"""

from __future__ import annotations

import sys
from pathlib import Path

import isotouch
import numpy as np


def main(folder: Path) -> None:
    number = np.arange(3000) + 0.5
    height, turn = 1 - 2 * number / number.size, np.pi * (1 + 5**0.5) * number
    around = np.sqrt(1 - height**2)
    normals = np.stack([around * np.cos(turn), height, around * np.sin(turn)], axis=1)

    field = isotouch.Field.build(25 * normals, normals, mm_per_unit=1, grid=64)
    field.save(folder / "ball.itf")
    print(f"ball.itf: {field.facts.samples} samples of {field.facts.voxel_mm:.3f} mm, hash {field.facts.hash}")

    # What the field says half a millimetre outside and inside.
    samples = field.sample(field.facts.offset_mm + np.outer([25.5, 24.5], [0, 1, 0]))
    print(f"distances {np.round(samples.distance_mm, 3)} mm")

    # A hand that presses down by 3 mm in half a second and slides sideways.
    seconds = np.arange(1000) / 1000
    down = 26 - 4 * np.minimum(2 * seconds, 1)
    path = field.facts.offset_mm + np.stack([10 * np.maximum(seconds - 0.5, 0), down, 0 * seconds], axis=1)
    felt = field.touch(path, isotouch.Settings(friction=0.3), save=folder / "ball.trace")
    first = int(np.argmax(felt["contact"] > 0))
    print(f"contact from tick {first} on, largest force {np.linalg.norm(felt['force_n'], axis=1).max():.3f} N")


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else "."))
