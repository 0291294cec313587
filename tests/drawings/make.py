#!/usr/bin/env python3
"""Draws the test drawings again: `make.py NODE_MODULES [FOLDER]`.

Needs `pip install cairosvg pillow fonttools` and, in NODE_MODULES, the npm packages lucide-static, @tabler/icons,
@fontsource/{inter,playfair-display,alfa-slab-one,noto-serif-jp}. Nothing in the project needs this script: the PNGs are
committed.
"""

import io
import math
import re
import sys
from pathlib import Path

import cairosvg
from fontTools.pens.boundsPen import BoundsPen
from fontTools.pens.svgPathPen import SVGPathPen
from fontTools.ttLib import TTFont
from PIL import Image, ImageOps

MODULES = Path(sys.argv[1])
FOLDER = Path(sys.argv[2]) if len(sys.argv) > 2 else Path(__file__).parent


def svg(box, body, stroke, fill="none"):
    """An SVG document of `box` units, everything in it stroked `stroke` units wide and round."""
    w, h = box
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {w} {h}"><g fill="{fill}" stroke="#000" '
        f'stroke-width="{stroke}" stroke-linecap="round" stroke-linejoin="round">{body}</g></svg>'
    )


def path(d, **more):
    extra = " ".join(f'{k.replace("_", "-")}="{v}"' for k, v in more.items())
    return f'<path d="{d}" {extra}/>'


def circle(x, y, r, **more):
    extra = " ".join(f'{k.replace("_", "-")}="{v}"' for k, v in more.items())
    return f'<circle cx="{x}" cy="{y}" r="{r}" {extra}/>'


def curve(f, count=200, closed=False):
    points = [f(i / count) for i in range(count if closed else count + 1)]
    return "M" + " L".join(f"{x:.2f} {y:.2f}" for x, y in points) + (" Z" if closed else "")


SOLID = {"fill": "#000"}
HOLE = {"fill": "#fff", "stroke": "none"}

# ---- hand-made ------------------------------------------------------------------------------------------------------


def cat():
    head = "M30 30 L27 8 L42 19 Q50 16 58 19 L73 8 L70 30 Q75 41 66 49 Q58 56 50 56 Q42 56 34 49 Q25 41 30 30 Z"
    body = "M36 51 Q21 72 23 100 Q23 113 35 113 L65 113 Q77 113 77 100 Q79 72 64 51"
    whiskers = "M40 44 L16 39 M40 47 L17 50 M60 44 L84 39 M60 47 L83 50"
    return (
        path(head) + path(body) + path("M43 82 L43 112 M57 82 L57 112 M76 105 Q97 106 95 84 Q93 70 84 75")
        + circle(41, 34, 3, **SOLID) + circle(59, 34, 3, **SOLID)
        + path("M47 42 L53 42 L50 45 Z M50 45 Q49 50 44 49 M50 45 Q51 50 56 49") + path(whiskers)
    )


def bird():
    body = "M21 36 Q23 19 42 19 Q58 21 67 38 Q81 42 97 56 L124 64 L99 72 Q84 86 62 84 Q36 80 32 54 Q30 46 21 41"
    return (
        path(body) + path("M22 31 L6 38 L23 42") + circle(39, 32, 2.6, **SOLID)
        + path("M50 50 Q66 44 92 64 Q72 76 57 68 Q47 60 50 50 Z M60 58 L78 64 M104 61 L112 68")
        + path("M57 84 L55 97 M68 84 L69 97 M14 99 Q60 93 122 99 M96 97 Q104 88 114 88 Q110 97 96 97")
    )


def fish():
    body = "M8 44 Q38 8 82 38 Q92 28 112 20 Q105 44 112 68 Q92 58 82 50 Q38 82 8 44 Z"
    scales = "".join(path(f"M{x} {y - 6} Q{x + 6} {y} {x} {y + 6}") for x, y in
                     [(46, 36), (46, 50), (57, 43), (57, 30), (57, 56), (68, 37), (68, 50)])
    return (
        path(body) + circle(24, 38, 3.4) + path("M34 26 Q42 44 33 62 M14 50 Q20 52 23 49") + scales
        + path("M44 19 Q58 4 70 10 Q66 20 68 28 M50 66 Q56 78 64 74 Q62 68 64 61")
    )


