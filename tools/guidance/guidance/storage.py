"""How weights are stored: fp32, fp16 or int8.

Only the file shrinks. A Cast (fp16) or a Cast and a Mul (int8, a scale a row) stands behind each weight, a runtime folds them
when it opens the file, and arithmetic stays fp32: speed and memory are fp32's. (DequantizeLinear would say the same, but
onnxruntime keeps it at run time and is slower for it.)
"""

import numpy as np
import onnx
from onnx import TensorProto, helper, numpy_helper

from .errors import ModelError

MODES = ("fp32", "fp16", "int8")
WORTH_IT = 512  # numbers; below, a scale and two nodes would cost more than they save


def store(program: onnx.ModelProto, mode: str) -> onnx.ModelProto:
    """A copy of `program` with its float32 weights stored as `mode` says.

    int8 turns vectors into fp16. Raises ModelError for an unknown mode, and for fp16 where a weight is beyond 65504.
    """
    if mode not in MODES:
        raise ModelError(f"Weights cannot be stored as {mode!r}: choose {', '.join(MODES)}.")
    stored = onnx.ModelProto()
    stored.CopyFrom(program)
    if mode == "fp32":
        return stored
    graph, unpack, tensors = stored.graph, [], []
    for tensor in graph.initializer:
        values = numpy_helper.to_array(tensor) if tensor.data_type == TensorProto.FLOAT else None
        if values is None or values.size < WORTH_IT:
            tensors.append(tensor)
        elif mode == "fp16" or values.ndim < 2 or values.shape[0] == 1:
            _half(tensor.name, values, tensors, unpack)
        else:
            _rows(tensor.name, values, tensors, unpack)
    nodes = [*unpack, *graph.node]
    del graph.node[:], graph.initializer[:]
    graph.node.extend(nodes)
    graph.initializer.extend(tensors)
    return stored


def _half(name, values, tensors, unpack):
    if not np.abs(values).max() <= np.finfo(np.float16).max:
        raise ModelError("A weight is not finite or too large for fp16. Export with fp32 weights.")
    tensors.append(numpy_helper.from_array(values.astype(np.float16), f"{name}_h"))
    unpack.append(helper.make_node("Cast", [f"{name}_h"], [name], to=TensorProto.FLOAT))


def _rows(name, values, tensors, unpack):
    most = np.abs(values).reshape(values.shape[0], -1).max(1)
    if not np.isfinite(most).all():
        raise ModelError("A weight is not finite. The network's weights are damaged, or did not load.")
    scale = np.where(most > 0, most / 127, 1).astype(np.float32).reshape(-1, *[1] * (values.ndim - 1))
    whole = np.clip(np.rint(values / scale), -127, 127).astype(np.int8)
    tensors += [numpy_helper.from_array(whole, f"{name}_q"), numpy_helper.from_array(scale, f"{name}_s")]
    unpack.append(helper.make_node("Cast", [f"{name}_q"], [f"{name}_f"], to=TensorProto.FLOAT))
    unpack.append(helper.make_node("Mul", [f"{name}_f", f"{name}_s"], [name]))
