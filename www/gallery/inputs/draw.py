#!/usr/bin/env python3
"""Draws the gallery's drawings again: `draw.py [NAME]...`, beside this file.

Needs `pip install cairosvg pillow`. The pictures are committed: nothing in the project needs this script.
"""

import io
import sys
from pathlib import Path

import cairosvg
from drawings import BOXES, LINE, WIDTH
from PIL import Image

SIDE_PX = 320
FOLDER = Path(__file__).parent


def drawn(name):
    wide, high = BOXES.get(name, (100, 100))
    svg = (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {wide} {high}"><rect width="{wide}" height="{high}" fill="#fff"/>'
        f'<g fill="none" stroke="#000" stroke-width="{WIDTH}" stroke-linecap="round" stroke-linejoin="round">{LINE[name]}</g></svg>'
    )
    scale = SIDE_PX / max(wide, high)
    png = cairosvg.svg2png(svg.encode(), output_width=round(wide * scale), output_height=round(high * scale))
    # Sixteen greys are plenty for an edge and halve the file.
    return Image.open(io.BytesIO(png)).convert("L").point(lambda value: round(value / 17) * 17)


for name in sys.argv[1:] or LINE:
    drawn(name).save(FOLDER / f"{name}.png", optimize=True)
