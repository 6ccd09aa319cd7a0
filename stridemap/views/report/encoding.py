"""Tables for the page, in few bytes: every number to the last digit that the page shows.

A column of decimal fractions is a column of whole numbers, whose bytes lie apart by their place, the lowest
bytes of all rows first; all columns together are compressed and written in the characters of base 85. What
no whole number can stand for (infinities, sizes far from the others) is listed beside its column; a column
of which this holds too often travels in double precision.
"""

import math
import zlib
from collections.abc import Collection
from typing import Any

import numpy as np
import pandas as pd
from numpy.typing import NDArray

DECIMALS = 10
"""Decimals of measured quantities, as the command line prints them."""

STATE_DECIMALS = 15
"""Decimals of section points and periods: an unstable step enlarges what they leave away a thousand times."""

STATE_SHOWN = 12
"""Decimals of section points and periods that the page shows, of small ones as well."""

SMALL = 1e-3
"""Sizes below which a number is shown in `DIGITS` digits and a power of ten."""

DIGITS = 4

_MOST_ODD = 16
"""One number in so many may be listed beside its column."""

ALPHABET = "".join(chr(code) for code in range(33, 127) if chr(code) not in "\"\\<&'{(@/")
"""The digits of base 85: characters that neither JSON, HTML, a style nor an address gives a meaning."""

_LARGEST = 2**53


