"""What can go wrong for a person who exports or checks a file.

Each message names the input at fault and says what to do; the command line prints it without a trace.
"""


class GuidanceError(Exception):
    """Anything below; catch this one to report and go on."""


class SourceError(GuidanceError):
    """A network cannot be had: a package is missing, a name is unknown, weights do not fit."""


class ModelError(GuidanceError):
    """A network was had, but it cannot be exported, or the exported graph computes something else."""


class ContractError(GuidanceError):
    """A file does not keep its contract: names, shapes, types, checksum or self-test.

    `faults` holds one sentence for each thing that is wrong.
    """

    def __init__(self, file: str, faults: list[str]):
        self.file = file
        self.faults = list(faults)
        super().__init__(f"{file}: " + " ".join(self.faults))
