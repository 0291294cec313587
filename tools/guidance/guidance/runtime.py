"""onnxruntime, as far as it is needed: open a file, read its ports, run it."""

from pathlib import Path

import numpy as np
import onnxruntime

from .contracts import BATCH, Port
from .errors import ContractError

TYPES = {"tensor(float)": "float32", "tensor(float16)": "float16", "tensor(int32)": "int32", "tensor(int64)": "int64"}


class Session:
    """A graph on one processor thread, so that its numbers do not depend on the machine's load."""

    def __init__(self, graph: bytes | Path):
        """Raises ContractError if onnxruntime refuses the file."""
        options = onnxruntime.SessionOptions()
        options.intra_op_num_threads = 1
        options.log_severity_level = 3
        source = graph if isinstance(graph, bytes) else str(graph)
        try:
            self._session = onnxruntime.InferenceSession(source, options, providers=["CPUExecutionProvider"])
        except Exception as error:  # onnxruntime's errors have no common class
            name = "graph" if isinstance(graph, bytes) else graph.name
            said = " ".join(str(error).split())[:300]
            raise ContractError(name, [f"onnxruntime cannot open it: {said}"]) from error
        self.inputs = [_port(p) for p in self._session.get_inputs()]
        self.outputs = [_port(p) for p in self._session.get_outputs()]

    def run(self, feeds: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
        """All outputs by name."""
        names = [port.name for port in self.outputs]
        return dict(zip(names, self._session.run(names, feeds)))


def _port(port) -> Port:
    return Port(port.name, tuple(d if isinstance(d, int) else BATCH for d in port.shape), TYPES.get(port.type, port.type))
