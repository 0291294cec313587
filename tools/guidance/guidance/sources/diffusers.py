"""Latent diffusion models in the form of diffusers: a folder that holds one model's config and weights, or a name."""

from pathlib import Path

import torch

from .. import export, schedule
from . import loaded, need

PIXELS = 512


def latent(model: str, _checkpoint=None) -> export.LatentEncoder:
    """AutoencoderKL (its mean) or AutoencoderTiny, at 512 px."""
    library = need("diffusers")
    config = loaded(model, lambda: library.AutoencoderKL.load_config(model))
    kind = getattr(library, config.get("_class_name", "AutoencoderKL"))
    return latent_of(loaded(model, lambda: kind.from_pretrained(model)))


def denoiser(model: str, _checkpoint=None) -> export.Denoiser:
    """UNet2DConditionModel, with 77 tokens of context. How noise grows is read from the `scheduler` folder beside the UNet's; without
    one it is taken to be Stable Diffusion's."""
    library = need("diffusers")
    unet = loaded(model, lambda: library.UNet2DConditionModel.from_pretrained(model))
    beside, found = Path(model).parent / "scheduler", schedule.STABLE_DIFFUSION
    if (beside / "scheduler_config.json").exists():
        found = schedule.of_config(loaded(str(beside), lambda: library.DDPMScheduler.load_config(str(beside))))
    return denoiser_of(unet, found)


def latent_of(vae: torch.nn.Module, pixels: int = PIXELS) -> export.LatentEncoder:
    """An autoencoder that is there already, for squares of `pixels`."""
    network = _Latent(vae).eval()
    with torch.no_grad():
        shape = network(torch.zeros(1, 3, pixels, pixels)).shape
    return export.LatentEncoder(network, (pixels, pixels), tuple(int(d) for d in shape[1:]))


def denoiser_of(unet: torch.nn.Module, grows=schedule.STABLE_DIFFUSION, tokens: int = 77) -> export.Denoiser:
    """A UNet2DConditionModel that is there already."""
    config = unet.config
    size = config.sample_size
    rows, columns = (size, size) if isinstance(size, int) else size
    return export.Denoiser(_Denoiser(unet), (config.in_channels, rows, columns), (tokens, config.cross_attention_dim), grows)


class _Latent(torch.nn.Module):
    """0..1 to -1..1, and the scale of the latent."""

    def __init__(self, vae):
        super().__init__()
        self.vae, self.scale = vae, vae.config.scaling_factor

    def forward(self, image):
        found = self.vae.encode(2 * image - 1)
        return self.scale * (found.latents if hasattr(found, "latents") else found.latent_dist.mean)


class _Denoiser(torch.nn.Module):
    def __init__(self, unet):
        super().__init__()
        self.unet = unet

    def forward(self, x_t, t, context):
        return self.unet(x_t, t, encoder_hidden_states=context).sample
