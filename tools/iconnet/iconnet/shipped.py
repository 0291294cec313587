"""The exported networks as functions of ink, so that trials need no checkpoint."""

from pathlib import Path

import numpy as np
import torch

from . import export
from .places import need


def session(folder: Path, name: str):
    """onnxruntime on `iconnet-NAME.onnx`. Raises MissingStep where it is not there."""
    export.exporter()
    from guidance.runtime import Session

    return Session(need(folder / f"iconnet-{name}.onnx", "export"))


class Shipped:
    """A network of pictures: called with ink [n,1,64,64] it gives unit rows [n,EMBED], without a gradient; `cosines` has one."""

    def __init__(self, folder: Path, name: str):
        self._session = session(folder, name)
        self._embed = self._session.inputs[1].shape[1]

    def __call__(self, ink: torch.Tensor) -> torch.Tensor:
        nil = np.zeros((len(ink), self._embed), np.float32)
        return torch.from_numpy(self._run(ink, nil)["embedding"])

    def cosines(self, ink: torch.Tensor, target: torch.Tensor) -> torch.Tensor:
        """[n], of ink and unit rows [n,EMBED]."""
        return _Cosines.apply(ink, target, self)

    def eval(self) -> "Shipped":
        """As it always is; for what takes networks on their way, too."""
        return self

    def _run(self, ink, target) -> dict[str, np.ndarray]:
        image = (1 - ink.detach()).expand(-1, 3, -1, -1).numpy()
        weight = np.ones(len(image), np.float32)
        return self._session.run({"image": image, "source": np.zeros_like(target), "target": target, "weight": weight})


class _Cosines(torch.autograd.Function):
    @staticmethod
    def forward(ctx, ink, target, network):
        found = network._run(ink, target.numpy())
        # The loss is a sum of 1 - cos, and ink is 1 - picture.
        ctx.slope = torch.from_numpy(found["grad"]).sum(1, keepdim=True)
        return torch.from_numpy(found["cos"])

    @staticmethod
    def backward(ctx, grad):
        return grad.view(-1, 1, 1, 1) * ctx.slope, None, None
