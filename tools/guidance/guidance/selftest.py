"""What a file should answer to inputs made by a formula: whoever opens it can tell whether their runtime computes it rightly.

A runtime that is off by more than the tolerance must not be used for that file: onnxruntime-web on WebGPU has been seen to
compute single operators wrongly without an error.
"""

from collections.abc import Callable

import numpy as np

from . import noise
from .contracts import Contract, Port

Arrays = dict[str, np.ndarray]
BATCH = 2
TOLERANCE = {"relative": 1e-2, "absolute": 1e-3, "cosine": 0.9995}


def inputs(contract: Contract) -> list[tuple[str, dict[str, dict]]]:
    """The cases of one kind of file: a name, and how to fill each input."""
    image = {"fill": "uniform", "seed": 1}
    if contract.kind == "guidance-v1":
        rest = {"target": {"fill": "unit", "seed": 2}, "weight": {"fill": "constant", "value": 1 / BATCH}}
        return [
            ("plain", {"image": image, "source": {"fill": "constant", "value": 0.0}, **rest}),
            ("directional", {"image": image, "source": {"fill": "unit", "seed": 3}, **rest}),
        ]
    if contract.kind == "vjp-v1":
        return [("pull", {"image": image, "cotangent": {"fill": "signed", "seed": 4}})]
    if contract.kind in ("text-v1", "context-v1"):
        return [("words", {"ids": {"fill": "count", "first": 1}})]
    if contract.kind in ("mask-v1", "depth-v1"):
        return [("see", {"image": image})]
    if contract.kind == "pose-v1":
        return [("see", {"image": image, "pose": {"fill": "signed", "seed": 7}})]
    denoise = {
        "x_t": {"fill": "signed", "seed": 5},
        "t": {"fill": "constant", "value": 500.0},
        "context": {"fill": "signed", "seed": 6},
        "beside": {"fill": "signed", "seed": 8},
    }
    return [("denoise", {port.name: denoise[port.name] for port in contract.inputs})]


FILLS = {
    "uniform": "u(seed, i)",
    "signed": "2 u(seed, i) - 1",
    "unit": "signed, each row over its length",
    "constant": "value",
    "count": "first + i mod the row's length",
}


def fill(how: dict, port: Port, batch: int) -> np.ndarray:
    """One input, from its description in a sidecar. Raises ValueError for a fill that this version does not know."""
    shape, kind = port.sized(batch), how.get("fill")
    if kind == "uniform":
        values = noise.uniform(how["seed"], shape)
    elif kind == "signed":
        values = noise.signed(how["seed"], shape)
    elif kind == "unit":
        values = noise.unit_rows(how["seed"], shape)
    elif kind == "constant":
        values = np.full(shape, how["value"])
    elif kind == "count":
        values = how["first"] + np.arange(int(np.prod(shape))).reshape(shape) % shape[-1]
    else:
        raise ValueError(f"the fill {kind!r} is unknown")
    return values.astype(port.dtype)


def feeds(case: dict, contract: Contract, batch: int) -> Arrays:
    """All inputs of a case."""
    return {port.name: fill(case["inputs"][port.name], port, batch) for port in contract.inputs}


def measure(values: np.ndarray) -> dict:
    """What a sidecar keeps of an output: all of up to 64 numbers, else their length and a sketch of them."""
    values = np.asarray(values, np.float64)
    if values.size <= noise.BUCKETS:
        return {"values": _digits(values)}
    return {"l2": _digits(np.linalg.norm(values))[0], "sketch": _digits(noise.sketch(values))}


def write(contract: Contract, run: Callable[[Arrays], Arrays]) -> dict:
    """A sidecar's `selftest`, from what `run` answers."""
    batch = BATCH if contract.dynamic else 1
    cases = []
    for name, how in inputs(contract):
        case = {"name": name, "inputs": how}
        answers = run(feeds(case, contract, batch))
        case["outputs"] = {port.name: measure(answers[port.name]) for port in contract.outputs}
        cases.append(case)
    used = {how["fill"] for case in cases for how in case["inputs"].values()}
    return {
        "noise": noise.FORMULA,
        "sketch": noise.SKETCH,
        "fills": {name: said for name, said in FILLS.items() if name in used},
        "batch": batch,
        "tolerance": dict(TOLERANCE),
        "cases": cases,
    }


def faults(selftest: dict, contract: Contract, run: Callable[[Arrays], Arrays]) -> list[str]:
    """A sentence for each output of each case that is off; empty if the runtime behind `run` may be used.

    Raises KeyError, TypeError or ValueError where the self-test itself is malformed.
    """
    said = []
    for case in selftest["cases"]:
        answers = run(feeds(case, contract, selftest["batch"]))
        for port in contract.outputs:
            where = f"Self-test '{case['name']}', output '{port.name}'"
            fault = _off(case["outputs"][port.name], np.asarray(answers[port.name], np.float64), selftest["tolerance"])
            said += [f"{where}: {fault}"] if fault else []
    return said


def _off(expected: dict, values: np.ndarray, tolerance: dict) -> str | None:
    if not np.isfinite(values).all():
        return "the answer has numbers that are not finite."
    wanted = np.asarray(expected["values" if "values" in expected else "sketch"], np.float64)
    if not np.isfinite(wanted).all():
        return "the sidecar's expected numbers are not finite. Export the file again."
    found = values.ravel() if "values" in expected else noise.sketch(values)
    if found.shape != wanted.shape:
        return f"{found.size} numbers to compare, and the sidecar has {wanted.size}."
    if "values" in expected:
        off = np.abs(found - wanted).max(initial=0)
        allowed = tolerance["absolute"] + tolerance["relative"] * np.abs(wanted).max(initial=0)
        return None if off <= allowed else f"off by {off:.3g}, and {allowed:.3g} is allowed."
    length, meant = float(np.linalg.norm(values)), expected["l2"]
    if not abs(length - meant) <= tolerance["relative"] * meant:
        return f"its length is {length:.5g} and should be {meant:.5g}, within {tolerance['relative']:.0%}."
    alike = cosine(found, wanted)
    if not alike >= tolerance["cosine"]:
        return f"its direction has cosine {alike:.5f} with the expected one, and {tolerance['cosine']} is the least."
    return None


def _digits(values) -> list[float]:
    """Nine digits hold a float32."""
    return [float(f"{v:.9g}") for v in np.ravel(values)]


def cosine(a: np.ndarray, b: np.ndarray) -> float:
    """Of the angle between two arrays of one size; 1 where both are zero."""
    a, b = np.asarray(a, np.float64).ravel(), np.asarray(b, np.float64).ravel()
    lengths = np.linalg.norm(a) * np.linalg.norm(b)
    return float(a @ b / lengths) if lengths > 0 else float(not a.any() and not b.any())
