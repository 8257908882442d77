"""How a program of each preset is started on this machine; a preset that is not listed builds for this machine itself. `chromium` stands for the preset wasm32
in a browser."""

from __future__ import annotations

from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

# Of presets whose name begins so: the processor's name, its emulator, and where its C library is; None: build/sysroot/PRESET.
_EMULATORS: dict[str, tuple[str, list[str], str | None]] = {
    "arm64": ("aarch64", ["qemu-aarch64", "-L"], None),
    "armhf": ("armhf", ["qemu-arm", "-L"], None),
    "riscv64": ("riscv64", ["qemu-riscv64", "-L"], "/usr/riscv64-linux-gnu"),
    "chromium": ("wasm32", [str(ROOT / "hil/webassembly/replay_in_browser")], ""),
    "wasm32": ("wasm32", [str(ROOT / "hil/webassembly/run_in_node")], ""),
}


def _entry(preset: str) -> tuple[str, list[str], str | None] | None:
    return _EMULATORS.get(preset.removesuffix("-trixie"))


def processor_of(preset: str) -> str | None:
    """Its name, if programs of this preset need an emulator."""
    entry = _entry(preset)
    return entry[0] if entry else None


def emulator_of(preset: str) -> list[str]:
    """The words before a program; none where the program starts by itself."""
    entry = _entry(preset)
    if entry is None:
        return []
    _, words, library = entry
    return words if library == "" else [*words, library or str(ROOT / "build/sysroot" / preset)]


def program_of(preset: str, name: str) -> str:
    """Where the preset's build leaves a program, from the repository's root. In the browser there is one, the page's module, and it replays."""
    if preset == "chromium":
        return "build/wasm32/bin/touch.wasm"
    return f"build/{preset}/bin/{name}{'.wasm' if preset == 'wasm32' else ''}"