def bicycle():
    def wheel(x):
        spokes = "".join(f"M{x} 70 L{x + 22 * math.cos(a):.1f} {70 + 22 * math.sin(a):.1f} "
                         for a in [0.3 + k * math.pi / 3 for k in range(6)])
        return circle(x, 70, 22) + path(spokes, stroke_width=1) + circle(x, 70, 2.5, **SOLID)
    frame = "M28 70 L49 42 L89 41 L62 70 Z M46 33 L62 70 M38 32 Q46 30 54 33 M102 70 L86 28 Q78 24 76 31 M86 28 L96 26"
    return wheel(28) + wheel(102) + path(frame) + circle(62, 70, 6) + path("M62 70 L68 81 M64 82 L73 80")


def rose():
    bloom = curve(lambda t: (
        50 + (2 + 20 * t) * math.cos(6.5 * math.pi * t + 0.6) * (1 + 0.07 * math.sin(14 * t * math.pi)),
        34 + (2 + 17 * t) * math.sin(6.5 * math.pi * t + 0.6) * (1 + 0.07 * math.sin(14 * t * math.pi))), 240)
    petals = ("M30 30 Q18 34 22 48 Q28 60 42 58 M70 30 Q84 36 78 50 Q70 62 56 58 M36 54 Q50 68 66 54 "
              "M32 22 Q36 8 50 12 Q64 6 70 22")
    stem = "M50 62 Q55 84 49 104 Q46 120 50 136 M51 90 Q66 76 82 84 Q74 100 51 92 M51 91 L74 86"
    leaf = "M48 112 Q32 98 16 108 Q26 124 48 114 M47 113 L24 109 M52 78 L56 74 M47 124 L43 121"
    return path(bloom) + path(petals) + path(stem) + path(leaf)


def snail():
    shell = curve(lambda t: (62 + 27 * t ** 0.8 * math.cos(7 * math.pi * t + 0.5),
                             42 + 27 * t ** 0.8 * math.sin(7 * math.pi * t + 0.5)), 300)
    body = "M36 34 Q28 60 24 46 Q22 30 12 34 Q4 40 10 58 Q14 74 36 76 L112 76 Q98 66 86 58"
    return path(shell) + path(body) + path("M11 34 L6 16 M17 32 L21 14") + circle(6, 14, 2) + circle(21, 12, 2) + path(
        "M10 52 Q14 55 18 52")


def butterfly():
    def wing(sign):
        def at(x, y):
            return f"{60 + sign * x} {y}"
        return (path(f"M{at(2, 38)} Q{at(20, 4)} {at(48, 8)} Q{at(58, 22)} {at(44, 40)} Q{at(30, 52)} {at(3, 48)}")
                + path(f"M{at(3, 52)} Q{at(30, 50)} {at(40, 66)} Q{at(40, 86)} {at(24, 84)} Q{at(8, 76)} {at(2, 60)}")
                + circle(60 + sign * 36, 24, 6) + circle(60 + sign * 26, 68, 4.5)
                + path(f"M{at(4, 42)} Q{at(20, 34)} {at(29, 27)} M{at(1, 32)} Q{at(6, 18)} {at(14, 12)}"))
    return wing(1) + wing(-1) + path("M60 32 Q64 50 60 78 Q56 50 60 32 Z") + circle(60, 30, 3)


def star():
    corner = [(50 + r * math.sin(k * math.pi / 5), 52 - r * math.cos(k * math.pi / 5))
              for k, r in enumerate([46, 18] * 5)]
    return path("M" + " L".join(f"{x:.2f} {y:.2f}" for x, y in corner) + " Z")


def heart():
    return path("M50 88 C8 58 4 34 14 20 C24 8 42 10 50 28 C58 10 76 8 86 20 C96 34 92 58 50 88 Z")


def moon():
    return path("M62 8 C34 10 14 30 14 54 C14 80 36 98 60 96 C68 96 76 93 82 88 C56 88 40 72 40 50 C40 32 48 16 62 8 Z")


def mushroom():
    cap = path("M8 56 C8 24 30 8 52 8 C76 8 96 26 96 56 Q52 64 8 56 Z", **SOLID)
    dots = circle(34, 30, 8, **HOLE) + circle(62, 22, 6, **HOLE) + circle(76, 42, 8, **HOLE) + circle(50, 46, 5, **HOLE)
    return cap + dots + path("M38 60 Q44 84 34 100 Q52 106 70 100 Q60 84 66 60 M52 66 L51 92")


