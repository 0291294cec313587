"""A plain function of tensors becomes a plain ONNX graph: opset 18, standard operators only, one file.

`make_fx` runs the function, autograd included, and writes down what happened; the rules of `adjoints` rewrite what ONNX
lacks. Exporting a module that calls autograd by itself does not work: torch.export cannot look inside.
"""

import contextlib
import logging
import warnings
from collections.abc import Callable

import onnx
import torch
from torch.fx.experimental.proxy_tensor import make_fx

from . import adjoints
from .contracts import BATCH, Contract
from .errors import ModelError

OPSET = 18
MARK = "port_"
MOST_BYTES = 2**31 - 2**24  # protobuf's limit for one file, less what is not weights


def build(function: Callable, contract: Contract) -> onnx.ModelProto:
    """The graph of `function`, with the contract's names and shapes.

    Raises ModelError, naming the operator where possible, if the network cannot be written as such a graph.
    """
    example = tuple(_example(contract))
    try:
        with _exportable_attention(), _quiet():
            program = _program(function, example, contract)
    except ModelError:
        raise
    except Exception as error:  # torch raises whatever it likes here
        said = " ".join(str(error).split())[:400]
        raise ModelError(
            f"The network cannot be written as a {contract.kind} graph: {type(error).__name__}: {said}. "
            "If an operator is named, replace it in the network or add a rule to adjoints.py."
        ) from error
    _strip(program)
    return program


def packed(program: onnx.ModelProto) -> bytes:
    """The file's content, always the same for the same graph.

    Raises ModelError if one file cannot hold it, or if it is no valid ONNX.
    """
    if sum(len(tensor.raw_data) for tensor in program.graph.initializer) > MOST_BYTES:
        raise ModelError("The graph is over 2 GiB and one file cannot hold it. Store its weights as fp16 or int8.")
    try:
        onnx.checker.check_model(program)
    except onnx.checker.ValidationError as error:
        raise ModelError(f"The exported graph is not valid: {' '.join(str(error).split())[:300]}") from error
    return program.SerializeToString(deterministic=True)


def _program(function, example, contract) -> onnx.ModelProto:
    # Marked, since inner values may bear the same names: torch calls the result of aten.embedding `embedding`.
    names = dict(input_names=[MARK + p.name for p in contract.inputs], output_names=[MARK + p.name for p in contract.outputs])
    # Weights are real tensors, and so are the matrices that rules make.
    tracing = dict(tracing_mode="symbolic", _allow_non_fake_inputs=True) if contract.dynamic else dict(tracing_mode="real")
    traced = make_fx(function, decomposition_table=adjoints.table(), **tracing)(*example)
    traced.graph.eliminate_dead_code()
    traced.recompile()
    traced.eval()
    if contract.dynamic:
        batch = torch.export.Dim(BATCH, min=2, max=1024)
        traced = torch.export.export(
            traced, example, dynamic_shapes=tuple({0: batch} if BATCH in port.shape else {} for port in contract.inputs)
        )
        exported = torch.onnx.export(traced, dynamo=True, opset_version=OPSET, verbose=False, **names)
    else:
        exported = torch.onnx.export(traced, example, dynamo=True, opset_version=OPSET, verbose=False, **names)
    return exported.model_proto


def _example(contract: Contract):
    """Inputs to trace with. Equal sizes are taken for the same symbol, so the batch must equal no other size."""
    others = {d for port in contract.inputs for d in port.shape}
    batch = next(n for n in (7, 11, 13, 17, 19, 23, 29) if n not in others)
    generator = torch.Generator().manual_seed(0)
    for port in contract.inputs:
        shape = port.sized(batch)
        yield torch.ones(shape, dtype=torch.int32) if port.dtype == "int32" else torch.rand(shape, generator=generator)


@contextlib.contextmanager
def _exportable_attention():
    """Fused attention has no backward that could be written down; the plain one has."""
    from torch.nn.attention import SDPBackend, sdpa_kernel

    before = torch.backends.mha.get_fastpath_enabled()
    torch.backends.mha.set_fastpath_enabled(False)
    try:
        with sdpa_kernel(SDPBackend.MATH):
            yield
    finally:
        torch.backends.mha.set_fastpath_enabled(before)


@contextlib.contextmanager
def _quiet():
    logger = logging.getLogger("torch.onnx")
    before = logger.level
    logger.setLevel(logging.ERROR)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            yield
    finally:
        logger.setLevel(before)


def _strip(program: onnx.ModelProto) -> None:
    """Drops stack traces and shapes of inner values (a fifth of a small file, with paths of this machine in it), shortens
    inner names, and calls the free dimension `batch`."""
    graph = program.graph
    ports = [*graph.input, *graph.output]
    for item in [*graph.node, *graph.initializer, *ports]:
        item.ClearField("metadata_props")
        item.ClearField("doc_string")
    for item in (program, graph):
        item.ClearField("metadata_props")
        item.ClearField("doc_string")
    del graph.value_info[:]
    for port in ports:
        for dimension in port.type.tensor_type.shape.dim:
            if dimension.dim_param:
                dimension.dim_param = BATCH
    _rename(graph)
    for port in ports:
        port.name = port.name.removeprefix(MARK)
    graph.name = "main"
    program.producer_name, program.producer_version = "wire4d-guidance", ""


def _rename(graph: onnx.GraphProto) -> None:
    ports = {port.name for port in [*graph.input, *graph.output]}
    short: dict[str, str] = {}

    def name(old: str) -> str:
        if not old:
            return old
        if old in ports:
            return old.removeprefix(MARK)
        return short.setdefault(old, f"v{len(short)}")

    for tensor in graph.initializer:
        tensor.name = name(tensor.name)
    for number, node in enumerate(graph.node):
        if any(a.type in (onnx.AttributeProto.GRAPH, onnx.AttributeProto.GRAPHS) for a in node.attribute):
            raise ModelError(f"The network branches on its data ({node.op_type}), and a gradient graph cannot.")
        node.name = f"n{number}"
        node.input[:] = [name(i) for i in node.input]
        node.output[:] = [name(o) for o in node.output]
