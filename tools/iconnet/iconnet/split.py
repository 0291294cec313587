"""Which icon is for what, by hashes of names: the same on every machine, and independent of the order of data."""

import hashlib

HELD_OUT = 12  # percent of names that nobody trains on
JUDGE = 40  # percent of the other icons that only the judge sees
# The sets that figures are given for: those of the first trial, so that figures can be compared.
CLASSIC = {"lucide": "", "tabler": "", "ph": "-light", "fluent-emoji-high-contrast": ""}


def _percent(text: str) -> int:
    return int(hashlib.md5(text.encode()).hexdigest(), 16) % 100


def held_out(name: str) -> bool:
    """True for names whose pictures nobody trains on, and which no picture is trained on as a tag."""
    return _percent(name) < HELD_OUT


def reader(source: str, name: str) -> str:
    """`guide` or `judge`: who trains on the icons called `name` in set `source`. All variants go the same way."""
    return "judge" if _percent(f"{source}/{name}") < JUDGE else "guide"


def classic(source: str, variant: str) -> bool:
    """True for the one variant of an icon that figures are measured on."""
    style = CLASSIC.get(source)
    return style is not None and variant.endswith(style) and not (style == "" and variant.endswith("-filled"))
