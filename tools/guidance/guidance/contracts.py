"""The four kinds of files, and what each promises by name, type and shape.

| kind | inputs | outputs |
|---|---|---|
| guidance-v1 | image[batch,3,S,S], source[batch,E], target[batch,E], weight[batch] | loss[], grad like image, cos[batch], embedding[batch,E] |
| text-v1 | ids[batch,context] int32 | embedding[batch,E] |
| vjp-v1 | image[1,3,H,W], cotangent like latent | latent[1,C,h,w], grad like image |
| eps-v1 | x_t[batch,C,h,w], t[batch], context[batch,N,D] | eps like x_t |

Everything but `ids` is float32. Images are sRGB in 0..1, channels first, red first; what a network wants instead (mean,
deviation, -1..1) is folded into the graph, gradients included.
"""

from dataclasses import dataclass

from .errors import ContractError

BATCH = "batch"
KINDS = ("guidance-v1", "text-v1", "vjp-v1", "eps-v1")
Shape = tuple[int | str, ...]


@dataclass(frozen=True)
class Port:
    """One input or output. A dimension is a size, or `batch`: any number from 1."""

    name: str
    shape: Shape
    dtype: str = "float32"

    def sized(self, batch: int) -> tuple[int, ...]:
        """The shape for one batch size."""
        return tuple(batch if d == BATCH else int(d) for d in self.shape)

    def __str__(self) -> str:
        return f"{self.name}[{', '.join(map(str, self.shape))}] {self.dtype}"


@dataclass(frozen=True)
class Contract:
    """What a file of one kind takes and gives, with its sizes filled in."""

    kind: str
    inputs: tuple[Port, ...]
    outputs: tuple[Port, ...]

    @property
    def dynamic(self) -> bool:
        return any(BATCH in port.shape for port in self.inputs)

    def as_json(self) -> dict:
        """For a sidecar's `io`."""
        side = lambda ports: {p.name: {"dtype": p.dtype, "shape": list(p.shape)} for p in ports}
        return {"inputs": side(self.inputs), "outputs": side(self.outputs)}

    def faults(self, inputs: list[Port], outputs: list[Port]) -> list[str]:
        """A sentence for each port that a file lacks, has too many of, or has otherwise."""
        return _faults("input", self.inputs, inputs) + _faults("output", self.outputs, outputs)


def guidance(size: int, embed: int) -> Contract:
    """Loss and gradient of an image encoder; `size` in pixels, `embed` numbers an embedding."""
    image, rows = (BATCH, 3, size, size), (BATCH, embed)
    return Contract(
        "guidance-v1",
        (Port("image", image), Port("source", rows), Port("target", rows), Port("weight", (BATCH,))),
        (Port("loss", ()), Port("grad", image), Port("cos", (BATCH,)), Port("embedding", rows)),
    )


def text(context: int, embed: int) -> Contract:
    """A text encoder; `context` tokens a prompt, padded."""
    return Contract(
        "text-v1", (Port("ids", (BATCH, context), "int32"),), (Port("embedding", (BATCH, embed)),)
    )


def vjp(image: tuple[int, int], latent: tuple[int, int, int]) -> Contract:
    """An image encoder pulled back; `image` is (height, width) in pixels, `latent` (channels, height, width)."""
    pixels, code = (1, 3, *image), (1, *latent)
    return Contract(
        "vjp-v1", (Port("image", pixels), Port("cotangent", code)), (Port("latent", code), Port("grad", pixels))
    )


def eps(latent: tuple[int, int, int], context: tuple[int, int]) -> Contract:
    """A denoiser, forward; `context` is (tokens, numbers a token)."""
    code = (BATCH, *latent)
    return Contract(
        "eps-v1",
        (Port("x_t", code), Port("t", (BATCH,)), Port("context", (BATCH, *context))),
        (Port("eps", code),),
    )


def of_sidecar(sidecar: dict, file: str) -> Contract:
    """The contract that a sidecar's kind and sizes ask for.

    Raises ContractError where the kind is unknown or a size is missing or no positive whole number.
    """
    kind = sidecar.get("kind")
    if kind not in KINDS:
        raise ContractError(file, [f"The kind {kind!r} is unknown: this version reads {', '.join(KINDS)}."])

    def sizes(name: str, count: int) -> list[int]:
        given = sidecar.get(name)
        given = given if isinstance(given, list) else [given]
        if len(given) != count or any(type(g) is not int or g < 1 for g in given):
            what = "a positive whole number" if count == 1 else f"{count} positive whole numbers"
            raise ContractError(file, [f"'{name}' must be {what} in a {kind} sidecar, and it is {sidecar.get(name)!r}."])
        return given

    if kind == "guidance-v1":
        return guidance(*sizes("size", 1), *sizes("embed", 1))
    if kind == "text-v1":
        return text(*sizes("context", 1), *sizes("embed", 1))
    if kind == "vjp-v1":
        return vjp(tuple(sizes("image", 2)), tuple(sizes("latent", 3)))
    return eps(tuple(sizes("latent", 3)), tuple(sizes("context", 2)))


def nothing_faults(sidecar: dict) -> list[str]:
    """A sentence where an eps-v1 sidecar's `nothing` is no context: tokens times numbers a token, one after another."""
    given, (tokens, numbers) = sidecar["nothing"], sidecar["context"]
    fine = isinstance(given, list) and all(type(g) in (int, float) and abs(g) < float("inf") for g in given)
    if fine and len(given) == tokens * numbers:
        return []
    return [f"'nothing' must be {tokens * numbers} finite numbers, a context of {tokens} tokens of {numbers}."]


def _faults(side: str, wanted: tuple[Port, ...], given: list[Port]) -> list[str]:
    have = {port.name: port for port in given}
    said = []
    for port in wanted:
        found = have.pop(port.name, None)
        if found is None:
            said.append(f"The {side} {port} is missing.")
        elif found.dtype != port.dtype or not _same(port.shape, found.shape):
            said.append(f"The {side} is {found} and must be {port}.")
    said += [f"The {side} {port} is not in the contract." for port in have.values()]
    return said


def _same(wanted: Shape, given: Shape) -> bool:
    """Sizes must be equal; where a batch is wanted, any symbol will do, but no fixed size."""
    if len(wanted) != len(given):
        return False
    return all(not isinstance(g, int) if w == BATCH else w == g for w, g in zip(wanted, given))
