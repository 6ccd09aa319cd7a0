"""Scrambled Sobol points: quasi-random numbers that fill a cube evenly.

They are those of ``scipy.stats.qmc.Sobol``, bit for bit: direction numbers of S. Joe and F. Y. Kuo, a random
linear scramble of their digits and a random digital shift (J. Matousek 1998, J. Complexity 14, 527). They are
computed here because loading SciPy's statistics takes longer than a whole search at one point.
"""

from functools import cache

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Bits = NDArray[np.uint32]

DIGITS = 30
"""Binary digits of each coordinate: after 2**30 points the sequence would repeat itself."""

JOE_KUO = """
    3: 1; 7: 1 3; 11: 1 3 1; 13: 1 1 1; 19: 1 1 3 3; 25: 1 3 5 13; 37: 1 1 5 5 17; 41: 1 1 5 5 5;
    47: 1 1 7 11 19; 55: 1 1 5 1 1; 59: 1 1 1 3 11; 61: 1 3 5 5 31; 67: 1 3 3 9 7 49;
    91: 1 1 1 15 21 21; 97: 1 3 1 13 27 49; 103: 1 1 1 15 7 5; 109: 1 3 1 15 13 25; 115: 1 1 5 5 19 61;
    131: 1 3 7 11 23 15 103; 137: 1 3 7 13 13 15 69; 143: 1 1 3 13 7 35 63; 145: 1 3 5 9 1 25 53;
    157: 1 3 1 13 9 35 107; 167: 1 3 1 5 27 61 31; 171: 1 1 5 11 19 41 61; 185: 1 3 5 3 3 13 69;
    191: 1 1 7 13 1 19 1; 193: 1 3 7 5 13 19 59; 203: 1 1 3 9 25 29 41; 211: 1 3 5 13 23 1 55;
    213: 1 3 7 3 13 59 17; 229: 1 3 1 3 5 53 69; 239: 1 1 5 5 23 33 13; 241: 1 1 7 7 1 61 123;
    247: 1 1 7 9 13 61 49; 253: 1 3 3 5 3 55 33; 285: 1 3 1 15 31 13 49 245; 299: 1 3 5 15 31 59 63 97;
    301: 1 3 1 11 11 11 77 249
"""
"""Direction numbers of the second and all further dimensions, each "polynomial: m1 m2 ...": the polynomial's
coefficients are the binary digits of its number, and m1, m2, ... are the first direction numbers.

The first rows of new-joe-kuo-6.21201, the numbers of S. Joe and F. Y. Kuo, "Constructing Sobol sequences with
better two-dimensional projections", SIAM J. Sci. Comput. 30 (2008), 2635-2654
(https://web.maths.unsw.edu.au/~fkuo/sobol/)."""

DIMENSIONS = 1 + JOE_KUO.count(":")
"""Dimensions for which there are direction numbers here; beyond them SciPy computes the points."""


def sobol_points(dimensions: int, m: int, rng: np.random.Generator) -> Array:
    """The first 2**m points of a scrambled Sobol sequence.

    Parameters
    ----------
    dimensions : int
    m : int
        From 0 to `DIGITS`.
    rng : numpy.random.Generator
        Makes the scramble and the shift.

    Returns
    -------
    ndarray, shape (2**m, dimensions)
        In the unit cube.
    """
    if dimensions > DIMENSIONS:
        from scipy.stats import qmc  # takes a second to load, so only where it is needed

        by_scipy: Array = qmc.Sobol(dimensions, rng=rng).random_base2(m)
        return by_scipy
    # SciPy leaves the generator that it is given to its owner, and draws from a child of it.
    bits, shift = _scrambled(_directions(dimensions)[:, :m], rng.spawn(1)[0])
    # Neighbours in a reflected Gray code differ in one digit, and so in one direction number.
    points_as_bits = shift[None]
    for column in bits.T:
        points_as_bits = np.concatenate([points_as_bits, points_as_bits[::-1] ^ column])
    points: Array = points_as_bits * np.float64(2.0**-DIGITS)
    return points


@cache
def _directions(dimensions: int) -> Bits:
    """Direction numbers, shape (dimensions, DIGITS), each with its digits at the upper end."""
    rows = [[1] * DIGITS]
    for row in JOE_KUO.split(";")[: dimensions - 1]:
        polynomial, first = row.split(":")
        rows.append(_recurred(int(polynomial), list(map(int, first.split()))))
    weights = 2 ** np.arange(DIGITS - 1, -1, -1, dtype=np.uint32)
    return np.array(rows, dtype=np.uint32) * weights


def _recurred(polynomial: int, m: list[int]) -> list[int]:
    """Direction numbers from the first ones by the recurrence of a primitive polynomial."""
    degree = len(m)
    for _ in range(degree, DIGITS):
        new = m[-degree] ^ (m[-degree] << degree)
        for k in range(1, degree):
            if polynomial >> (degree - k) & 1:
                new ^= m[-k] << k
        m.append(new)
    return m[:DIGITS]


def _scrambled(directions: Bits, rng: np.random.Generator) -> tuple[Bits, Bits]:
    """Direction numbers multiplied by random lower triangular matrices of digits, and a random shift."""
    d = len(directions)
    powers = 2 ** np.arange(DIGITS, dtype=np.uint32)
    shift: Bits = rng.integers(2, size=(d, DIGITS), dtype=np.uint32) @ powers
    matrices = np.tril(rng.integers(2, size=(d, DIGITS, DIGITS), dtype=np.uint32))
    diagonal = np.arange(DIGITS)
    matrices[:, diagonal, diagonal] = 1
    # Digits from the highest to the lowest, as the rows of the matrices count them.
    digits = directions[:, None, :] >> diagonal[::-1, None].astype(np.uint32) & 1
    scrambled = matrices @ digits & 1
    bits: Bits = (scrambled * powers[::-1, None]).sum(axis=1, dtype=np.uint32)
    return bits, shift
