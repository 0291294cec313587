"""Makes tests/data/guidance again: tiny files of every kind, their sidecars, and all that they should answer; and what the formulas and a tokenizer give, for whoever writes them in another language.

    python scripts/make_fixture.py [FOLDER]

With the pinned requirements the files come out byte-equal; with others at least the numbers are equal (1e-5 of an array's
length), which tests/test_fixture.py checks.
"""

import sys
from collections import Counter
from pathlib import Path

import numpy as np
import torch

ROOT = Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "tools/guidance"))

from guidance import contracts, export, networks, noise, schedule, selftest, sidecar, sources, tokens  # noqa: E402
from guidance.runtime import Session  # noqa: E402

FOLDER = ROOT / "tests/data/guidance"
NAME = "vit-tiny"
TEXT = "text-tiny"
LICENCE = "made up for tests: as this repository"
# `eps-tiny` denoises latents of `vjp-tiny`; `eps-pixels-tiny` grey pixels.
OTHERS = {
    "vjp-tiny": (export.latent_encoder, "latent", "tiny:square"),
    "eps-tiny": (export.denoiser, "denoiser", "tiny"),
    "eps-pixels-tiny": (export.denoiser, "denoiser", "tiny:pixels"),
}
CORPUS = (
    "a photo of a cat, a photo of a dog, a wire drawing of a cat, the cat's tail and the dog's tail, one continuous wire that "
    "draws a flower, a sculpture of wire, drawings, photographs, flowers and sculptures made of continuous wires, they're there"
)
TEXTS = (
    "a cat",
    "A continuous 3D wire drawing",
    "a photo of a   cat's face, isn't it?",
    "na\u00efve caf\u00e9 &amp;amp; \u65e5\u672c\u8a9e \u2026 42\u00bd \u00bfqu\u00e9? snake_case",
    "&#39;they&#x27;re&quot; &lt;there&gt;",
    "tab\there\x1cand\x85there\u2003wide",
    "wire drawings " * 40,
    "\U0001f642\U0001f469\u200d\U0001f680!!",
    "\u0130stanbul \u039f\u0394\u039f\u03a3 stra\u00dfe",
)


def make(folder: Path) -> None:
    """Writes NAME.onnx, NAME.json and NAME.expected.json of each kind, vit-tiny.expected.bin, text-tiny.tokenizer.json and formulas.json."""
    image(folder)
    text(folder)
    for name, (write, part, model) in OTHERS.items():
        report = write(sources.load(part, model), export.Label(name, "random numbers, seeded", LICENCE), folder, "fp16")
        answers(report.file)
    # Two of a model of new views, which sees latents of `vjp-tiny`.
    torch.manual_seed(0)
    label = lambda name: export.Label(name, "random numbers, seeded", LICENCE)
    views = export.Denoiser(networks.TinyBeside(), (4, 8, 8), (1, 16), schedule.STABLE_DIFFUSION, np.zeros(16), (4, 8, 8))
    answers(export.denoiser(views, label("eps-views-tiny"), folder, "fp16").file)
    answers(export.pose_encoder(export.PoseEncoder(networks.TinyPose(), 32, (1, 16)), label("pose-tiny"), folder).file)
    for what in ("mask", "depth"):
        made = export.Label(f"{what}-tiny", "what is red", LICENCE)
        answers(export.sight(what, networks.TinySight(), (32, 32), made, folder).file)
    sidecar.write(formulas(), folder / "formulas.json")


