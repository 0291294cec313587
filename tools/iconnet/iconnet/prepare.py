"""Packages become arrays: every icon's picture, some wires of it, and what it is called."""

import json
from concurrent.futures import ProcessPoolExecutor

import numpy as np

from . import icons, render, wires
from .errors import DataError
from .places import Places

WIRES = 2  # of each icon


def pictures(places: Places, workers: int) -> int:
    """Writes `icons`, `pictures` and `wires` of `places`. Returns how many icons there are; those that show nothing are left out."""
    found = icons.read(places.packages)
    with ProcessPoolExecutor(workers) as pool:
        shown = list(pool.map(_shown, (icon.svg for icon in found), range(len(found)), chunksize=256))
    kept = [(icon, picture, drawn) for icon, (picture, drawn) in zip(found, shown) if picture is not None]
    if len(kept) < len(found) * 0.97:
        raise DataError(f"{len(found) - len(kept)} of {len(found)} icons show nothing: see render.py.")
    np.save(places.pictures, np.stack([picture for _, picture, _ in kept]))
    np.save(places.wires, np.stack([drawn for _, _, drawn in kept]))
    rows = [[icon.source, icon.variant, icon.name, list(icon.tags)] for icon, _, _ in kept]
    places.icons.write_text(json.dumps(rows), encoding="utf-8")
    return len(kept)


def _shown(svg: str, number: int):
    """A picture and WIRES wires, or twice None where there is no picture or no line in it."""
    try:
        picture = render.ink(svg)
    except DataError:
        return None, None
    strokes = wires.lines(picture)
    if not strokes:
        return None, None
    random = np.random.default_rng(number)
    return picture, np.stack([wires.wire(strokes, random) for _ in range(WIRES)])
