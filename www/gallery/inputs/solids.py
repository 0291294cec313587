#!/usr/bin/env python3
"""The gallery's solids, by formula: pictures of some of them for strokes, meshes of others to cover: `solids.py [NAME]...`.

Each is a distance to a smooth union of balls, tapered rods and rings (y up, seen from +z). Needs `pip install numpy
pillow`. Pictures and meshes are committed: nothing in the project needs this script.
"""

import sys
from pathlib import Path

import numpy as np
from PIL import Image

FOLDER = Path(__file__).parent
SIDE_PX = 300
CELLS = 56


def ball(c, r, s=(1, 1, 1)):
    """A ball, or an ellipsoid of half axes r * s (its distance is Quilez' approximation)."""
    c, s = np.array(c), r * np.array(s, float)

    def f(p):
        q = (p - c) / s
        k0, k1 = np.linalg.norm(q, axis=-1), np.linalg.norm(q / s, axis=-1)
        return k0 * (k0 - 1) / np.maximum(k1, 1e-9)

    return f


def rod(*points):
    """Tapered rods through points x, y, z, radius."""
    v = np.array(points, float)

    def f(p):
        best = np.full(p.shape[:-1], 1e9)
        for a, b in zip(v, v[1:]):
            d = b[:3] - a[:3]
            t = np.clip(((p - a[:3]) @ d) / max(d @ d, 1e-12), 0, 1)
            best = np.minimum(best, np.linalg.norm(p - a[:3] - t[..., None] * d, axis=-1) - (a[3] + t * (b[3] - a[3])))
        return best

    return f


def bent(points, count=5):
    """The same along a smooth curve through the points."""
    p = np.array(points, float)
    out = []
    for k in range(len(p) - 1):
        a, b, c, d = (p[min(max(j, 0), len(p) - 1)] for j in (k - 1, k, k + 1, k + 2))
        for t in np.linspace(0, 1, count, endpoint=False):
            out.append(0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t * t + (3 * b - a - 3 * c + d) * t**3))
    return rod(*out, p[-1])


def turned(profile):
    """A solid of revolution about y: (y, radius) from bottom to top."""
    y, r = np.array(profile, float).T

    def f(p):
        across = (np.hypot(p[..., 0], p[..., 2]) - np.interp(p[..., 1], y, r)) * 0.6
        return np.maximum(across, np.maximum(y[0] - p[..., 1], p[..., 1] - y[-1]))

    return f


class Solid:
    """Parts (distance, colour), joined with roundings of `k`; turned by `azimuth` degrees for its picture."""

    def __init__(self, *parts, k=0.08, azimuth=0):
        self.parts, self.k, self.azimuth = parts, k, azimuth

    def __call__(self, p):
        d = None
        for f, _ in self.parts:
            e = f(p)
            if d is None:
                d = e
            else:
                h = np.maximum(self.k - np.abs(d - e), 0) / self.k
                d = np.minimum(d, e) - h * h * self.k / 4
        return d

    def colour(self, p):
        nearest = np.argmin([f(p) for f, _ in self.parts], axis=0)
        return np.array([c for _, c in self.parts])[nearest]


def mirrored(f):
    return lambda p: np.minimum(f(p), f(p * [-1, 1, 1]))


DARK, MID, PALE, WHITE = (0.12,) * 3, (0.5,) * 3, (0.8,) * 3, (0.97,) * 3

