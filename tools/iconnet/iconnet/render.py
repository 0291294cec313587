"""SVG to pictures of ink: SIDE x SIDE bytes, 0 for paper and 255 for ink."""

import io

import numpy as np
import resvg_py
from PIL import Image

from .errors import DataError

SIDE = 96  # half as fine again as the network's 64, so that views may turn and grow
BOX = 78  # pixels that an icon's longer side fills


def ink(svg: str) -> np.ndarray:
    """The icon in the middle of white paper; colours by their lightness. uint8 [SIDE, SIDE].

    Raises DataError if it is no SVG.
    """
    try:
        png = resvg_py.svg_to_bytes(svg_string=svg.replace("currentColor", "#000"), width=BOX, height=BOX, background="#ffffff")
        icon = Image.open(io.BytesIO(bytes(png))).convert("L")
    except Exception as error:  # resvg raises whatever it likes
        raise DataError(f"An icon cannot be drawn: {type(error).__name__}: {str(error)[:200]}") from error
    paper = Image.new("L", (SIDE, SIDE), 255)
    paper.paste(icon, ((SIDE - icon.width) // 2, (SIDE - icon.height) // 2))
    return 255 - np.asarray(paper)
