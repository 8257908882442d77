#!/usr/bin/env python3
"""Writes what a depth camera sees that goes round a ball, frame by frame, as `isotouch stream` reads it: stream_frames.py [FRAMES [PER_SECOND]]

    stream_frames.py 90 30 | isotouch stream - --box=-30,-30,-30,30,30,30 --units mm --to unix:control
"""

from __future__ import annotations

import sys
import time
from typing import BinaryIO

import numpy as np
import numpy.typing as npt

Reals = npt.NDArray[np.float64]

COLUMNS, ROWS = 120, 90
RADIUS, DISTANCE, FOCAL = 25.0, 100.0, 130.0   # mm, mm, pixels
HEADER = """ply
format binary_little_endian 1.0
element vertex {}
property float x
property float y
property float z
property float nx
property float ny
property float nz
end_header
"""


def write_frame(to: BinaryIO, points: Reals, normals: Reals) -> None:
    """One frame: a line with its size, and a PLY file of that many bytes."""
    header = HEADER.format(len(points)).encode()
    body = np.hstack([points, normals]).astype("<f4").tobytes()
    to.write(b"frame %d\n" % (len(header) + len(body)) + header + body)
    to.flush()   # the field grows when the frame has arrived


def seen(turn: float) -> tuple[Reals, Reals]:
    """Points and normals of the ball, as the camera sees them from one side."""
    forward = np.array([-np.cos(turn), 0, -np.sin(turn)])
    right, down = np.array([forward[2], 0, -forward[0]]), np.array([0.0, -1.0, 0.0])
    across, along = np.meshgrid(np.arange(COLUMNS) - (COLUMNS - 1) / 2, np.arange(ROWS) - (ROWS - 1) / 2)
    rays = (across[..., None] * right + along[..., None] * down) / FOCAL + forward
    rays /= np.linalg.norm(rays, axis=-1, keepdims=True)
    camera = -DISTANCE * forward
    half = rays @ camera
    inside = half**2 - DISTANCE**2 + RADIUS**2
    hit = inside > 0
    points = camera + (-half - np.sqrt(np.maximum(inside, 0)))[hit][:, None] * rays[hit]
    return points, points / RADIUS


def main(frames: int, per_second: float) -> None:
    begin = time.monotonic()
    for number in range(frames):
        write_frame(sys.stdout.buffer, *seen(0.1 * number))
        time.sleep(max(0.0, begin + (number + 1) / per_second - time.monotonic()))


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 90, float(sys.argv[2]) if len(sys.argv) > 2 else 30.0)
