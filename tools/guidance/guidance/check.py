"""Does a file keep its contract? Needs onnxruntime only, not torch."""

from pathlib import Path

from . import contracts, schedule, selftest, sidecar
from .errors import ContractError
from .runtime import Session


def check(file: Path) -> dict:
    """Opens `file` and its sidecar, compares checksum, names, types and shapes, and runs the self-test.

    Returns the sidecar. Raises ContractError with a sentence for each thing that is wrong; later steps are left out where
    earlier ones make them senseless.
    """
    if not file.is_file():
        raise ContractError(file.name, ["There is no such file."])
    facts = sidecar.read(sidecar.path_of(file))
    contract = contracts.of_sidecar(facts, sidecar.path_of(file).name)
    found = sidecar.sha256(file)
    if found != facts.get("sha256"):
        said = f"Its sha256 is {found} and the sidecar's {facts.get('sha256')}"
        raise ContractError(file.name, [f"{said}: it is damaged, or belongs to another sidecar. Fetch both again."])
    session = Session(file)
    faults = contract.faults(session.inputs, session.outputs)
    if facts.get("io") != contract.as_json():
        faults.append("The sidecar's 'io' does not say what its kind and sizes mean.")
    for entry in facts.get("embeddings", []):
        if len(entry["vector"]) != facts["embed"]:
            said = f"{entry['prompt']!r} has {len(entry['vector'])} numbers and the file's have {facts['embed']}"
            faults.append(f"The embedding of {said}: it is another model's.")
    if facts["kind"] == "eps-v1" and "schedule" in facts:
        faults += schedule.faults(facts["schedule"])
    if facts["kind"] == "eps-v1" and "nothing" in facts:
        faults += contracts.nothing_faults(facts)
    if faults:
        raise ContractError(file.name, faults)
    try:
        if not facts["selftest"]["cases"]:
            raise ValueError("it has no case")
        faults = selftest.faults(facts["selftest"], contract, session.run)
    except KeyError as error:
        faults = [f"The sidecar's self-test lacks {error}. Export the file again."]
    except (TypeError, ValueError) as error:
        faults = [f"The sidecar's self-test cannot be run: {error}. Export the file again."]
    if faults:
        raise ContractError(file.name, faults)
    return facts
