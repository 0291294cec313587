"""The command line: `prepare`, `train`, `export`, `evaluate`, `pairs`, `guide`, `distil`, `draw`."""

import argparse
import math
import os
import sys
from pathlib import Path

from .errors import IconnetError
from .places import WEIGHTS, Places

NETWORKS = ("a", "b", "judge")
DENOISER = "denoiser"


def main(arguments: list[str] | None = None) -> int:
    """0 if all went well, 1 with a sentence on standard error if not, 2 for a wrong command line."""
    given = _parser().parse_args(arguments)
    try:
        import torch

        torch.set_num_threads(given.threads)
        given.run(Places(given.data), given)
        return 0
    except (IconnetError, OSError) as error:
        print(error, file=sys.stderr)
        return 1


def _prepare(places: Places, given) -> None:
    from . import data, prepare

    print(f"{prepare.pictures(places, given.threads)} icons drawn")
    data.embed(places)
    print(f"{len(data.texts(places))} words embedded")


def _train(places: Places, given) -> None:
    from . import diffuse, train

    say = lambda *line: print(*line, flush=True)
    options = given.steps, given.minutes, given.resume
    if given.network == DENOISER:
        say(diffuse.train(places, *options, say=say))
    else:
        say(train.train(places, given.network, *options, say=say))


def _export(places: Places, given) -> None:
    from . import export

    if given.networks != [DENOISER]:
        print(f"words: {export.word_table(places, given.out):,} bytes")
    for name in given.networks:
        report = export.eps(places, given.out) if name == DENOISER else export.network(places, name, given.out)
        ((port, cosine),) = [(p, c) for p, c in report.cosine.items() if p in ("grad", "eps")]
        print(f"{report.file.name}: {report.bytes:,} bytes, {port} cosine {cosine:.6f} with torch's")


def _evaluate(places: Places, given) -> None:
    from . import report

    print(report.recalls(places, given.out), report.gradients(places, given.out), sep="\n\n")


def _pairs(places: Places, given) -> None:
    from . import report

    print(report.choices(places, given.file))


def _guide(places: Places, given) -> None:
    from . import guide, report

    settings = guide.Settings(**{key: getattr(given, key) for key in report.GUIDE_OPTIONS if getattr(given, key) is not None})
    report.trial(places, settings, given.words, given.guides, given.sheet, say=lambda *line: print(*line, flush=True))


def _distil(places: Places, given) -> None:
    from dataclasses import fields

    from . import distil, report

    given_for = {f.name: getattr(given, f.name) for f in fields(distil.Settings) if getattr(given, f.name, None) is not None}
    pairs = {key: tuple(value) for key, value in given_for.items() if isinstance(value, list)}
    settings = distil.Settings(**given_for | pairs)
    report.distilled(places, settings, given.words, given.out, given.sheet, say=lambda *line: print(*line, flush=True))


def _draw(places: Places, given) -> None:
    from . import report

    report.drawn(places, given.words, given.scale, given.sheet)
    print(given.sheet)


def _network(text: str) -> str:
    if text not in (*NETWORKS, DENOISER):
        raise argparse.ArgumentTypeError(f"{text!r} is no network: name some of {', '.join((*NETWORKS, DENOISER))}")
    return text


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="python -m iconnet", description="A small joint network of pictures and words.")
    parser.add_argument("--data", type=Path, default=Path("data"), metavar="FOLDER", help="packages, pictures, checkpoints")
    parser.add_argument("--threads", type=int, default=os.cpu_count() or 1)
    verbs = parser.add_subparsers(required=True, metavar="VERB")

    prepare = verbs.add_parser("prepare", help="fetch packages, draw icons and wires, embed words")
    prepare.set_defaults(run=_prepare)

    train = verbs.add_parser("train", help="train one network")
    train.add_argument("network", choices=(*NETWORKS, DENOISER))
    train.add_argument("--steps", type=int, default=4000)
    train.add_argument("--minutes", type=float, default=math.inf, help="end earlier, at a low rate, when these are over")
    train.add_argument("--resume", action="store_true", help="go on from the last checkpoint's weights")
    train.set_defaults(run=_train)

    export = verbs.add_parser("export", help="write weights as guidance-v1 or eps-v1, and the word table")
    export.add_argument("networks", nargs="*", type=_network, default=list(NETWORKS), help="none: all but the denoiser")
    export.add_argument("--out", type=Path, default=WEIGHTS, metavar="FOLDER")
    export.set_defaults(run=_export)

    evaluate = verbs.add_parser("evaluate", help="print recalls of the exported networks, their gradients' errors and their times")
    evaluate.add_argument("--out", type=Path, default=WEIGHTS, metavar="FOLDER", help="where the exported files are")
    evaluate.set_defaults(run=_evaluate)

    pairs = verbs.add_parser("pairs", help="which of two icons is the same thing as a third? by a guidance-v1 file's likeness")
    pairs.add_argument("file", type=Path, metavar="FILE.onnx")
    pairs.set_defaults(run=_pairs)

    guide = verbs.add_parser("guide", help="let words pull a curve, and ask the judge")
    guide.add_argument("words", nargs="*", help="none: twenty held-out names drawn by seed 0")
    guide.add_argument("--guides", default="ab", choices=("a", "b", "ab"), help="which networks pull")
    guide.add_argument("--sheet", type=Path, metavar="PNG", help="a picture of all outcomes")
    guide.add_argument("--start", choices=("ring", "tangle"))
    for option, kind in (("controls", int), ("steps", int), ("views", int), ("starts", int), ("seed", int)):
        guide.add_argument(f"--{option}", type=kind)
    for option in ("rate", "width", "smooth"):
        guide.add_argument(f"--{option}", type=float)
    guide.set_defaults(run=_guide)

    distil = verbs.add_parser("distil", help="let words pull a curve through the denoiser, and ask the judge")
    distil.add_argument("words", nargs="*", help="none: twenty held-out names drawn by seed 0")
    distil.add_argument("--out", type=Path, default=WEIGHTS, metavar="FOLDER", help="where the exported networks are")
    distil.add_argument("--sheet", type=Path, metavar="PNG", help="a picture of all outcomes")
    distil.add_argument("--start", choices=("ring", "tangle"))
    distil.add_argument("--turned", action=argparse.BooleanOptionalAction)
    for option in ("controls", "steps", "views", "levels", "seed"):
        distil.add_argument(f"--{option}", type=int)
    for option in ("rate", "width", "smooth", "length", "scale", "sds", "cosine"):
        distil.add_argument(f"--{option}", type=float)
    for option in ("least", "most"):
        distil.add_argument(f"--{option}", type=float, nargs=2, metavar=("FIRST", "LAST"), help="times as shares of all")
    distil.set_defaults(run=_distil)

    draw = verbs.add_parser("draw", help="let the denoiser draw words out of noise")
    draw.add_argument("words", nargs="+")
    draw.add_argument("--scale", type=float, default=4.0, help="of guidance")
    draw.add_argument("--sheet", type=Path, required=True, metavar="PNG")
    draw.set_defaults(run=_draw)
    return parser