class Encoder:
    """Collects the columns of several tables in one compressed text."""

    def __init__(self) -> None:
        self._parts: list[bytes] = []
        self._size = 0

    def table(self, frame: pd.DataFrame, states: Collection[str] = ()) -> dict[str, Any]:
        """What the page is told of a table: rows and columns, with the places of their bytes.

        Parameters
        ----------
        frame : DataFrame
        states : collection of str, optional
            Columns from which a step is integrated; they have `STATE_DECIMALS`.
        """
        columns = {name: self._column(frame[name], name in states) for name in frame}
        return {"rows": len(frame), "columns": columns}

    def packed(self) -> dict[str, Any]:
        """All bytes, compressed, in base 85, and how many the compressed ones are."""
        data = zlib.compress(b"".join(self._parts), 9)
        return {"text": base85(data), "packed": len(data)}

    def _column(self, values: pd.Series, state: bool) -> dict[str, Any]:
        if pd.api.types.is_bool_dtype(values):
            truth = np.where(values.isna(), 2, values.fillna(False).astype(bool))
            return {"type": "bool", **self._whole(truth.astype(np.int64))}
        if pd.api.types.is_integer_dtype(values) and not values.isna().any():
            return {"type": "number", "whole": True, **self._whole(values.to_numpy(dtype=np.int64))}
        if pd.api.types.is_numeric_dtype(values):
            whole = pd.api.types.is_integer_dtype(values)
            numbers = values.to_numpy(dtype=float, na_value=np.nan)
            decimals = 0 if whole else STATE_DECIMALS if state else DECIMALS
            return {"type": "number", "whole": whole, **self._numbers(numbers, decimals)}
        words = sorted(values.dropna().unique())
        index = {word: i for i, word in enumerate(words)}
        codes = np.array([index.get(word, -1) for word in values], dtype=np.int64)
        return {"type": "word", "words": words, **self._whole(codes)}

    def _numbers(self, values: NDArray[np.float64], decimals: int) -> dict[str, Any]:
        """Numbers with gaps, in whichever form needs fewest exceptions."""
        fixed, odd_fixed = _decimal(values, decimals)
        if odd_fixed.sum() * _MOST_ODD <= len(values):
            return self._whole(fixed, missing=np.isnan(values) | odd_fixed) | {
                "decimals": decimals, **_listed(values, odd_fixed)
            }  # fmt: skip
        mantissa, power, odd = _scientific(values)
        if decimals == DECIMALS and odd.sum() * _MOST_ODD <= len(values):
            digits = self._whole(mantissa, missing=np.isnan(values) | odd)
            return digits | {"powers": self._whole(power), **_listed(values, odd)}
        return {"double": self._bytes(values.astype("<f8").view(np.uint8).reshape(-1, 8).T)}

    def _whole(self, values: NDArray[np.int64], missing: NDArray[np.bool_] | None = None) -> dict[str, Any]:
        """Whole numbers, counted from one below the least: a 0 is a gap."""
        there = values if missing is None else values[~missing]
        least = int(there.min()) if there.size else 0
        above = values - (least - 1)
        if missing is not None:
            above = np.where(missing, 0, above)
        # Of numbers that never fall the steps are smaller, and mostly 0 or 1.
        steps = missing is None and len(above) > 1 and bool((np.diff(above) >= 0).all())
        if steps:
            above = np.diff(above, prepend=0)
        n = max(1, (int(above.max(initial=0)).bit_length() + 7) // 8)
        planes = above.astype("<u8").view(np.uint8).reshape(-1, 8)[:, :n].T
        found = {"least": least, "planes": n, "at": self._bytes(planes)}
        return found | ({"steps": True} if steps else {})

    def _bytes(self, planes: NDArray[np.uint8]) -> int:
        at = self._size
        self._parts.append(np.ascontiguousarray(planes).tobytes())
        self._size += planes.size
        return at


def base85(data: bytes) -> str:
    """Bytes as characters of `ALPHABET`, five for each four; zeros fill the last four."""
    words = np.frombuffer(data + bytes(-len(data) % 4), ">u4").astype(np.int64)
    digits = np.empty((len(words), 5), np.uint8)
    for i in range(4, -1, -1):
        words, digits[:, i] = np.divmod(words, 85)
    return np.frombuffer(ALPHABET.encode(), np.uint8)[digits].tobytes().decode("ascii")


def _listed(values: NDArray[np.float64], odd: NDArray[np.bool_]) -> dict[str, Any]:
    """Numbers that stand beside their column, by row, as JavaScript reads them."""
    rows = np.flatnonzero(odd)
    if not len(rows):
        return {}
    text = {np.inf: "Infinity", -np.inf: "-Infinity"}
    return {"odd": [[int(row), text.get(values[row], repr(float(values[row])))] for row in rows]}


def _decimal(values: NDArray[np.float64], decimals: int) -> tuple[NDArray[np.int64], NDArray[np.bool_]]:
    """Numbers in units of the last decimal, and which of them cannot be written so.

    Small ones are first rounded to the digits in which they are shown, because rounding twice is another
    number. Those with `STATE_DECIMALS` are shown with fewer, and keep the side of a half that they are on.
    """
    scale = 10.0**decimals
    state = decimals == STATE_DECIMALS
    with np.errstate(all="ignore"):
        size = np.abs(values)
        small = np.isfinite(values) & (size < SMALL) & (values != 0) & (decimals == DECIMALS)
        scaled = values * scale
        odd = np.isinf(values) | (np.abs(scaled) >= _LARGEST) | (small & (size < SMALL / scale * 1e6))
        scaled = np.where(odd | np.isnan(values), 0.0, scaled)
        whole = np.rint(scaled)
        # The product is rounded itself: near a half only the decimal expansion decides.
        step = 10 ** (STATE_DECIMALS - STATE_SHOWN)
        if state:
            unsure = np.abs(np.abs(whole) % step - step // 2) <= 2
        else:
            unsure = np.abs(np.abs(scaled - whole) - 0.5) < 1e-3 + 1e-15 * np.abs(scaled)
    for row in np.flatnonzero((unsure | small) & ~odd):
        value = float(values[row])
        shown = float(f"{value:.{DIGITS - 1}e}") if small[row] else value
        whole[row] = int(f"{shown:.{decimals}f}".replace(".", "")) if decimals else round(shown)
        if state and abs(whole[row]) % step == step // 2:
            up = abs(int(f"{value:.{STATE_SHOWN}f}".replace(".", ""))) * step > abs(whole[row])
            whole[row] += math.copysign(1, value) * (1 if up else -1)
    return whole.astype(np.int64), odd


def _scientific(
    values: NDArray[np.float64],
) -> tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.bool_]]:
    """Numbers as `DIGITS` digits and a power of ten, and which of them are shown in another way."""
    size = np.abs(values)
    odd = np.isinf(values) | (size >= SMALL) | ((size < 1e-300) & (values != 0))
    mantissa, power = np.zeros(len(values), np.int64), np.zeros(len(values), np.int64)
    for row in np.flatnonzero(~odd & np.isfinite(values) & (values != 0)):
        digits, _, exponent = f"{values[row]:.{DIGITS - 1}e}".partition("e")
        mantissa[row], power[row] = int(digits.replace(".", "")), int(exponent) - (DIGITS - 1)
    return mantissa, power, odd
