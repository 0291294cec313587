"""Latent diffusion models in the form of diffusers: a folder that holds one model's config and weights, or a name."""

from pathlib import Path

import numpy as np
import torch

from .. import export, schedule
from ..errors import SourceError
from . import loaded, need
from .tiny import MEAN, STD

PIXELS = 512
SCALE = 0.18215  # of Stable Diffusion's latents
PROJECTIONS = ("clip_camera_projection", "cc_projection")


def latent(model: str, _checkpoint=None) -> export.LatentEncoder:
    """AutoencoderKL (its mean) or AutoencoderTiny, at 512 px."""
    library = need("diffusers")
    config = loaded(model, lambda: library.AutoencoderKL.load_config(model))
    kind = getattr(library, config.get("_class_name", "AutoencoderKL"))
    return latent_of(loaded(model, lambda: kind.from_pretrained(model)))


def denoiser(model: str, _checkpoint=None) -> export.Denoiser:
    """UNet2DConditionModel, with 77 tokens of context; or, if it takes a second latent beside the first, as Zero-1-to-3's, with one.
    How noise grows is read from the folder `scheduler` beside the UNet's, and the second latent's scale from `vae`; without them they are
    taken to be Stable Diffusion's."""
    library = need("diffusers")
    unet = loaded(model, lambda: library.UNet2DConditionModel.from_pretrained(model))
    folder, grows, scale = Path(model).parent, schedule.STABLE_DIFFUSION, SCALE
    if (folder / "scheduler").is_dir():
        grows = schedule.of_config(loaded(str(folder), lambda: library.DDPMScheduler.load_config(str(folder / "scheduler"))))
    if (folder / "vae").is_dir():
        scale = loaded(str(folder), lambda: library.AutoencoderKL.load_config(str(folder / "vae"))).get("scaling_factor", SCALE)
    return denoiser_of(unet, grows, scale=scale)


def pose(model: str, _checkpoint=None) -> export.PoseEncoder:
    """Of a folder with Zero-1-to-3's `image_encoder` (a CLIP) and `clip_camera_projection` or `cc_projection` (one linear layer)."""
    library = need("transformers")
    encoder = loaded(model, lambda: library.CLIPVisionModelWithProjection.from_pretrained(f"{model}/image_encoder"))
    return pose_of(encoder, loaded(f"the projection of {model}", lambda: _projection(Path(model))))


def latent_of(vae: torch.nn.Module, pixels: int = PIXELS) -> export.LatentEncoder:
    """An autoencoder that is there already, for squares of `pixels`."""
    network = _Latent(vae).eval()
    with torch.no_grad():
        shape = network(torch.zeros(1, 3, pixels, pixels)).shape
    return export.LatentEncoder(network, (pixels, pixels), tuple(int(d) for d in shape[1:]))


def denoiser_of(
    unet: torch.nn.Module, grows=schedule.STABLE_DIFFUSION, tokens: int = 77, scale: float = SCALE
) -> export.Denoiser:
    """A UNet2DConditionModel that is there already. `scale` is the latents', where it takes a second one.

    Raises SourceError where it takes something else beside a latent."""
    config = unet.config
    size = config.sample_size
    shape = (config.out_channels, *((size, size) if isinstance(size, int) else size))
    more = config.in_channels - config.out_channels
    if more == 0:
        return export.Denoiser(_Denoiser(unet), shape, (tokens, config.cross_attention_dim), grows)
    if more != config.out_channels:
        raise SourceError(
            f"The UNet takes {more} channels beside a latent's {config.out_channels}: it is for painting over, not for guidance."
        )
    # Nothing is no picture and no pose at once.
    context = (1, config.cross_attention_dim)
    return export.Denoiser(_Beside(unet, scale), shape, context, grows, np.zeros(context), shape)


def pose_of(encoder: torch.nn.Module, projection: torch.nn.Linear) -> export.PoseEncoder:
    """A CLIPVisionModelWithProjection and a layer from its embedding and four numbers of a pose."""
    return export.PoseEncoder(_Pose(encoder, projection), encoder.config.image_size, (1, projection.out_features))


def _projection(folder: Path) -> torch.nn.Linear:
    from safetensors.torch import load_file

    found = next(f for name in PROJECTIONS if (f := folder / name).is_dir())
    files = sorted(found.glob("*.safetensors")) or sorted(found.glob("*.bin"))
    read = load_file if files[0].suffix == ".safetensors" else lambda file: torch.load(file, weights_only=True)
    tensors = read(files[0])
    (weight,) = [t for t in tensors.values() if t.dim() == 2]
    (bias,) = [t for t in tensors.values() if t.dim() == 1]
    layer = torch.nn.Linear(weight.shape[1], weight.shape[0])
    layer.load_state_dict({"weight": weight, "bias": bias})
    return layer


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


class _Beside(torch.nn.Module):
    """The second latent comes with its scale, as vjp-v1 gives it, and Zero-1-to-3 was trained without."""

    def __init__(self, unet, scale: float):
        super().__init__()
        self.unet, self.scale = unet, scale

    def forward(self, x_t, t, context, beside):
        return self.unet(torch.cat([x_t, beside / self.scale], 1), t, encoder_hidden_states=context).sample


class _Pose(torch.nn.Module):
    def __init__(self, encoder, projection):
        super().__init__()
        self.encoder, self.projection = encoder, projection
        self.register_buffer("mean", torch.tensor(MEAN).view(1, 3, 1, 1))
        self.register_buffer("std", torch.tensor(STD).view(1, 3, 1, 1))

    def forward(self, image, pose):
        seen = self.encoder(pixel_values=(image - self.mean) / self.std).image_embeds
        both = torch.cat([seen.expand(pose.shape[0], -1), pose], 1)
        return self.projection(both)[:, None]
