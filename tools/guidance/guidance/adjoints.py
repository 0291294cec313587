"""Backward operators that ONNX has no word for, said in operators that it has.

Each rule replaces one `aten` operator while a gradient is traced (`make_fx`'s decomposition table). Rules see shapes with a
symbolic batch, so only channels and pixels are turned into numbers.
"""

import torch
from torch._decomp import core_aten_decompositions

from . import resize
from .errors import ModelError

aten = torch.ops.aten


def table() -> dict:
    """torch's own decompositions, and those below."""
    rules = dict(core_aten_decompositions())
    rules[aten.convolution_backward.default] = _convolution
    rules[aten.avg_pool2d_backward.default] = _average_pool
    rules[aten.max_pool2d_with_indices_backward.default] = _max_pool
    rules.update(resize.rules())
    return rules


def _convolution(grad, x, weight, _bias, stride, padding, dilation, transposed, _extra, groups, wanted):
    if wanted[1] or wanted[2]:
        raise ModelError("A weight asks for a gradient. Freeze the network first: requires_grad_(False).")
    axes = weight.dim() - 2
    if transposed:
        return aten.convolution(grad, weight, None, stride, padding, dilation, False, [0] * axes, groups), None, None
    extent = [dilation[i] * (int(weight.shape[2 + i]) - 1) + 1 for i in range(axes)]
    extra = _lost(x, grad, extent, stride, padding)
    back = lambda g, w: aten.convolution(g, w, None, stride, padding, dilation, True, extra, groups)
    several = int(weight.shape[0]) // groups
    if groups > 1 and int(weight.shape[1]) == 1 and several > 1:
        # onnxruntime-web 1.30 on WebGPU gets the transposed form wrong for one channel a group out of several,
        # so it becomes as many depthwise ones.
        parts = [back(grad[:, j::several], weight[j::several]) for j in range(several)]
        return sum(parts[1:], parts[0]), None, None
    return back(grad, weight), None, None


def _average_pool(grad, x, kernel, stride, padding, ceil, include_padding, divisor):
    kernel, stride, padding = list(kernel), list(stride) or list(kernel), list(padding)
    if ceil or divisor is not None or (any(padding) and not include_padding):
        raise ModelError("An average pool with ceil_mode, a divisor or uncounted padding has no rule. Pad before it.")
    channels = int(x.shape[1])
    weight = torch.full((channels, 1, *kernel), 1 / (kernel[0] * kernel[1]), dtype=x.dtype)
    extra = _lost(x, grad, kernel, stride, padding)
    return aten.convolution(grad, weight, None, stride, padding, [1, 1], True, extra, channels)


def _max_pool(grad, x, kernel, stride, padding, dilation, ceil, _indices):
    """Each place under the kernel is a strided slice; where it equals the maximum, its share goes back through a depthwise
    transposed convolution with a single one. Equal maxima share the gradient (torch gives all to the first)."""
    kernel, stride, padding = list(kernel), list(stride) or list(kernel), list(padding)
    if ceil or any(d != 1 for d in dilation):
        raise ModelError("A max pool with ceil_mode or dilation has no rule. Pad before it instead.")
    channels = int(x.shape[1])
    most = aten.max_pool2d(x, kernel, stride, padding)
    rows, columns = int(most.shape[2]), int(most.shape[3])
    padded = aten.constant_pad_nd(x, [padding[1]] * 2 + [padding[0]] * 2, -3e38) if any(padding) else x
    places = [(i, j) for i in range(kernel[0]) for j in range(kernel[1])]
    hits = []
    for i, j in places:
        under = padded[:, :, i : i + stride[0] * (rows - 1) + 1 : stride[0], j : j + stride[1] * (columns - 1) + 1 : stride[1]]
        hits.append((under == most).to(x.dtype))
    share = grad / sum(hits)
    extra = _lost(x, grad, kernel, stride, padding)
    back = None
    for (i, j), hit in zip(places, hits):
        one = torch.tensor([float(p == (i, j)) for p in places], dtype=x.dtype).reshape(1, 1, *kernel)
        part = aten.convolution(share * hit, one.repeat(channels, 1, 1, 1), None, stride, padding, [1, 1], True, extra, channels)
        back = part if back is None else back + part
    return back


def _lost(x, grad, extent, stride, padding) -> list[int]:
    """Rows and columns at the end that a strided kernel never reached: the transposed convolution's output_padding."""
    return [
        int(x.shape[2 + i]) - ((int(grad.shape[2 + i]) - 1) * stride[i] - 2 * padding[i] + extent[i])
        for i in range(len(extent))
    ]
