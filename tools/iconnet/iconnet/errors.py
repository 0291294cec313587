"""What can go wrong for a person who trains, exports or guides.

Each message names the input at fault and says what to do; the command line prints it without a trace.
"""


class IconnetError(Exception):
    """Anything below; catch this one to report and go on."""


class DataError(IconnetError):
    """A package cannot be had, is not the pinned one, or holds something else than expected."""


class MissingStep(IconnetError):
    """An earlier command has to run first."""


class WordError(IconnetError):
    """A word is not in the word table."""
