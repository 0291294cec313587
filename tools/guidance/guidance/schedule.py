"""How noise grows in a diffusion model: a sidecar's `schedule`.

At time t, 0 to steps - 1, what a denoiser is given is `sqrt(alpha_bar[t]) x + sqrt(1 - alpha_bar[t]) noise`, and alpha_bar is the
product of 1 - beta up to t.
"""

import math
from dataclasses import dataclass

import numpy as np

from .errors import ModelError

KINDS = ("cosine", "linear", "scaled-linear")
MOST_BETA = 0.999


@dataclass(frozen=True)
class Schedule:
    """`linear` has betas in even steps from `start` to `end` (Ho et al. 2020), `scaled-linear` their square roots in even steps (Stable
    Diffusion), and `cosine` neither of the two (Nichol and Dhariwal 2021).

    Raises ModelError where that is no schedule.
    """

    kind: str
    steps: int = 1000
    start: float | None = None
    end: float | None = None

    def __post_init__(self):
        said = faults(self.as_json())
        if said:
            raise ModelError(" ".join(said))

    def as_json(self) -> dict:
        """For a sidecar."""
        ends = {"from": self.start, "to": self.end}
        return {"kind": self.kind, "steps": self.steps, **{key: value for key, value in ends.items() if value is not None}}

    def alpha_bar(self) -> np.ndarray:
        """float64 [steps]."""
        if self.kind == "cosine":
            level = np.cos((np.arange(self.steps + 1) / self.steps + 0.008) / 1.008 * math.pi / 2) ** 2
            beta = np.minimum(1 - level[1:] / level[:-1], MOST_BETA)
        elif self.kind == "linear":
            beta = np.linspace(self.start, self.end, self.steps)
        else:
            beta = np.linspace(self.start**0.5, self.end**0.5, self.steps) ** 2
        return np.cumprod(1 - beta)


def of_config(config: dict) -> Schedule:
    """From the config of a scheduler of diffusers. Raises ModelError for betas of another kind, and where noise is not what its model
    answers with."""
    if config.get("prediction_type", "epsilon") != "epsilon":
        raise ModelError(f"The model answers with {config['prediction_type']!r}, and eps-v1 with the noise itself.")
    kind = {"linear": "linear", "scaled_linear": "scaled-linear", "squaredcos_cap_v2": "cosine"}.get(
        config.get("beta_schedule")
    )
    if kind is None or config.get("trained_betas") is not None:
        raise ModelError(
            f"The scheduler's betas are of the kind {config.get('beta_schedule')!r}, and a sidecar knows {', '.join(KINDS)}."
        )
    steps = int(config.get("num_train_timesteps", 1000))
    return Schedule(kind, steps) if kind == "cosine" else Schedule(kind, steps, config["beta_start"], config["beta_end"])


def faults(given) -> list[str]:
    """A sentence for each thing that is wrong with a sidecar's `schedule`."""
    if not isinstance(given, dict) or given.get("kind") not in KINDS:
        return [f"'schedule' must have a kind of {', '.join(KINDS)}, and it is {given!r}."]
    said = []
    steps = given.get("steps")
    if type(steps) is not int or steps < 1:
        said.append(f"The schedule's 'steps' must be a positive whole number, and it is {steps!r}.")
    ends = [given.get("from"), given.get("to")]
    if given["kind"] == "cosine":
        said += ["A cosine schedule has neither 'from' nor 'to'."] if ends != [None, None] else []
    elif not all(type(e) in (int, float) for e in ends) or not 0 < ends[0] <= ends[1] < 1:
        said.append(
            f"The schedule's 'from' and 'to' must be betas, 0 < from <= to < 1, and they are {ends[0]!r} and {ends[1]!r}."
        )
    return said


STABLE_DIFFUSION = Schedule("scaled-linear", 1000, 0.00085, 0.012)
