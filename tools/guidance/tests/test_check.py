"""Files that do not keep their contracts, and what is said of them."""

import json
import shutil

import numpy as np
import onnx
import pytest
from onnx import helper, numpy_helper

from guidance import sidecar
from guidance.check import check
from guidance.errors import ContractError
from tests.conftest import FIXTURE


@pytest.fixture
def file(tmp_path):
    """A copy of the fixture, to be spoilt."""
    for name in ("vit-tiny.onnx", "vit-tiny.json"):
        shutil.copy(FIXTURE / name, tmp_path)
    return tmp_path / "vit-tiny.onnx"


def change_graph(file, change):
    """Changes the graph, and the sidecar's checksum with it."""
    program = onnx.load(file)
    change(program.graph)
    onnx.save(program, file)
    change_facts(file, lambda facts: facts.update(sha256=sidecar.sha256(file)))


def change_facts(file, change):
    facts = json.loads(sidecar.path_of(file).read_text())
    change(facts)
    sidecar.path_of(file).write_text(json.dumps(facts))


def faults(file) -> str:
    with pytest.raises(ContractError) as error:
        check(file)
    assert str(error.value).startswith(error.value.file)
    return str(error.value)


def test_the_fixture_is_fine(file):
    facts = check(file)
    assert (facts["kind"], facts["size"], facts["embed"]) == ("guidance-v1", 32, 16)


def test_missing_file_and_sidecar(file):
    sidecar.path_of(file).unlink()
    assert "sidecar is missing" in faults(file)
    file.unlink()
    assert "no such file" in faults(file)


@pytest.mark.parametrize("text, said", (("{", "not JSON"), ("[]", "JSON object"), ('{"kind": "guidance-v9"}', "guidance-v9")))
def test_a_sidecar_that_is_none(file, text, said):
    sidecar.path_of(file).write_text(text)
    assert said in faults(file)


@pytest.mark.parametrize("size", (None, "32", 0, 32.5, [32, 32], True))
def test_a_size_that_is_none(file, size):
    change_facts(file, lambda facts: facts.update(size=size))
    assert "'size' must be a positive whole number" in faults(file)


def test_a_damaged_file(file):
    content = bytearray(file.read_bytes())
    content[len(content) // 2] ^= 1
    file.write_bytes(content)
    assert "sha256" in faults(file)


def test_a_file_that_is_no_graph(file):
    file.write_bytes(b"hello")
    change_facts(file, lambda facts: facts.update(sha256=sidecar.sha256(file)))
    assert "onnxruntime cannot open it" in faults(file)


def test_a_missing_output(file):
    def change(graph):
        kept = [port for port in graph.output if port.name != "cos"]
        del graph.output[:]
        graph.output.extend(kept)

    change_graph(file, change)
    assert "The output cos[batch] float32 is missing." in faults(file)


def test_an_output_too_many(file):
    def change(graph):
        graph.node.append(helper.make_node("Neg", ["loss"], ["gain"]))
        graph.output.append(helper.make_tensor_value_info("gain", onnx.TensorProto.FLOAT, ()))

    change_graph(file, change)
    assert "The output gain[] float32 is not in the contract." in faults(file)


def test_a_wrong_shape(file):
    change_facts(file, lambda facts: facts.update(embed=17))
    said = faults(file)
    assert "The input is source[batch, 16] float32 and must be source[batch, 17] float32." in said
    assert "The output is embedding[batch, 16] float32" in said


def test_a_fixed_batch(file):
    def change(graph):
        for port in graph.input:
            port.type.tensor_type.shape.dim[0].dim_value = 2

    change_graph(file, change)
    assert "image[2, 3, 32, 32] float32 and must be image[batch, 3, 32, 32]" in faults(file)


def spoil_weights(value):
    def change(graph):
        tensor = max(graph.initializer, key=lambda t: len(t.raw_data))
        values = numpy_helper.to_array(tensor) * np.float32(value)
        tensor.CopyFrom(numpy_helper.from_array(values.astype(np.float32), tensor.name))

    return change


def test_answers_that_are_not_finite(file):
    change_graph(file, spoil_weights(np.nan))
    assert "Self-test 'plain', output 'loss': the answer has numbers that are not finite." in faults(file)


def test_other_weights(file):
    change_graph(file, spoil_weights(1.5))
    assert "Self-test 'directional', output 'grad'" in faults(file)


@pytest.mark.parametrize("output", ("loss", "grad", "cos", "embedding"))
def test_expectations_of_another_file(file, output):
    def change(facts):
        kept = facts["selftest"]["cases"][0]["outputs"][output]
        for key, value in kept.items():
            kept[key] = value * 1.1 if isinstance(value, float) else [v * 1.1 + 0.01 for v in value]

    change_facts(file, change)
    assert f"Self-test 'plain', output '{output}'" in faults(file)


def test_expectations_that_are_not_numbers(file):
    change_facts(file, lambda facts: facts["selftest"]["cases"][0]["outputs"].update(loss={"values": [float("nan")]}))
    assert "not finite" in faults(file)


@pytest.mark.parametrize("key", ("cases", "batch", "tolerance"))
def test_a_self_test_with_holes(file, key):
    change_facts(file, lambda facts: facts["selftest"].pop(key))
    assert key in faults(file)


def test_no_self_test(file):
    change_facts(file, lambda facts: facts.pop("selftest"))
    assert "selftest" in faults(file)


def test_an_empty_self_test(file):
    change_facts(file, lambda facts: facts["selftest"].update(cases=[]))
    assert "no case" in faults(file)


def test_an_unknown_fill(file):
    change_facts(file, lambda facts: facts["selftest"]["cases"][0]["inputs"].update(image={"fill": "photograph"}))
    assert "photograph" in faults(file)


def test_embeddings_of_another_model(file):
    change_facts(file, lambda facts: facts.update(embeddings=[{"prompt": "a cat", "vector": [1.0] * 4}]))
    assert "'a cat' has 4 numbers" in faults(file)
