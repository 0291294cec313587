"""Makes tests/data/guidance again: a tiny guidance-v1 file, its sidecar, and all numbers that it should answer.

    python scripts/make_fixture.py [FOLDER]

With the pinned requirements the files come out byte-equal; with others at least the numbers are equal (1e-5 of an array's
length), which tests/test_fixture.py checks.
"""

import sys
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "tools/guidance"))

from guidance import contracts, export, selftest, sidecar, sources  # noqa: E402
from guidance.runtime import Session  # noqa: E402

FOLDER = ROOT / "tests/data/guidance"
NAME = "vit-tiny"


def make(folder: Path) -> None:
    """Writes vit-tiny.onnx, vit-tiny.json, vit-tiny.expected.json and vit-tiny.expected.bin."""
    label = export.Label(NAME, "random numbers, seeded", "made up for tests: as this repository")
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


if __name__ == "__main__":
    make(Path(sys.argv[1]) if len(sys.argv) > 1 else FOLDER)