def image(folder: Path) -> None:
    label = export.Label(NAME, "random numbers, seeded", LICENCE)
    given = sources.load("image", "tiny")
    report = export.image_encoder(given, label, folder)
    contract = contracts.guidance(given.size, given.embed)
    session = Session(report.file)
    facts = sidecar.read(sidecar.path_of(report.file))
    arrays, cases = [], []
    for case in facts["selftest"]["cases"]:
        answers = session.run(selftest.feeds(case, contract, facts["selftest"]["batch"]))
        for port in contract.outputs:
            shape = port.sized(facts["selftest"]["batch"])
            at = sum(a.size for a in arrays)
            cases.append({"case": case["name"], "output": port.name, "at": at, "shape": list(shape)})
            arrays.append(answers[port.name].astype("<f4").ravel())
    np.concatenate(arrays).tofile(folder / f"{NAME}.expected.bin")
    about = {
        "about": "What the file answers to the cases of its sidecar's self-test: little-endian float32, 'at' numbers in.",
        "file": f"{NAME}.expected.bin",
        "arrays": cases,
    }
    sidecar.write(about, folder / f"{NAME}.expected.json")


def text(folder: Path) -> None:
    """Stored as fp16, to be small."""
    report = export.text_encoder(sources.load("text", "tiny"), export.Label(TEXT, "random numbers, seeded", LICENCE), folder, "fp16")
    tokenizer = tokens.read(folder / f"{TEXT}.tokenizer.json")
    session = Session(report.file)
    rows = [{"text": t, "embedding": numbers(session.run({"ids": tokenizer([t])})["embedding"])} for t in TEXTS[:3]]
    sidecar.write({"about": "What the file answers to texts.", "texts": rows}, folder / f"{TEXT}.expected.json")


def answers(file: Path) -> None:
    """Writes what a file answers to the one case of its self-test."""
    facts = sidecar.read(sidecar.path_of(file))
    contract, (case,) = contracts.of_sidecar(facts, file.name), facts["selftest"]["cases"]
    found = Session(file).run(selftest.feeds(case, contract, facts["selftest"]["batch"]))
    about = {"about": "What the file answers to the case of its sidecar's self-test."}
    sidecar.write(about | {name: numbers(values, 7) for name, values in found.items()}, file.with_suffix(".expected.json"))


def formulas() -> dict:
    """Numbers of `noise`, and ids of a tokenizer with merges enough to be merged in every order."""
    tokenizer = tokens.file_of(merges(CORPUS, 50), context=24, pad=7)
    read = tokens.Tokenizer(tokenizer)
    values = noise.signed(4, (1000,))
    return {
        "about": "What guidance.noise and guidance.tokens give: for tests in other languages.",
        "mix": [{"x": x, "mix": int(noise.mix(np.array([x]))[0])} for x in (0, 1, 12345, 2**31, 2**32 - 1)],
        "uniform": [{"seed": seed, "values": numbers(noise.uniform(seed, (5,)))} for seed in (0, 1, 77, 2**31)],
        "unit": {"seed": 3, "width": 4, "values": numbers(noise.unit_rows(3, (3, 4)))},
        "sketches": [{"seed": 4, "count": n, "values": numbers(noise.sketch(values[:n]), 17)} for n in (1, 5, 64, 1000)],
        "tokenizer": tokenizer,
        "tokens": [{"text": t, "ids": read([t])[0].tolist(), "all": read.encode(t)} for t in TEXTS],
    }


def merges(corpus: str, most: int) -> list[tuple[str, str]]:
    """Byte pairs, the commonest first, as a tokenizer's are found; of equal ones the first by alphabet."""
    words = [list(piece[:-1]) + [piece[-1] + tokens.END] for piece in tokens.PIECES.findall(corpus)]
    found = []
    while len(found) < most:
        pairs = Counter(pair for word in words for pair in zip(word, word[1:]))
        if not pairs:
            break
        best = min(pairs, key=lambda pair: (-pairs[pair], pair))
        found.append(best)
        for word in words:
            for i in range(len(word) - 1, 0, -1):
                if i < len(word) and (word[i - 1], word[i]) == best:
                    word[i - 1 : i + 1] = ["".join(best)]
    return found


def numbers(values, digits: int = 9) -> list[float]:
    return [float(f"{v:.{digits}g}") for v in np.ravel(values)]


if __name__ == "__main__":
    make(Path(sys.argv[1]) if len(sys.argv) > 1 else FOLDER)