def apple():
    flesh = path("M50 30 C40 20 12 22 12 54 C12 84 34 100 50 92 C66 100 84 86 87 66 C72 68 70 50 86 44 "
                 "C80 24 60 22 50 30 Z", **SOLID)
    return flesh + path("M50 30 Q50 16 58 8", stroke_width=5) + path("M58 18 Q72 4 86 12 Q76 24 58 18 Z") + path(
        "M24 48 Q26 38 34 36", stroke="#fff", stroke_width=4)


def cactus():
    return (path("M52 94 L52 26 M52 66 Q26 66 26 42 M52 56 Q78 56 78 32", stroke_width=15)
            + path("M52 88 L52 28 M46 62 Q28 60 27 44 M60 50 Q76 50 77 36", stroke="#fff", stroke_width=1.8)
            + path("M30 94 L74 94 L68 118 L36 118 Z", fill="#fff") + path("M32 102 L72 102 M8 119 L96 119")
            + path("M52 18 L46 10 M52 18 L52 7 M52 18 L58 10"))


def labyrinth():
    rings = ""
    for k, (gap, width) in enumerate([(0.0, 0.5), (2.2, 0.34), (0.9, 0.26), (3.6, 0.22), (5.2, 0.18), (1.8, 0.16)]):
        r = 8 + 8 * k
        rings += path(curve(lambda t: (60 + r * math.cos(gap + width + t * (2 * math.pi - 2 * width)),
                                       60 + r * math.sin(gap + width + t * (2 * math.pi - 2 * width))), 120))
    walls = ""
    for k, a in [(0, 1.3), (1, 4.1), (2, 0.2), (2, 2.9), (3, 5.6), (3, 1.6), (4, 3.9), (4, 0.9)]:
        r0, r1 = 8 + 8 * k, 16 + 8 * k
        walls += f"M{60 + r0 * math.cos(a):.2f} {60 + r0 * math.sin(a):.2f} L{60 + r1 * math.cos(a):.2f} {60 + r1 * math.sin(a):.2f} "
    return rings + path(walls)


def knot():
    return path(curve(lambda t: (60 + 50 * math.sin(5 * 2 * math.pi * t + 0.2), 45 + 38 * math.sin(4 * 2 * math.pi * t)),
                      500, closed=True))


def sunflower():
    seeds = "".join(circle(50 + 2.9 * math.sqrt(k) * math.cos(2.39996 * k), 42 + 2.9 * math.sqrt(k) * math.sin(2.39996 * k), 0.9, **SOLID)
                    for k in range(1, 30))
    petals = ""
    for k in range(16):
        a, b = 2 * math.pi * k / 16, 0.17
        tip = (50 + 37 * math.cos(a), 42 + 37 * math.sin(a))
        left, right = [(50 + 18 * math.cos(a + s), 42 + 18 * math.sin(a + s)) for s in (-b, b)]
        bl, br = [(50 + 30 * math.cos(a + s), 42 + 30 * math.sin(a + s)) for s in (-b, b)]
        petals += path(f"M{left[0]:.1f} {left[1]:.1f} Q{bl[0]:.1f} {bl[1]:.1f} {tip[0]:.1f} {tip[1]:.1f} "
                       f"Q{br[0]:.1f} {br[1]:.1f} {right[0]:.1f} {right[1]:.1f}")
    return circle(50, 42, 18) + seeds + petals + path(
        "M50 80 Q54 104 50 126 M51 108 Q66 92 84 100 Q74 116 51 110 M51 116 Q36 100 18 106 Q26 122 51 118")


def house():
    bricks = "M66 22 L66 8 L76 8 L76 30"
    return (path("M10 50 L50 12 L90 50 M18 43 L18 96 L82 96 L82 43") + path(bricks)
            + path("M42 96 L42 66 Q50 58 58 66 L58 96 M54 82 L54.5 82 M26 54 L38 54 L38 68 L26 68 Z M32 54 L32 68 M26 61 L38 61")
            + path("M64 54 L76 54 L76 68 L64 68 Z M70 54 L70 68 M64 61 L76 61") + circle(50, 40, 6)
            + path("M71 5 Q76 -1 83 2 Q90 6 97 1 M4 96 L96 96"))


