"""Files around the EV3 that hold neither frames nor a capture, and what to do with each."""

from __future__ import annotations

from pathlib import Path

_ZIP = b"PK\x03\x04"
_UF2 = b"UF2\n"
_SOUND = (b"\x01\x00", b"\x01\x01")
_LEAST_FIRMWARE = 1 << 20
_BY_SUFFIX = {
    ".ev3": "a project of LEGO's EV3 software, a zip of diagrams without byte code: download it to a brick and copy"
    " the program's .rbf from there",
    ".uf2": "a UF2 image for a brick in bootloader mode, which holds ARM code: copy it to the brick's drive",
    ".rgf": "an image for the brick's display: `ev3proto copy` puts it on a brick, UI_DRAW.BMPFILE shows it",
    ".rsf": "a sound file: `ev3proto copy` puts it on a brick, SOUND.PLAY plays it",
    ".bin": "a firmware image, perhaps: it holds ARM code, which the firmware updater of LEGO's software writes",
}


def kind_of(name: str, start: bytes) -> str | None:
    """Returns what a file is that cannot be read, and what to do with it; None for an unknown kind.

    Args:
        name: The path of a file; `-` for standard input.
        start: Its first bytes.
    """
    suffix = Path(name).suffix.lower()
    if start.startswith(_UF2):
        return _BY_SUFFIX[".uf2"]
    if start.startswith(_ZIP):
        return _BY_SUFFIX[suffix] if suffix == ".ev3" else "a zip archive: unpack it, and give the files in it"
    if suffix == ".bin" and Path(name).stat().st_size < _LEAST_FIRMWARE:
        return None
    if suffix == ".rsf" and not start.startswith(_SOUND):
        return None
    return _BY_SUFFIX.get(suffix) if suffix in (".rgf", ".rsf", ".bin") else None
