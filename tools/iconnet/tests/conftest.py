"""A made-up data folder: six names in three sets, pictures by formula, embeddings at random."""

import json

import numpy as np
import pytest

from iconnet import prepare, render, split, wires
from iconnet.places import Places
from iconnet.words import EMBED, unit

SHAPES = {
    "ring": '<circle cx="12" cy="12" r="9"/>',
    "cross": '<path d="M4 4l16 16M20 4L4 20"/>',
    "bars": '<path d="M4 5h16M4 12h16M4 19h16"/>',
    "box": '<rect x="4" y="4" width="16" height="16"/>',
    "zigzag": '<path d="M3 18l6-12 6 12 6-12"/>',
    "arch": '<path d="M4 20V12a8 8 0 0 1 16 0v8"/>',
}


def svg(body: str) -> str:
    return (
        '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 24 24">'
        f'<g fill="none" stroke="currentColor" stroke-width="2">{body}</g></svg>'
    )


@pytest.fixture(scope="session")
def places(tmp_path_factory) -> Places:
    random = np.random.default_rng(0)
    names = {shape: next(f"{shape} {k}" for k in range(99) if not split.held_out(f"{shape} {k}")) for shape in SHAPES}
    held = next(f"held {k}" for k in range(99) if split.held_out(f"held {k}"))
    # Sets enough that both readers get every name.
    rows = [[f"set {k}", "v", names[shape], []] for k in range(12) for shape in SHAPES] + [["lucide", "v", held, []]]
    rows += [["openmoji", "v", name, []] for name in names.values()]
    shown = [render.ink(svg(body)) for _ in range(12) for body in SHAPES.values()]
    shown += [render.ink(svg(SHAPES["ring"])), *(render.ink(svg(body)) for body in SHAPES.values())]
    wired = [np.stack([wires.wire(wires.lines(ink), random) for _ in range(prepare.WIRES)]) for ink in shown]
    found = Places(tmp_path_factory.mktemp("data"))
    found.icons.write_text(json.dumps(rows))
    np.save(found.pictures, np.stack(shown))
    np.save(found.wires, np.stack(wired))
    words = [*names.values(), held]
    embedded = np.pad(unit(random.normal(size=(len(words), EMBED - 1))), ((0, 0), (0, 1))).astype(np.float32)
    np.savez(found.texts, words=np.array(words), rows=embedded)
    return found