def tree():
    crown = ("M50 8 Q64 2 72 14 Q88 14 86 30 Q98 40 88 52 Q86 66 70 62 Q60 72 48 64 Q34 72 26 60 Q10 60 14 44 "
             "Q4 34 16 24 Q18 10 34 14 Q40 4 50 8 Z")
    trunk = "M44 66 Q46 90 34 108 L70 108 Q58 90 60 66 M52 70 L46 52 M54 76 L66 54"
    apples = "".join(circle(x, y, 4) for x, y in [(30, 36), (48, 24), (68, 30), (74, 46), (38, 50)])
    return path(crown) + path(trunk) + apples + path("M14 109 Q50 104 96 109")


def face():
    return (path("M18 46 Q16 88 50 100 Q84 88 82 46 Q80 14 50 12 Q20 14 18 46 Z")
            + path("M17 44 Q30 42 36 26 Q56 38 83 42 M18 44 Q6 42 10 58 Q13 66 20 64 M82 44 Q94 42 90 58 Q87 66 80 64")
            + circle(36, 54, 9) + circle(64, 54, 9) + path("M45 53 Q50 49 55 53") + circle(36, 54, 2, **SOLID)
            + circle(64, 54, 2, **SOLID) + path("M50 58 Q45 70 51 71 M36 80 Q50 90 66 79 M28 40 Q36 35 43 40 M58 40 Q66 35 74 40"))


def profile():
    return (path("M38 102 Q40 88 30 88 Q20 90 18 82 Q20 78 18 75 Q14 73 18 68 Q7 66 9 62 Q20 50 19 40 Q22 14 54 12 "
                 "Q88 14 88 48 Q86 66 76 76 Q74 90 82 102")
            + path("M19 38 Q40 38 46 24 Q56 44 66 50 Q76 40 74 58 Q70 70 64 66 M24 50 L33 48 M25 53 Q29 56 34 53 M18 75 L29 76"))


# ---- glyphs of fonts and icons of sets ------------------------------------------------------------------------------


def glyphs(package, file, text, box, margin=8):
    """`text` in a font's own outlines, filled, fitted into `box` units."""
    found = sorted((MODULES / "@fontsource" / package / "files").glob(file))
    for name in found:
        font = TTFont(name)
        cmap = font.getBestCmap()
        if all(ord(c) in cmap for c in text):
            break
    else:
        raise SystemExit(f"{package}: no file {file} holds {text!r}")
    outlines, x = "", 0
    shapes = font.getGlyphSet()
    for c in text:
        pen = SVGPathPen(shapes)
        shapes[cmap[ord(c)]].draw(pen)
        outlines += f'<path transform="translate({x} 0)" d="{pen.getCommands()}"/>'
        x += shapes[cmap[ord(c)]].width
    low, high, left, right, x = 1e9, -1e9, 1e9, -1e9, 0
    for c in text:
        bounds = BoundsPen(shapes)
        shapes[cmap[ord(c)]].draw(bounds)
        x0, y0, x1, y1 = bounds.bounds
        left, low, right, high = min(left, x + x0), min(low, y0), max(right, x + x1), max(high, y1)
        x += shapes[cmap[ord(c)]].width
    w, h = box
    k = min((w - 2 * margin) / (right - left), (h - 2 * margin) / (high - low))
    dx, dy = (w - k * (left + right)) / 2, (h + k * (low + high)) / 2
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {w} {h}">'
            f'<g transform="translate({dx} {dy}) scale({k} {-k})">{outlines}</g></svg>')


def icon(file, stroke):
    """An icon of 24 units drawn with another stroke width."""
    text = (MODULES / file).read_text()
    text = text.replace("currentColor", "#000")
    return re.sub(r'stroke-width="[^"]*"', f'stroke-width="{stroke}"', text, count=1)


# ---- rendering ------------------------------------------------------------------------------------------------------


def save(name, document, width, height, look="dark"):
    """`look`: dark ink on white, light ink on black, or ink on nothing (alpha)."""
    png = cairosvg.svg2png(bytestring=document.encode(), output_width=width, output_height=height)
    drawn = Image.open(io.BytesIO(png)).convert("RGBA")
    if look == "alpha":
        # White parts inside the ink are holes to see through.
        grey = Image.new("RGBA", drawn.size, "white")
        grey.alpha_composite(drawn)
        ink = ImageOps.invert(grey.convert("L"))
        flat = Image.merge("LA", [Image.new("L", ink.size, 0), ink])
    else:
        paper = Image.new("RGBA", drawn.size, "white")
        paper.alpha_composite(drawn)
        flat = paper.convert("L")
        if look == "light":
            flat = ImageOps.invert(flat)
    # Sixteen greys are plenty for an edge and halve the file.
    flat = flat.point(lambda value: round(value / 17) * 17)
    target = FOLDER / f"{name}.png"
    target.parent.mkdir(parents=True, exist_ok=True)
    flat.save(target, optimize=True)
    print(f"{target.stat().st_size:6} {name} {width} x {height}")