SOLIDS = {
    "octopus": Solid(
        (ball((0, 0.38, 0), 0.46, (1, 1.12, 1)), PALE),
        *[(bent([(0.2 * np.cos(a), 0.05, 0.2 * np.sin(a), 0.17), (0.42 * np.cos(a), -0.26, 0.42 * np.sin(a), 0.125), (0.62 * np.cos(a + s), -0.62, 0.62 * np.sin(a + s), 0.09),
                 (0.86 * np.cos(a + 2 * s), -0.66, 0.86 * np.sin(a + 2 * s), 0.065), (0.9 * np.cos(a + 3 * s), -0.46, 0.9 * np.sin(a + 3 * s), 0.05)]), PALE)
          for a, s in [(2 * np.pi * (k + 0.5) / 8, 0.12 * (1 if k % 2 else -1)) for k in range(8)]],
        (mirrored(ball((0.17, 0.36, 0.4), 0.085)), DARK), k=0.12),
    "owlet": Solid(
        (ball((0, -0.12, 0), 0.6, (1, 1.2, 0.9)), PALE), (ball((0, 0.46, 0.04), 0.46, (1.05, 0.86, 0.92)), PALE),
        (mirrored(rod((0.26, 0.66, 0.05, 0.15), (0.4, 0.93, 0.02, 0.03))), MID),
        (mirrored(ball((0.2, 0.5, 0.36), 0.19, (1, 1, 0.6))), WHITE), (mirrored(ball((0.19, 0.5, 0.46), 0.085)), DARK),
        (rod((0, 0.41, 0.44, 0.07), (0, 0.27, 0.56, 0.02)), MID), (mirrored(ball((0.55, -0.16, 0), 0.46, (0.32, 1.15, 0.8))), MID),
        (mirrored(ball((0.2, -0.8, 0.3), 0.13, (1, 0.6, 1.3))), MID), k=0.06),
    "duckling": Solid(
        (ball((-0.05, -0.35, 0), 0.5, (1.25, 0.85, 1)), PALE), (ball((0.32, 0.36, 0), 0.36), PALE), (rod((0.3, 0.2, 0, 0.26), (0.2, -0.2, 0, 0.34)), PALE),
        (rod((-0.5, -0.28, 0, 0.2), (-0.82, 0.06, 0, 0.05)), PALE), (ball((0.68, 0.29, 0), 0.17, (1.25, 0.45, 1)), MID),
        (ball((0.42, 0.46, 0.3), 0.06), DARK), (ball((0.42, 0.46, -0.3), 0.06), DARK),
        (ball((-0.15, -0.3, 0.46), 0.32, (1.2, 0.75, 0.35)), WHITE), (ball((-0.15, -0.3, -0.46), 0.32, (1.2, 0.75, 0.35)), WHITE), k=0.1, azimuth=-24),
    "bonsai": Solid(
        (turned([(-0.92, 0.42), (-0.88, 0.44), (-0.66, 0.54), (-0.62, 0.58), (-0.57, 0.58), (-0.55, 0.5)]), MID),
        (bent([(0.02, -0.62, 0, 0.15), (-0.16, -0.32, 0.06, 0.11), (0.1, -0.02, 0, 0.09), (-0.02, 0.34, 0, 0.07), (0.02, 0.6, 0, 0.04)]), DARK),
        (bent([(0.06, -0.08, 0, 0.07), (0.34, 0.06, 0.05, 0.055), (0.56, 0.12, 0.06, 0.04)]), DARK), (bent([(0, 0.2, 0, 0.06), (-0.28, 0.26, 0, 0.045), (-0.48, 0.34, 0, 0.04)]), DARK),
        (ball((0.56, 0.2, 0.05), 0.34, (1, 0.48, 0.9)), PALE), (ball((-0.5, 0.42, 0), 0.34, (1, 0.5, 0.9)), PALE), (ball((0.04, 0.72, 0), 0.4, (1, 0.55, 0.9)), PALE), k=0.04),
    "hand": Solid(
        (ball((0, -0.34, 0), 0.4, (0.86, 0.95, 0.42)), PALE), (rod((0, -0.6, 0, 0.24), (0, -0.95, 0, 0.24)), PALE),
        *[(rod((x0, -0.1, 0, 0.115), (x1, y1, 0.04, 0.1), (x2, y2, 0.02, 0.08)), PALE) for x0, x1, y1, x2, y2 in [(-0.26, -0.34, 0.24, -0.4, 0.5), (-0.09, -0.11, 0.36, -0.13, 0.74), (0.09, 0.12, 0.38, 0.14, 0.8), (0.25, 0.32, 0.3, 0.38, 0.62)]],
        (rod((-0.22, -0.5, 0.04, 0.14), (-0.5, -0.24, 0.14, 0.11), (-0.66, 0.02, 0.16, 0.085)), PALE), k=0.05),
    "kettle": Solid(
        (ball((0, -0.2, 0), 0.56, (1, 0.88, 1)), PALE), (ball((0, 0.3, 0), 0.34, (1, 0.32, 1)), PALE), (ball((0, 0.48, 0), 0.1), PALE),
        (bent([(0.4, -0.3, 0, 0.17), (0.7, -0.16, 0, 0.12), (0.78, 0.12, 0, 0.085), (0.98, 0.3, 0, 0.07)]), PALE),
        (bent([(-0.42, 0.14, 0, 0.07), (-0.78, 0.2, 0, 0.07), (-0.9, -0.1, 0, 0.07), (-0.72, -0.4, 0, 0.07), (-0.46, -0.46, 0, 0.07)]), PALE), (turned([(-0.74, 0.36), (-0.7, 0.38), (-0.62, 0.34)]), PALE), k=0.05),
    "dove": Solid(
        (ball((0, -0.1, 0), 0.34, (1.5, 0.8, 0.8)), WHITE), (ball((0.5, 0.16, 0), 0.2), WHITE), (rod((0.4, 0.06, 0, 0.2), (0.2, -0.1, 0, 0.24)), WHITE), (rod((0.66, 0.14, 0, 0.06), (0.82, 0.1, 0, 0.015)), MID),
        (rod((-0.4, -0.12, 0, 0.15), (-0.9, -0.24, 0, 0.07)), WHITE), (rod((-0.4, -0.12, 0.06, 0.12), (-0.86, -0.2, 0.2, 0.05)), WHITE), (rod((-0.4, -0.12, -0.06, 0.12), (-0.86, -0.2, -0.2, 0.05)), WHITE),
        *[(rod((0.12 - 0.1 * j, 0.06, s * 0.2, 0.11), (0.0 - 0.17 * j, 0.46 - 0.03 * j, s * 0.52, 0.085), (-0.22 - 0.2 * j, 0.84 - 0.13 * j, s * 0.66, 0.04)), WHITE) for j in range(4) for s in (1, -1)],
        (ball((0.58, 0.2, 0.17), 0.035), DARK), k=0.05, azimuth=-35),
}
PICTURES = ["owlet", "duckling", "bonsai", "hand", "dove"]
MESHES = ["kettle", "octopus"]


