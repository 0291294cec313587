"""What is traced: plain functions of tensors that hold a frozen network and may ask autograd for a gradient."""

from collections.abc import Callable, Sequence

import torch

DIRECTION_EPS = 1e-6


def frozen(network: torch.nn.Module) -> torch.nn.Module:
    """The same network in float32 on the processor, in evaluation mode, without gradients for its weights."""
    return network.to("cpu", torch.float32).eval().requires_grad_(False)


def unit(rows: torch.Tensor, eps: float = 1e-12) -> torch.Tensor:
    """Rows [n, E] over sqrt(|row|^2 + eps): about unit length, and smooth at zero."""
    return rows / torch.sqrt((rows * rows).sum(-1, keepdim=True) + eps)


def guidance(encoder: torch.nn.Module, mean: Sequence[float], std: Sequence[float]) -> Callable:
    """guidance-v1 of an encoder [n,3,S,S] -> [n,E] that wants (image - mean) / std.

    `cos` is between `target` and the direction from `source` to the image's embedding; a zero source makes that the plain
    CLIP loss. `loss` is the sum of weight (1 - cos); `grad` is its derivative by the image, in 0..1.
    `eps` in the direction keeps the gradient finite where the image is its own source: with 1e-12 there it would be a
    million times too long.
    """
    encoder = frozen(encoder)
    centre = torch.tensor(mean).view(1, 3, 1, 1)
    scale = 1 / torch.tensor(std).view(1, 3, 1, 1)

    def run(image, source, target, weight):
        pixels = image.detach().requires_grad_(True)
        embedding = unit(encoder((pixels - centre) * scale))
        cos = (unit(embedding - source, DIRECTION_EPS) * target).sum(-1)
        loss = (weight * (1 - cos)).sum()
        (grad,) = torch.autograd.grad(loss, pixels)
        return loss.detach(), grad, cos.detach(), embedding.detach()

    return run


def vjp(encoder: torch.nn.Module) -> Callable:
    """vjp-v1 of an encoder [1,3,H,W] in 0..1 -> latent: the latent, and a cotangent (d loss / d latent) pulled back."""
    encoder = frozen(encoder)

    def run(image, cotangent):
        pixels = image.detach().requires_grad_(True)
        latent = encoder(pixels)
        (grad,) = torch.autograd.grad(latent, pixels, cotangent)
        return latent.detach(), grad

    return run


def text(encoder: torch.nn.Module) -> Callable:
    """text-v1 of an encoder int64 [n,context] -> [n,E]; ids come as int32, which browsers have plain arrays for."""
    encoder = frozen(encoder)
    return lambda ids: (unit(encoder(ids.to(torch.int64))),)


def context(encoder: torch.nn.Module) -> Callable:
    """context-v1 of an encoder int64 [n,tokens] -> [n,N,D]."""
    encoder = frozen(encoder)
    return lambda ids: (encoder(ids.to(torch.int64)),)


def pose(encoder: torch.nn.Module) -> Callable:
    """pose-v1 of an encoder (image [1,3,S,S] in 0..1, pose [n,4]) -> [n,N,D]."""
    encoder = frozen(encoder)
    return lambda image, pose: (encoder(image, pose),)


def eps(denoiser: torch.nn.Module) -> Callable:
    """eps-v1 of a denoiser (x_t, t, context) -> eps, or (x_t, t, context, beside) -> eps; t is a float in 0..999."""
    denoiser = frozen(denoiser)
    return lambda *given: (denoiser(*given),)


def sight(network: torch.nn.Module) -> Callable:
    """mask-v1 or depth-v1 of a network [1,3,H,W] in 0..1 -> [1,1,H,W]."""
    network = frozen(network)
    return lambda image: (network(image),)
