"""Numbers that Python, Rust, JavaScript and WGSL make alike, bit for bit: a self-test's inputs need no file.

Only 32-bit integers are involved until the last step, and 24 bits fit a float32 exactly.
"""

import numpy as np

FORMULA = (
    "u(seed, i) = (mix(i + seed * 0x9e3779b9) >>> 8) / 2^24 for flat index i, all modulo 2^32; "
    "mix(x): x ^= x >>> 16; x *= 0x7feb352d; x ^= x >>> 15; x *= 0x846ca68b; x ^= x >>> 16"
)
SKETCH = (
    "of n values into k = min(n, 64) numbers: sketch[i mod k] += value[i] * sign(i), "
    "sign(i) = +1 where mix(i) < 2^31 and -1 elsewhere; summed in double precision"
)
BUCKETS = 64


def mix(index: np.ndarray) -> np.ndarray:
    """A bijection of 32-bit integers that leaves no visible pattern. Same shape, uint32."""
    x = np.asarray(index).astype(np.uint32)
    x = x ^ (x >> np.uint32(16))
    x = x * np.uint32(0x7FEB352D)
    x = x ^ (x >> np.uint32(15))
    x = x * np.uint32(0x846CA68B)
    return x ^ (x >> np.uint32(16))


def uniform(seed: int, shape: tuple[int, ...]) -> np.ndarray:
    """float32 in 0 <= u < 1, row by row."""
    count = int(np.prod(shape, dtype=np.int64))
    offset = (seed * 0x9E3779B9) % 2**32
    index = (np.arange(count, dtype=np.uint64) + np.uint64(offset)) % np.uint64(2**32)
    return ((mix(index) >> np.uint32(8)).astype(np.float32) / np.float32(2**24)).reshape(shape)


def signed(seed: int, shape: tuple[int, ...]) -> np.ndarray:
    """float32 in -1 <= s < 1: `2 u - 1`, exact."""
    return (2 * uniform(seed, shape) - 1).astype(np.float32)


def unit_rows(seed: int, shape: tuple[int, int]) -> np.ndarray:
    """float32 [rows, width]: `signed`, each row divided by its length (in double precision)."""
    rows = signed(seed, shape).astype(np.float64)
    return (rows / np.linalg.norm(rows, axis=-1, keepdims=True)).astype(np.float32)


def sketch(values: np.ndarray) -> np.ndarray:
    """float64 [min(n, 64)]: how one array of any size is compared with another without shipping it.

    A relative error in the array becomes about the same relative error here, wherever it is and whatever it looks like:
    wrong channels, swapped axes and wrong signs all show.
    """
    flat = np.asarray(values, np.float64).ravel()
    buckets = max(1, min(flat.size, BUCKETS))
    index = np.arange(flat.size, dtype=np.uint64)
    sign = np.where(mix(index) < np.uint32(2**31), 1.0, -1.0)
    return np.bincount((index % np.uint64(buckets)).astype(np.int64), flat * sign, minlength=buckets)
