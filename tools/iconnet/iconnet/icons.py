"""Icons with names and tags, read from packages.

Pictures come from iconify's JSON, which has one form for all sets; tags come from the sets' own packages. Variants of an icon
(filled, thin, outline ...) share one name, and an icon that is only another one with a badge on it is left out.
"""

import json
import re
from dataclasses import dataclass
from pathlib import Path

from . import packages

# What each set writes behind a name for a style; sets with none are not listed.
STYLES = {
    "bi": "fill",
    "carbon": "filled|alt",
    "fluent": "24-filled|24-regular",
    "healthicons": "outline",
    "heroicons": "solid",
    "icon-park-outline": "one|two|three|four",
    "iconoir": "solid",
    "ion": "outline",
    "majesticons": "line",
    "material-symbols-light": "outline",
    "mdi": "outline|variant",
    "mingcute": "line|fill",
    "ph": "thin|light|bold|fill",
    "tabler": "filled",
    "tdesign": "filled",
    "uil": "alt",
}
# Variants that only repeat another one's picture.
REPEATED = re.compile(r"-(?:duotone|negative|sharp|rounded|11|24px|mini|micro|color|twotone)(?:-|$)|-(?:16|20)-solid$|-outline-(?:rounded|sharp)$")
# A badge on another icon (two sets keep theirs, as in the first trial), or a brand's mark.
BADGED = ("lucide", "ph")
BADGE = re.compile(
    r"-(?:off|plus|minus|x|check|cancel|pause|code|dollar|pin|up|down|question|exclamation|cog|share|star|heart|search|bolt"
    r"|add|remove|edit|delete|slash|lock|lock-open|alert|settings|sync|dismiss|checkmark|prohibited|refresh)$"
)
BRAND = re.compile(r"^(?:brand|logo|flag|badge)-|-logo\b|^(?:letter|number|clock-time|hexagon-letter|square-rounded-)")
SYSTEM = re.compile(r"^(?:ios|md|custom|wps|ibm|ui)-")
SIZED = re.compile(r"-(?:10|12|16|20|28|32|48)-(?:filled|regular|light)$|-(?:ltr|rtl)-24-")
OPENMOJI_GROUPS = ("animals-nature", "food-drink", "objects", "travel-places", "activities")


@dataclass(frozen=True)
class Icon:
    """One picture. `name` is words with spaces; `tags` are other words for it; `source` names the set."""

    source: str
    variant: str
    name: str
    tags: tuple[str, ...]
    svg: str


def words(text: str) -> str:
    """`Tree-Palm_2` becomes `tree palm`: lower case, spaces, no number at the end."""
    plain = re.sub(r"[^a-z0-9]+", " ", text.lower()).strip()
    return re.sub(r"(?: \d+)+$", "", plain)


def base(source: str, variant: str) -> str:
    """An icon's name without its style: `cat-fill` of `bi` is `cat`."""
    return re.sub(rf"-(?:{STYLES[source]})$", "", variant) if source in STYLES else variant


def read(folder: Path) -> list[Icon]:
    """All icons of all pinned packages, fetched into `folder` where need be; in the manifest's order, and so always the same."""
    found = {name: packages.fetch(package, folder) for name, package in packages.listed().items()}
    tags = _tags(found)
    icons = []
    for name, package in packages.listed().items():
        if package.holds != "pictures":
            continue
        icons += _openmoji(found[name]) if name == "openmoji" else _iconify(found[name], tags)
    return icons


def _iconify(folder: Path, tags: dict[str, set[str]]) -> list[Icon]:
    given = json.loads((folder / "icons.json").read_text(encoding="utf-8"))
    source, icons = given["prefix"], []
    for variant, icon in given["icons"].items():
        name = SYSTEM.sub("", variant)
        if icon.get("hidden") or REPEATED.search(name) or BRAND.search(name) or (source == "fluent" and SIZED.search(name)):
            continue
        if source == "fluent-emoji-high-contrast" and ("clock" in name or "button" in name or "skin-tone" in name):
            continue
        name = base(source, name)
        if (BADGE.search(name) and source not in BADGED) or len(words(name)) < 2:
            continue
        left, top = icon.get("left", 0), icon.get("top", 0)
        width = icon.get("width", given.get("width", 16))
        height = icon.get("height", given.get("height", 16))
        box = f"{left} {top} {width} {height}"
        svg = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{box}">{icon["body"]}</svg>'
        name = words(name)
        icons.append(Icon(source, variant, name, tuple(sorted(tags.get(name, set()) - {name})), svg))
    return icons


def _openmoji(folder: Path) -> list[Icon]:
    icons = []
    for entry in json.loads((folder / "data" / "openmoji.json").read_text(encoding="utf-8")):
        file = folder / "black" / "svg" / f"{entry['hexcode']}.svg"
        if entry["group"] in OPENMOJI_GROUPS and not entry["skintone"] and file.exists():
            tags = tuple(sorted({words(t) for t in str(entry["tags"]).split(",")} - {""}))
            icons.append(Icon("openmoji", entry["hexcode"], words(entry["annotation"]), tags, file.read_text(encoding="utf-8")))
    return icons


def _tags(found: dict[str, Path]) -> dict[str, set[str]]:
    """For each name the tags that any set gives it."""
    tags: dict[str, set[str]] = {}

    def add(name: str, given) -> None:
        clean = {words(str(tag)) for tag in given} - {""}
        tags.setdefault(words(name), set()).update(tag for tag in clean if len(tag) > 1)

    read_json = lambda name, *path: json.loads(found[name].joinpath(*path).read_text(encoding="utf-8"))
    for name, given in read_json("lucide-static", "tags.json").items():
        add(name, given)
    for name, entry in read_json("@tabler/icons", "icons.json").items():
        add(name, entry["tags"])
    types = (found["@phosphor-icons/core"] / "dist" / "icons.d.ts").read_text(encoding="utf-8")
    for match in re.finditer(r'name: "([^"]+)";.*?tags: readonly \[(.*?)\];', types, re.S):
        add(match[1], [tag for tag in re.findall(r'"([^"]+)"', match[2]) if not tag.startswith("*")])
    for entry in read_json("@mdi/svg", "meta.json"):
        add(entry["name"], entry["aliases"])
    for entry in read_json("emojibase-data", "en", "data.json"):
        add(entry["label"], entry.get("tags", []))
    return tags
