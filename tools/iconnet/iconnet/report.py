"""Figures for people: recalls of the exported files, and the guidance trial with its sheet."""

from pathlib import Path

import numpy as np
import torch
from PIL import Image, ImageDraw

from . import data, evaluate, export, guide, views
from .places import Places, need
from .table import Table

GUIDE_OPTIONS = ("controls", "steps", "rate", "views", "width", "smooth", "start", "starts", "seed")
TILE = 192


def recalls(places: Places, folder: Path) -> str:
    """A Markdown table: each exported network, and a and b together (the mean of their unit rows), on pictures and on wires."""
    icons, table = data.icons(places), Table(folder)
    words = dict(zip(table.words, table.rows))
    lines = ["| network | test | shown as | R@1 | R@5 | R@10 | median rank | names |", "|---|---|---|---|---|---|---|---|"]
    for test in evaluate.TESTS:
        which = evaluate.rows(icons, test)
        names = [icons.names[i] for i in which]
        strange = evaluate.strange(icons, which)
        for shown, pictures in (("icons", icons.pictures[which]), ("wires", icons.wires[which, 0])):
            rows = {name: _embedded(folder, name, pictures) for name in ("a", "b", "judge")}
            rows["a + b"] = rows["a"] + rows["b"]
            for name in ("a", "b", "a + b", "judge"):
                rank = evaluate.ranks(rows[name], names, words)
                kinds = [(test, np.ones(len(rank), bool))]
                if test == "held-out":
                    kinds.append((f"{test}, strange words only", strange))
                for kind, part in kinds:
                    r = evaluate.recall(rank[part], len(set(names)))
                    lines.append(
                        f"| {name} | {kind} ({part.sum()}) | {shown} | {r.first:.3f} | {r.five:.3f} | {r.ten:.3f} "
                        f"| {r.middle} | {r.candidates} |"
                    )
    return "\n".join(lines)


def _embedded(folder: Path, name: str, pictures: np.ndarray) -> np.ndarray:
    """Unit rows [n,EMBED] by the exported file itself."""
    export.exporter()
    from guidance.runtime import Session

    session = Session(need(folder / f"iconnet-{name}.onnx", "export"))
    rows = []
    for start in range(0, len(pictures), 64):
        ink = views.plain(torch.from_numpy(np.ascontiguousarray(pictures[start : start + 64]))).numpy()
        n, embed = len(ink), session.inputs[1].shape[1]
        nil = np.zeros((n, embed), np.float32)
        feeds = {"image": np.repeat(1 - ink, 3, 1), "source": nil, "target": nil, "weight": np.zeros(n, np.float32)}
        rows.append(session.run(feeds)["embedding"])
    return np.concatenate(rows)


def trial(places: Places, settings: guide.Settings, words: list[str], guides: str, sheet: Path | None, say=print) -> list:
    """Prints each word's outcome as it comes, and writes `sheet` if one is asked for."""
    icons, rows = data.icons(places), data.texts(places)
    judge = guide.Judge(export.trained(places, "judge"), icons, rows)
    networks = [export.trained(places, name) for name in guides]
    words = words or guide.test_words(icons)
    say(f"{settings}, guided by {' and '.join(guides)}")
    outcomes = []
    for word in words:
        (outcome,) = guide.trial(networks, judge, [word], rows, settings)
        outcomes.append(outcome)
        say(f"{word}: rank {outcome.rank} of {outcome.of}, cosine {outcome.cosine:.2f}; judge: {', '.join(outcome.first)}")
    ranks = np.array([o.rank for o in outcomes])
    say(f"rank <= 10: {(ranks <= 10).sum()}, <= 50: {(ranks <= 50).sum()}, <= 100: {(ranks <= 100).sum()} of {len(ranks)}; "
        f"median {int(np.median(ranks))}")  # fmt: skip
    if sheet:
        _sheet(outcomes, sheet)
    return outcomes


def _sheet(outcomes: list, file: Path) -> None:
    """Five a row, each with its word and rank below."""
    across = 5
    down = -(-len(outcomes) // across)
    paper = Image.new("L", (across * TILE, down * (TILE + 16)), 255)
    pen = ImageDraw.Draw(paper)
    for i, outcome in enumerate(outcomes):
        x, y = i % across * TILE, i // across * (TILE + 16)
        paper.paste(Image.fromarray(255 - outcome.ink).resize((TILE, TILE), Image.Resampling.BICUBIC), (x, y))
        pen.text((x + 4, y + TILE), f"{outcome.word} ({outcome.rank})", fill=0)
    file.parent.mkdir(parents=True, exist_ok=True)
    paper.save(file)