def gradient(f, p, e=1e-3):
    g = np.stack([f(p + d) - f(p - d) for d in e * np.eye(3)], -1)
    return g / np.maximum(np.linalg.norm(g, axis=-1, keepdims=True), 1e-9)


def picture(solid):
    """Matte, a lamp at the upper left, on white; seen from the front after the turn."""
    n, a = SIDE_PX, np.radians(solid.azimuth)
    turn = np.array([[np.cos(a), 0, np.sin(a)], [0, 1, 0], [-np.sin(a), 0, np.cos(a)]])
    f = lambda p: solid(p @ turn)
    u = (np.arange(n) + 0.5) / n * 2.16 - 1.08
    p = np.stack([np.tile(u, (n, 1)), np.tile(-u[:, None], (1, n)), np.full((n, n), 1.6)], -1)
    p = p.reshape(-1, 3)
    p[:, 2] = 1.15
    # Only rays that are still on their way.
    rays, hit = np.arange(len(p)), np.zeros(len(p), bool)
    for _ in range(70):
        d = f(p[rays])
        hit[rays] = d < 0.004
        p[rays, 2] -= np.clip(0.85 * d, 0.002, 0.3)
        rays = rays[(d >= 0.004) & (p[rays, 2] > -1.2)]
    q = p[hit]
    shade = 0.2 + 0.8 * np.clip(gradient(f, q) @ np.array([-0.5, 0.62, 0.6]), 0, 1)
    grey = np.ones(len(p))
    grey[hit] = solid.colour(q @ turn)[:, 0] * shade
    grey = np.clip(grey.reshape(n, n), 0, 1) ** 0.8
    return Image.fromarray((255 * grey).astype(np.uint8)).resize((n * 4 // 5, n * 4 // 5), Image.LANCZOS)


def mesh(solid):
    """Surface nets (Gibson 1998), as OBJ."""
    n = CELLS
    axis = np.linspace(-1.12, 1.12, n + 1)
    grid = np.stack(np.meshgrid(axis, axis, axis, indexing="ij"), -1)
    d = solid(grid)
    inside = d < 0
    number, vertices = {}, []
    crossed = np.zeros((n, n, n), int)
    for i in (0, 1):
        for j in (0, 1):
            for k in (0, 1):
                crossed += inside[i:n + i, j:n + j, k:n + k]
    for cell in np.argwhere((crossed > 0) & (crossed < 8)):
        number[tuple(cell)] = len(vertices)
        vertices.append(axis[cell] + (axis[1] - axis[0]) / 2)
    v = np.array(vertices)
    for _ in range(6):
        g = gradient(solid, v)
        v -= g * np.clip(solid(v), -0.02, 0.02)[:, None]
    faces = []
    for c in range(3):
        a, b = (c + 1) % 3, (c + 2) % 3
        moved = np.roll(inside, -1, c)
        edges = np.argwhere(inside != moved)
        for e in edges:
            if e[c] >= n or not (0 < e[a] < n and 0 < e[b] < n):
                continue
            step = lambda x, y: tuple(e - x * np.eye(3, dtype=int)[a] - y * np.eye(3, dtype=int)[b])
            q = [number[step(x, y)] for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
            faces.append(q if inside[tuple(e)] else q[::-1])
    lines = [f"v {x:.3f} {y:.3f} {z:.3f}" for x, y, z in v] + ["f " + " ".join(str(i + 1) for i in q) for q in faces]
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    for name in sys.argv[1:] or SOLIDS:
        if name in PICTURES:
            picture(SOLIDS[name]).save(FOLDER / f"{name}.png", optimize=True)
        if name in MESHES:
            (FOLDER / f"{name}.obj").write_text(mesh(SOLIDS[name]))
