"""What several tests share. Exports take seconds, so each network is exported once."""

from functools import cache
from pathlib import Path

import numpy as np
import pytest
import torch

from guidance import contracts, graph, losses, noise, sources
from guidance.runtime import Session

FIXTURE = Path(__file__).resolve().parents[3] / "tests/data/guidance"


@pytest.fixture(autouse=True, scope="session")
def one_thread():
    torch.set_num_threads(1)


@cache
def exported(model: str):
    """(encoder, torch function, program, session) of a tiny image encoder."""
    given = sources.load("image", f"tiny:{model}")
    function = losses.guidance(given.network, given.mean, given.std)
    program = graph.build(function, contracts.guidance(given.size, given.embed))
    return given, function, program, Session(program.SerializeToString())


def feeds(given, batch: int, plain: bool) -> dict[str, np.ndarray]:
    """Inputs of a guidance file."""
    rows = (batch, given.embed)
    return {
        "image": noise.uniform(11, (batch, 3, given.size, given.size)),
        "source": np.zeros(rows, np.float32) if plain else noise.unit_rows(12, rows),
        "target": noise.unit_rows(13, rows),
        "weight": (0.5 + noise.uniform(14, (batch,))) / batch,
    }


def tensors(arrays: dict[str, np.ndarray]) -> list[torch.Tensor]:
    return [torch.from_numpy(a) for a in arrays.values()]


def off(a, b) -> float:
    """Largest difference over the largest number."""
    a, b = np.asarray(a, np.float64), np.asarray(b, np.float64)
    return float(np.abs(a - b).max() / max(np.abs(b).max(), 1e-30))
