"""Touch, sample and record distance fields by the integer core of isotouch.

Lengths are mm, forces N, stiffnesses N/mm. Positions are in the workspace: x right, y up, z towards the person, origin in its middle. Distances are negative
inside the object, gradients point out.

    import isotouch

    field = isotouch.Field.load("scan.itf")
    samples = field.sample([[0, 30, 0], [0, 40, 0]])
    felt = field.touch([[0, 60 - 0.05 * tick, 0] for tick in range(600)])
    felt["force_n"]

What the library refuses raises an `IsotouchError` with one sentence: what is wrong, and what to do.
"""

from isotouch._library import (
    ArgumentError,
    BusyError,
    ClosedError,
    ControllerError,
    DataError,
    IsotouchError,
    MissingError,
    NoMemoryError,
    version,
)
from isotouch.controller import Controller
from isotouch.field import Field, FieldFacts, Samples
from isotouch.touch import FELT, Fault, Settings, Status, Touch, state_name
from isotouch.trace import CutOffWarning, TraceFacts, describe_trace, load_trace

__all__ = [
    "FELT",
    "ArgumentError",
    "BusyError",
    "ClosedError",
    "Controller",
    "ControllerError",
    "CutOffWarning",
    "DataError",
    "Fault",
    "Field",
    "FieldFacts",
    "IsotouchError",
    "MissingError",
    "NoMemoryError",
    "Samples",
    "Settings",
    "Status",
    "Touch",
    "TraceFacts",
    "describe_trace",
    "load_trace",
    "state_name",
    "version",
]
