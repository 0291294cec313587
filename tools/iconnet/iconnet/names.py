"""What the judge needs beside its file, so that other programs can ask it: `judge.json`.

    python -m iconnet.names DATA

`words` are all names of both tests, `asked` the twenty held-out ones of the trials, and `usual` is the mean of what the exported
judge sees in wires of the tests' icons. A word's score for a picture is its row, centred over `words` and made unit, times what is
seen less what is usual (`guide.Judge`).
"""

import json
import sys
from pathlib import Path

import numpy as np
import torch

from . import data, evaluate, export, guide, views
from .places import WEIGHTS, Places, need


def write(places: Places, folder: Path) -> int:
    """`judge.json` into `folder`, where the exported judge lies. Returns how many names it has. Raises MissingStep before `prepare`."""
    export.exporter()
    from guidance.runtime import Session

    icons = data.icons(places)
    which = np.concatenate([evaluate.rows(icons, test) for test in evaluate.TESTS])
    judge = Session(need(folder / "iconnet-judge.onnx", "export judge"))
    seen = [_seen(judge, icons.wires[which[i : i + 64], 0]) for i in range(0, len(which), 64)]
    facts = {
        "words": sorted({icons.names[i] for i in which}),
        "asked": guide.test_words(icons),
        "usual": [round(float(x), 6) for x in np.concatenate(seen).mean(0)],
    }
    text = "{\n" + ",\n".join(f" {json.dumps(k)}: {json.dumps(v, separators=(',', ':'))}" for k, v in facts.items()) + "\n}\n"
    (folder / "judge.json").write_text(text, encoding="utf-8")
    return len(facts["words"])


def _seen(judge, pictures: np.ndarray) -> np.ndarray:
    """Unit rows [n,EMBED] of uint8 ink [n,S,S]."""
    image = (1 - views.plain(torch.from_numpy(np.ascontiguousarray(pictures)))).expand(-1, 3, -1, -1).numpy()
    nil = np.zeros((len(image), judge.inputs[1].shape[1]), np.float32)
    return judge.run({"image": image, "source": nil, "target": nil, "weight": nil[:, 0]})["embedding"]


if __name__ == "__main__":
    print(f"{write(Places(Path(sys.argv[1])), WEIGHTS)} names")
