"""The JSON beside an ONNX file: all that a program must know before it opens the file."""

import hashlib
import json
from pathlib import Path

from .errors import ContractError


def path_of(file: Path) -> Path:
    """`x.onnx` has its sidecar in `x.json`."""
    return file.with_suffix(".json")


def sha256(file: Path) -> str:
    """Lower-case hexadecimal."""
    with file.open("rb") as stream:
        return hashlib.file_digest(stream, "sha256").hexdigest()


def write(sidecar: dict, file: Path) -> None:
    """Numbers must be finite: JSON has no others. Lists of plain numbers stay on one line."""
    file.write_text(_lines(sidecar) + "\n", encoding="utf-8")


def read(file: Path) -> dict:
    """Raises ContractError if there is none, or if it is no JSON object."""
    try:
        sidecar = json.loads(file.read_text(encoding="utf-8"))
    except FileNotFoundError:
        raise ContractError(file.name, ["The sidecar is missing. Keep the .json that was exported beside the .onnx."]) from None
    except (UnicodeDecodeError, json.JSONDecodeError) as error:
        raise ContractError(file.name, [f"The sidecar is not JSON: {error}."]) from None
    if not isinstance(sidecar, dict):
        raise ContractError(file.name, ["The sidecar must be a JSON object."])
    return sidecar


def _lines(value, indent: int = 0) -> str:
    inner = " " * (indent + 1)
    if isinstance(value, dict) and value:
        rows = [f"{inner}{json.dumps(k, ensure_ascii=False)}: {_lines(v, indent + 1)}" for k, v in value.items()]
        return "{\n" + ",\n".join(rows) + "\n" + " " * indent + "}"
    if isinstance(value, list) and any(isinstance(v, dict) for v in value):
        return "[\n" + ",\n".join(inner + _lines(v, indent + 1) for v in value) + "\n" + " " * indent + "]"
    return json.dumps(value, ensure_ascii=False, allow_nan=False)
