"""The command line: `export`, `check`, `prompts`, `contexts`."""

import argparse
import sys
from pathlib import Path

from .errors import GuidanceError, SourceError

PARTS = {
    "image": "guidance-v1",
    "text": "text-v1",
    "context": "context-v1",
    "pose": "pose-v1",
    "latent": "vjp-v1",
    "denoiser": "eps-v1",
}


def main(arguments: list[str] | None = None) -> int:
    """0 if all went well, 1 with a sentence on standard error if not, 2 for a wrong command line."""
    given = _parser().parse_args(arguments)
    try:
        return given.run(given)
    except (GuidanceError, OSError) as error:
        print(error, file=sys.stderr)
        return 1


def _export(given) -> int:
    from . import export, prompts, sources  # torch takes seconds to import, and the other verbs do without

    if given.embeddings and given.part != "image":
        raise SourceError("--embeddings belongs to an image encoder's file: export image.")
    loaded = sources.load(given.part, given.source, given.checkpoint)
    origin = given.source + (f" {Path(given.checkpoint).name}" if given.checkpoint else "")
    label = export.Label(given.name, origin, given.licence)
    write = {
        "image": export.image_encoder,
        "text": export.text_encoder,
        "context": export.context_encoder,
        "pose": export.pose_encoder,
        "latent": export.latent_encoder,
        "denoiser": export.denoiser,
    }[given.part]
    extra = {"embeddings": prompts.read(given.embeddings)} if given.embeddings else {}
    report = write(loaded, label, given.out, given.weights, **extra)
    print(f"{report.file}: {PARTS[given.part]}, {report.bytes:,} bytes, {given.weights} weights")
    for name, cosine in report.cosine.items():
        print(f"  {name}: {report.error[name]:.1e} off torch" + (f", cosine {cosine:.6f}" if name == "grad" else ""))
    return 0


def _check(given) -> int:
    from . import check

    wrong = 0
    for file in given.files:
        try:
            facts = check.check(file)
            about = (facts["kind"], facts.get("name"), f"{facts.get('weights')} weights", f"licence: {facts.get('licence')}")
            print(f"{file}: fine. {', '.join(map(str, about))}")
        except GuidanceError as error:
            wrong += 1
            print(error, file=sys.stderr)
    return 1 if wrong else 0


def _prompts(given) -> int:
    from . import prompts, sidecar

    templates = prompts.PLAIN
    if given.templates:
        lines = given.templates.read_text(encoding="utf-8").splitlines()
        templates = tuple(line.strip() for line in lines if line.strip()) or prompts.PLAIN
    found = prompts.embed(given.file, given.prompts, templates)
    sidecar.write(found, given.out)
    print(f"{given.out}: {len(found['embeddings'])} embeddings of {found['embed']} numbers")
    return 0


def _contexts(given) -> int:
    from . import contexts, sidecar

    found = contexts.encode(given.file, given.prompts)
    sidecar.write(found, given.out)
    print(f"{given.out}: {len(found['contexts'])} contexts of {' x '.join(map(str, found['shape']))} numbers")
    return 0


def _name(text: str) -> str:
    if not text or not all(c.isalnum() or c in "-_" for c in text) or not text.isascii():
        raise argparse.ArgumentTypeError(f"{text!r} must be letters, digits, - and _: it names files")
    return text


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="python -m guidance", description="Frozen networks as ONNX files that give gradients."
    )
    verbs = parser.add_subparsers(required=True, metavar="VERB")

    export = verbs.add_parser("export", help="write NAME.onnx and NAME.json")
    export.add_argument("part", choices=PARTS, help="what of the model: " + ", ".join(f"{p} ({k})" for p, k in PARTS.items()))
    export.add_argument("source", help="LIBRARY:MODEL with open_clip, transformers or diffusers; or tiny, tiny:conv")
    export.add_argument("--checkpoint", metavar="FILE", help="weights: a file, or a tag that open_clip knows")
    export.add_argument("--name", type=_name, required=True, help="of the files to write")
    export.add_argument("--licence", required=True, help="of the weights, as it should be shown to people")
    export.add_argument("--weights", choices=("fp32", "fp16", "int8"), default="fp32", help="how to store them")
    export.add_argument("--embeddings", type=Path, metavar="JSON", help="prompts with vectors, for an image encoder's sidecar")
    export.add_argument("--out", type=Path, default=Path("."), metavar="FOLDER")
    export.set_defaults(run=_export)

    check = verbs.add_parser("check", help="open files, compare them with their contracts, run their self-tests")
    check.add_argument("files", nargs="+", type=Path, metavar="FILE.onnx")
    check.set_defaults(run=_check)

    prompts = verbs.add_parser("prompts", help="write embeddings of prompts as JSON")
    prompts.add_argument("file", type=Path, metavar="TEXT.onnx", help="a text-v1 file with its tokenizer beside it")
    prompts.add_argument("prompts", nargs="+", metavar="PROMPT")
    prompts.add_argument(
        "--templates", type=Path, metavar="TXT", help="one a line, each with {} for the prompt; their mean counts"
    )
    prompts.add_argument("--out", type=Path, required=True, metavar="JSON")
    prompts.set_defaults(run=_prompts)

    contexts = verbs.add_parser("contexts", help="write contexts of prompts, and of nothing, as JSON")
    contexts.add_argument("file", type=Path, metavar="TEXT.onnx", help="a context-v1 file with its tokenizer beside it")
    contexts.add_argument("prompts", nargs="+", metavar="PROMPT")
    contexts.add_argument("--out", type=Path, required=True, metavar="JSON")
    contexts.set_defaults(run=_contexts)
    return parser
