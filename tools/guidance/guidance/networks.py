"""Tiny networks of the true kinds, with random weights: for tests, and for the fixture that other languages read."""

import torch
from torch import nn
from torch.nn import functional as F


class QuickGelu(nn.Module):
    """What OpenAI's CLIP uses."""

    def forward(self, x):
        return x * torch.sigmoid(1.702 * x)


class Block(nn.Module):
    """A transformer's pre-normalised block; `causal` hides later tokens, as in a text encoder."""

    def __init__(self, width: int, heads: int, causal: bool = False):
        super().__init__()
        self.heads, self.causal = heads, causal
        self.before, self.qkv, self.out = nn.LayerNorm(width), nn.Linear(width, 3 * width), nn.Linear(width, width)
        self.mlp = nn.Sequential(
            nn.LayerNorm(width), nn.Linear(width, 4 * width), QuickGelu(), nn.Linear(4 * width, width)
        )

    def forward(self, x):
        n, tokens, width = x.shape
        q, k, v = (
            part.reshape(n, tokens, self.heads, width // self.heads).transpose(1, 2)
            for part in self.qkv(self.before(x)).chunk(3, -1)
        )
        seen = F.scaled_dot_product_attention(q, k, v, is_causal=self.causal)
        x = x + self.out(seen.transpose(1, 2).reshape(n, tokens, width))
        return x + self.mlp(x)


class TinyVit(nn.Module):
    """CLIP's image tower: patches, a class token, blocks, a projection. [n,3,size,size] -> [n,embed]."""

    def __init__(self, size=32, patch=8, width=20, depth=2, heads=2, embed=16):
        super().__init__()
        self.size, self.embed = size, embed
        self.patches = nn.Conv2d(3, width, patch, patch, bias=False)
        self.token = nn.Parameter(torch.randn(width) * width**-0.5)
        self.place = nn.Parameter(torch.randn((size // patch) ** 2 + 1, width) * width**-0.5)
        self.blocks = nn.Sequential(nn.LayerNorm(width), *(Block(width, heads) for _ in range(depth)), nn.LayerNorm(width))
        self.project = nn.Parameter(torch.randn(width, embed) * width**-0.5)

    def forward(self, x):
        x = self.patches(x).flatten(2).transpose(1, 2)
        x = torch.cat([self.token.expand(x.shape[0], 1, -1), x], 1) + self.place
        return self.blocks(x)[:, 0] @ self.project


class TinyConv(nn.Module):
    """A convolutional encoder with everything that has a rule: strides, pools, groups, a resize. [n,3,size,size] -> [n,embed]."""

    def __init__(self, size=32, width=8, embed=16):
        super().__init__()
        self.size, self.embed = size, embed
        self.stem = nn.Sequential(nn.Conv2d(3, width, 3, 2, 1), nn.BatchNorm2d(width), nn.GELU(), nn.MaxPool2d(3, 2, 1))
        self.deep = nn.Sequential(
            nn.Conv2d(width, 2 * width, 3, padding=1, groups=width), nn.SiLU(),
            nn.Conv2d(2 * width, 2 * width, 3, 2, 1, groups=4), nn.GroupNorm(4, 2 * width), nn.AvgPool2d(2),
        )  # fmt: skip
        self.last = nn.Linear(2 * width, embed)

    def forward(self, x):
        x = F.interpolate(x, scale_factor=1.25, mode="bilinear", align_corners=False, antialias=True)
        return self.last(self.deep(self.stem(x)).mean((2, 3)))


class TinyText(nn.Module):
    """CLIP's text tower: the place of the highest id (end of text) is read. int64 [n,context] -> [n,embed]."""

    def __init__(self, vocabulary=64, context=12, width=24, depth=2, heads=2, embed=16):
        super().__init__()
        self.context, self.embed, self.vocabulary = context, embed, vocabulary
        self.words = nn.Embedding(vocabulary, width)
        self.place = nn.Parameter(torch.randn(context, width) * 0.1)
        self.blocks = nn.Sequential(*(Block(width, heads, causal=True) for _ in range(depth)), nn.LayerNorm(width))
        self.project = nn.Parameter(torch.randn(width, embed) * width**-0.5)

    def states(self, ids):
        return self.blocks(self.words(ids) + self.place)

    def forward(self, ids):
        x = self.states(ids)
        end = F.one_hot(ids.argmax(-1), self.context).to(x.dtype)
        return (x * end.unsqueeze(-1)).sum(1) @ self.project


class TinyContext(TinyText):
    """Its states, token by token: int64 [n,context] -> [n,context,width]."""

    def forward(self, ids):
        return self.states(ids)


class Residual(nn.Module):
    """GroupNorm, SiLU, convolution, twice, as in Stable Diffusion; `time` numbers are added between where they are given."""

    def __init__(self, given: int, wanted: int, time: int = 0):
        super().__init__()
        self.first = nn.Sequential(nn.GroupNorm(4, given), nn.SiLU(), nn.Conv2d(given, wanted, 3, padding=1))
        self.time = nn.Linear(time, wanted) if time else None
        self.second = nn.Sequential(nn.GroupNorm(4, wanted), nn.SiLU(), nn.Conv2d(wanted, wanted, 3, padding=1))
        self.skip = nn.Conv2d(given, wanted, 1) if given != wanted else nn.Identity()

    def forward(self, x, time=None):
        y = self.first(x)
        if self.time is not None:
            y = y + self.time(time)[:, :, None, None]
        return self.skip(x) + self.second(y)


class TinyVae(nn.Module):
    """The encoder of a latent diffusion model, its mean only. [1,3,H,W] in 0..1 -> [1,4,H/4,W/4]."""

    def __init__(self, width=8):
        super().__init__()
        self.first = nn.Conv2d(3, width, 3, padding=1)
        self.blocks = nn.ModuleList([Residual(width, width), Residual(width, 2 * width)])
        self.down = nn.ModuleList([nn.Conv2d(width, width, 3, 2), nn.Conv2d(2 * width, 2 * width, 3, 2)])
        self.last = nn.Sequential(nn.GroupNorm(4, 2 * width), nn.SiLU(), nn.Conv2d(2 * width, 4, 3, padding=1))

    def forward(self, image):
        x = self.first(2 * image - 1)
        for block, down in zip(self.blocks, self.down):
            x = down(F.pad(block(x), (0, 1, 0, 1)))
        return 0.18215 * self.last(x)


class TinyUnet(nn.Module):
    """A denoiser with one level down and attention to a context. (x [n,C,h,w], t [n], context [n,N,D]) -> [n,C,h,w]."""

    def __init__(self, width=8, context=16, channels=4):
        super().__init__()
        self.first, self.last = nn.Conv2d(channels, width, 3, padding=1), nn.Conv2d(width, channels, 3, padding=1)
        self.before, self.after = Residual(width, width, 8), Residual(2 * width, width, 8)
        self.down, self.up = nn.Conv2d(width, width, 3, 2, 1), nn.Conv2d(width, width, 3, padding=1)
        self.query, self.key, self.value = nn.Linear(width, width), nn.Linear(context, width), nn.Linear(context, width)
        self.register_buffer("rates", torch.exp(torch.arange(4) * -2.0))

    def forward(self, x, t, context):
        phase = t[:, None] * self.rates
        time = torch.cat([phase.sin(), phase.cos()], -1)
        high = self.before(self.first(x), time)
        low = self.down(high)
        n, width, rows, columns = low.shape
        tokens = low.flatten(2).transpose(1, 2)
        seen = F.scaled_dot_product_attention(self.query(tokens), self.key(context), self.value(context))
        low = (tokens + seen).transpose(1, 2).reshape(n, width, rows, columns)
        low = self.up(F.interpolate(low, scale_factor=2.0, mode="nearest"))
        return self.last(self.after(torch.cat([high, low], 1), time))


class TinyBeside(nn.Module):
    """TinyUnet with a second latent beside the first."""

    def __init__(self):
        super().__init__()
        self.unet = TinyUnet(channels=8)

    def forward(self, x_t, t, context, beside):
        return self.unet(torch.cat([x_t, beside], 1), t, context)[:, :4]


class TinyPose(nn.Module):
    """Means of 8 x 8 places of a picture of 32 px, and a pose, as a context of one token of 16 numbers."""

    def __init__(self):
        super().__init__()
        self.layer = nn.Linear(3 * 16 + 4, 16)

    def forward(self, image, pose):
        seen = F.avg_pool2d(image, 8).flatten(1).expand(pose.shape[0], -1)
        return self.layer(torch.cat([seen, pose], 1))[:, None]


class TinySight(nn.Module):
    """What is red is the object, or near."""

    def forward(self, image):
        red = image[:, :1] - image[:, 1:].amax(1, keepdim=True)
        return torch.sigmoid(20 * (red - 0.25))
