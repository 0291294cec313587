"""Resizing as two matrices.

A resize is linear and treats each axis alone, `out = A_h x A_w^T`, so its adjoint is `A_h^T g A_w`. The matrices are
measured by resizing unit vectors while the graph is traced: they are exactly what torch does.
"""

import torch
from torch.utils._python_dispatch import _disable_current_modes

aten = torch.ops.aten
EXACT = ("upsample_nearest2d", "_upsample_nearest_exact2d")
SMOOTH = ("upsample_bilinear2d", "upsample_bicubic2d", "_upsample_bilinear2d_aa", "_upsample_bicubic2d_aa")


def rules() -> dict:
    """Decompositions of torch's resizes and of their backward operators. Smooth ones are replaced forward, too:
    ONNX's Resize rounds its coordinates otherwise."""
    table = {}
    for name in EXACT + SMOOTH:
        forward = getattr(aten, name).default
        table[getattr(aten, f"{name}_backward").default] = _backward(forward)
        if name in SMOOTH:
            table[forward] = _forward(forward)
    return table


def _forward(resize):
    def rule(x, size, *options):
        rows, columns = _matrices(resize, x.shape, size, options)
        return rows @ x @ columns.t()

    return rule


def _backward(resize):
    def rule(grad, size, input_size, *options):
        rows, columns = _matrices(resize, input_size, size, options)
        return rows.t() @ grad @ columns

    return rule


def _matrices(resize, given, wanted, options):
    with _disable_current_modes(), torch.no_grad():
        return tuple(_matrix(resize, int(given[2 + i]), int(wanted[i]), options, i) for i in (0, 1))


def _matrix(resize, given: int, wanted: int, options, axis: int):
    """[wanted, given]. The other axis goes from 2 to 2: torch's antialiased kernel is wrong from 1 to 1."""
    options = list(options)
    if len(options) >= 2:  # scale factors, vertical then horizontal, are the last two
        options[-1 if axis == 0 else -2] = None
    units = torch.eye(given).reshape(given, 1, given, 1).expand(given, 1, given, 2).contiguous()
    if axis == 0:
        return resize(units, [wanted, 2], *options)[..., 0].reshape(given, wanted).t().contiguous()
    units = units.transpose(2, 3).contiguous()
    return resize(units, [2, wanted], *options)[:, :, 0, :].reshape(given, wanted).t().contiguous()
