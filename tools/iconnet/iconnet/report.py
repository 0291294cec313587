"""Figures for people: recalls of the exported files, choices between icons, and the guidance trial with its sheet."""

import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import torch
from PIL import Image, ImageDraw

from . import data, diffuse, distil, evaluate, export, guide, pairs, shipped, views
from .errors import WordError
from .places import Places
from .shipped import Shipped
from .table import Table
from .words import EMBED

GUIDE_OPTIONS = ("controls", "steps", "rate", "views", "width", "smooth", "start", "starts", "seed")
TILE = 192
NAMES = ("a", "b", "judge")


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
            rows = {name: _embedded(folder, name, pictures) for name in NAMES}
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


def gradients(places: Places, folder: Path) -> str:
    """A Markdown table: each exported file's gradient against central differences along 24 directions, half of them the
    gradient's own, on wires; and processor time of a run with 1 and with 8 views."""
    icons, table = data.icons(places), Table(folder)
    which = evaluate.rows(icons, "held-out")[:12]
    pictures = 1 - views.plain(torch.from_numpy(np.ascontiguousarray(icons.wires[which, 0]))).numpy().repeat(3, 1)
    random, step = np.random.default_rng(0), np.float32(0.02)
    lines = ["| network | worst difference | ms for 1 view | ms a view, of 8 |", "|---|---|---|---|"]
    for name in NAMES:
        session, worst = shipped.session(folder, name), 0.0
        loss = lambda image, target: float(_run(session, image, target)["loss"])
        for picture, row in zip(pictures[:, None], table.rows[:: len(table.rows) // 12]):
            grad = _run(session, picture, row[None])["grad"].astype(np.float64)
            size = np.linalg.norm(grad)
            other = random.normal(size=grad.shape)
            for way in (grad / size, grad / size / 2**0.5 + other / np.linalg.norm(other) / 2**0.5):
                ahead, behind = ((picture + sign * step * way).astype(np.float32) for sign in (1, -1))
                found = (loss(ahead, row[None]) - loss(behind, row[None])) / (2 * step)
                worst = max(worst, abs(found - float((grad * way).sum())) / size)
        times = [_milliseconds(session, pictures[:n], table.rows[:n]) / n for n in (1, 8)]
        lines.append(f"| {name} | {worst:.1e} of the gradient's length | {times[0]:.1f} | {times[1]:.1f} |")
    return "\n".join(lines)


def _run(session, image: np.ndarray, target: np.ndarray) -> dict[str, np.ndarray]:
    """The plain loss, each picture weighing 1."""
    feeds = {"image": image, "source": np.zeros_like(target), "target": target, "weight": np.ones(len(image), np.float32)}
    return session.run(feeds)


def _milliseconds(session, image: np.ndarray, target: np.ndarray, times: int = 30) -> float:
    """Of one processor, and so about right on a busy machine too."""
    _run(session, image, target)
    began = time.process_time()
    for _ in range(times):
        _run(session, image, target)
    return (time.process_time() - began) / times * 1e3


def _embedded(folder: Path, name: str, pictures: np.ndarray) -> np.ndarray:
    """Unit rows [n,EMBED] by the exported file itself."""
    session, rows = shipped.session(folder, name), []
    for start in range(0, len(pictures), 64):
        ink = views.plain(torch.from_numpy(np.ascontiguousarray(pictures[start : start + 64]))).numpy()
        rows.append(_run(session, 1 - ink.repeat(3, 1), np.zeros((len(ink), EMBED), np.float32))["embedding"])
    return np.concatenate(rows)


def choices(places: Places, file: Path) -> str:
    """A Markdown table: right choices between pairs of icons, by the likeness that a guidance-v1 file sees."""
    export.exporter()
    from guidance.runtime import Session

    icons, session = data.icons(places), Session(file)
    ports = {port.name: port.shape for port in session.inputs}
    lines = ["| sets | pairs | of two | of all |", "|---|---|---|---|"]
    for left, right in pairs.SETS:
        rows = [pairs.seen(session.run, ports["image"][2], ports["target"][1], icons.pictures[which]) for which in pairs.pairs(icons, left, right)]
        found = pairs.choose(*rows)
        lines.append(f"| {left}, {right} | {found.pairs} | {found.of_two:.3f} | {found.first:.3f} |")
    return "\n".join(lines)


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
    say(summary(outcomes))
    if sheet:
        _sheet(outcomes, sheet)
    return outcomes


def distilled(places: Places, settings: distil.Settings, words: list[str], folder: Path, sheet: Path | None, say=print) -> list:
    """As `trial`, but the words pull through the denoiser, with the exported a and b where `settings` weigh their cosine, and the
    exported judge ranks. The first outcomes are those of curves that nothing has pulled."""
    icons, rows = data.icons(places), data.texts(places)
    words = words or guide.test_words(icons)
    judge, guides = guide.Judge(Shipped(folder, "judge"), icons, rows), [Shipped(folder, name) for name in "ab"]
    if missing := [word for word in words if word not in rows]:
        raise WordError(f"{missing[0]!r} is neither a name nor a tag of any icon. Try a plainer word for it.")
    targets = torch.from_numpy(np.stack([rows[word] for word in words]))
    cosines = [network.cosines for network in guides]
    both = []
    for steps in (0, settings.steps):
        say(f"{replace(settings, steps=steps)}")
        ink = distil.distil(export.denoiser_of(places), targets, replace(settings, steps=steps), cosines)
        reached = torch.stack([cosine(ink, targets) for cosine in cosines]).mean(0)
        outcomes = [_judged(judge, one[None], word, float(cosine)) for one, word, cosine in zip(ink, words, reached)]
        for o in outcomes if steps else []:
            say(f"{o.word}: rank {o.rank} of {o.of}, cosine {o.cosine:.2f}; judge: {', '.join(o.first)}")
        say(summary(outcomes))
        both += outcomes
    if sheet:
        _sheet(outcomes, sheet)
    return both


def drawn(places: Places, words: list[str], scale: float, sheet: Path) -> None:
    """A picture of what the denoiser draws of each word out of noise, seed 0, and to its right out of other noise."""
    rows = data.texts(places)
    if missing := [word for word in words if word not in rows]:
        raise WordError(f"{missing[0]!r} is neither a name nor a tag of any icon. Try a plainer word for it.")
    targets = torch.from_numpy(np.stack([rows[word] for word in words for _ in range(2)]))
    pictures = diffuse.draw(export.denoiser_of(places), targets, scale)
    inks = ((1 - pictures[:, 0]) * 127.5).round().clamp(0, 255).byte().numpy()
    _sheet([guide.Outcome(words[i // 2], ink, 0.0, 0, 0, []) for i, ink in enumerate(inks)], sheet, across=6)


def summary(outcomes: list) -> str:
    ranks = np.array([o.rank for o in outcomes])
    counts = ", ".join(f"<= {most}: {(ranks <= most).sum()}" for most in (10, 50, 100))
    return f"rank {counts} of {len(ranks)}; median {int(np.median(ranks))}"


def _judged(judge, ink: torch.Tensor, word: str, cosine: float) -> guide.Outcome:
    rank, first = judge(ink, word)
    return guide.Outcome(word, (ink[0, 0] * 255).round().byte().numpy(), cosine, rank, len(judge.names), first)


def _sheet(outcomes: list, file: Path, across: int = 5) -> None:
    """Each with its word below, and its rank where it was ranked."""
    down = -(-len(outcomes) // across)
    paper = Image.new("L", (across * TILE, down * (TILE + 16)), 255)
    pen = ImageDraw.Draw(paper)
    for i, outcome in enumerate(outcomes):
        x, y = i % across * TILE, i // across * (TILE + 16)
        paper.paste(Image.fromarray(255 - outcome.ink).resize((TILE, TILE), Image.Resampling.BICUBIC), (x, y))
        pen.text((x + 4, y + TILE), f"{outcome.word} ({outcome.rank})" if outcome.rank else outcome.word, fill=0)
    file.parent.mkdir(parents=True, exist_ok=True)
    paper.save(file)
