"""An icon as a wire would show it: its lines as polylines, joined into one closed curve, drawn with one width.

Thin icons give their skeleton, solid ones their outline. Strokes are joined by the nearest free end, so links cross the picture
here and there as they do in a real wire; the curve is then smoothed, since wire bends.
"""

import numpy as np
from PIL import Image, ImageDraw
from scipy.ndimage import distance_transform_edt, gaussian_filter1d
from skimage.measure import find_contours
from skimage.morphology import skeletonize

from .render import SIDE

THICK = 5.0  # pixels; an icon with ink further than this from paper is drawn by its outline
FINE = 4  # drawn this much larger and averaged down
NEIGHBOURS = [(-1, 0), (0, -1), (0, 1), (1, 0), (-1, -1), (-1, 1), (1, -1), (1, 1)]


def wire(strokes: list[np.ndarray], random: np.random.Generator) -> np.ndarray:
    """One wire through `strokes` (see `lines`), with random order, smoothness and width; uint8 [SIDE, SIDE]."""
    path = _resampled(joined(strokes, random), 1.0)
    path = gaussian_filter1d(path, random.uniform(0.7, 2.2), axis=0, mode="wrap")
    return drawn(path, random.uniform(1.6, 5.0))


def drawn(path: np.ndarray, width: float) -> np.ndarray:
    """The closed polyline `path` ([n, 2], row and column in pixels) as ink, uint8 [SIDE, SIDE]."""
    picture = Image.new("L", (SIDE * FINE, SIDE * FINE))
    points = [(float(c + 0.5) * FINE, float(r + 0.5) * FINE) for r, c in path]
    ImageDraw.Draw(picture).line([*points, *points[:2]], fill=255, width=max(1, round(width * FINE)), joint="curve")
    return np.asarray(picture.reduce(FINE))


def lines(ink: np.ndarray) -> list[np.ndarray]:
    """The icon's lines as polylines [n, 2] in pixels, the shortest specks left out."""
    mask = ink > 127
    if not mask.any():
        return []
    if distance_transform_edt(mask).max() > THICK:
        found = find_contours(ink.astype(np.float32), 127.5)
    else:
        found = _traced(skeletonize(mask))
    return [line for line in found if len(line) > 4]


def joined(strokes: list[np.ndarray], random: np.random.Generator) -> np.ndarray:
    """One tour through all strokes: from the end of each to the nearest end of one that is left."""
    left = list(strokes)
    path = [left.pop(random.integers(len(left)))]
    while left:
        here = path[-1][-1]
        ends = np.array([[stroke[0], stroke[-1]] for stroke in left])
        nearest, end = divmod(int(np.argmin(((ends - here) ** 2).sum(-1))), 2)
        stroke = left.pop(nearest)
        path.append(stroke[::-1] if end else stroke)
    return np.concatenate(path).astype(np.float32)


def _resampled(path: np.ndarray, step: float) -> np.ndarray:
    """The closed polyline with points every `step` pixels."""
    closed = np.vstack([path, path[:1]])
    along = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(closed, axis=0), axis=1))])
    at = np.arange(0, max(along[-1], step), step)
    return np.stack([np.interp(at, along, closed[:, axis]) for axis in (0, 1)], 1)


def _traced(skeleton: np.ndarray) -> list[np.ndarray]:
    """The skeleton's pixels as paths: from every end and junction along unvisited pixels, then what is left, which is loops."""
    left = {(int(r), int(c)) for r, c in np.argwhere(skeleton)}
    beside = {p: [q for d in NEIGHBOURS if (q := (p[0] + d[0], p[1] + d[1])) in left] for p in left}
    starts = sorted(left, key=lambda p: (len(beside[p]) != 1, len(beside[p]) == 2, p))
    paths = []
    for start in starts:
        if start not in left:
            continue
        path = [start]
        left.discard(start)
        while (following := next((q for q in beside[path[-1]] if q in left), None)) is not None:
            path.append(following)
            left.discard(following)
        # A loop, or a branch that ends where another path passes: walk onto that pixel, so that no gap is left.
        onto = next((q for q in beside[path[-1]] if len(path) > 2 and q not in path[-3:]), None)
        paths.append(np.array(path + ([onto] if onto else []), np.float32))
    return paths