save("t01-animals/front", svg((110, 120), cat(), 2.0), 330, 360)
save("t01-animals/side", svg((130, 105), bird(), 1.9), 390, 315)
save("t01-animals/top", svg((120, 84), fish(), 1.7), 360, 252)

for view, letter in zip(["front", "side", "top"], "ABC"):
    save(f"t02-bold-letters/{view}", glyphs("inter", "inter-latin-800-normal.woff", letter, (280, 300), 24), 280, 300)

save("t03-vehicles/front", svg((130, 100), bicycle(), 2.6), 390, 300)
save("t03-vehicles/side", icon("lucide-static/icons/sailboat.svg", 1.4), 288, 288)
save("t03-vehicles/top", icon("lucide-static/icons/plane.svg", 1.0), 256, 256)

for view, letter, box in zip(["front", "side", "top"], "&g?", [(320, 300), (260, 320), (200, 320)]):
    save(f"t04-serif-glyphs/{view}",
         glyphs("playfair-display", "playfair-display-latin-700-normal.woff", letter, box, 20), *box)

save("t05-hair-lines/front", svg((100, 142), rose(), 0.6), 300, 426)
save("t05-hair-lines/side", svg((120, 84), snail(), 0.55), 360, 252)
save("t05-hair-lines/top", svg((120, 96), butterfly(), 0.6), 360, 288)

save("t06-icons/front", icon("lucide-static/icons/house.svg", 2), 256, 256, "alpha")
save("t06-icons/side", icon("lucide-static/icons/key-round.svg", 2), 256, 256, "alpha")
save("t06-icons/top", icon("lucide-static/icons/umbrella.svg", 2), 256, 256, "alpha")

save("t07-outlines/front", svg((100, 100), star(), 1.3), 300, 300)
save("t07-outlines/side", svg((100, 98), heart(), 1.3), 300, 294)
save("t07-outlines/top", svg((96, 104), moon(), 1.3), 288, 312)

save("t08-solids/front", svg((104, 112), mushroom(), 3), 312, 336)
save("t08-solids/side", svg((100, 106), apple(), 2.4), 300, 318)
save("t08-solids/top", svg((104, 126), cactus(), 3), 260, 315)

save("t09-dense/front", svg((120, 120), labyrinth(), 2.2), 360, 360)
save("t09-dense/side", svg((120, 90), knot(), 2.6), 360, 270)
save("t09-dense/top", svg((100, 130), sunflower(), 1.1), 320, 416)

for view, letter, box in zip(["front", "side", "top"], "MSK", [(320, 280), (240, 280), (256, 280)]):
    save(f"t10-thin-letters/{view}", glyphs("inter", "inter-latin-200-normal.woff", letter, box, 26), *box, "light")

save("p01-words/front", glyphs("alfa-slab-one", "alfa-slab-one-latin-400-normal.woff", "YES", (420, 200), 14), 420, 200)
save("p01-words/side", glyphs("alfa-slab-one", "alfa-slab-one-latin-400-normal.woff", "NO", (320, 200), 14), 320, 200)

save("p02-garden/front", svg((104, 104), f'<g transform="translate(0 4)">{house()}</g>', 1.6), 364, 364)
save("p02-garden/side", svg((104, 116), tree(), 2.4), 312, 348)

save("p03-faces/front", svg((100, 110), face(), 1.1), 300, 330)
save("p03-faces/side", svg((100, 110), profile(), 1.1), 300, 330)

for view, letter in zip(["front", "side"], "永和"):
    save(f"p04-brush-glyphs/{view}", glyphs("noto-serif-jp", "noto-serif-jp-*-400-normal.woff", letter, (300, 300), 16), 300, 300)

save("p05-tools/front", icon("@tabler/icons/icons/outline/anchor.svg", 0.6), 320, 320)
save("p05-tools/side", icon("@tabler/icons/icons/outline/rocket.svg", 0.6), 320, 320)
