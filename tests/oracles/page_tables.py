"""The tables that a page carries, unpacked a second time: by plain loops, after the format's description."""

import json
import re
import struct
import zlib

ALPHABET = [chr(code) for code in range(33, 127) if chr(code) not in "\"\\<&'{(@/"]


def data_of(page):
    """What the page is given, as plain values."""
    return json.loads(
        re.search(r'<script type="application/json" id="data">(.*?)</script>', page, re.DOTALL)[1]
    )


class Tables:
    """Columns of a page by table and name.

    Parameters
    ----------
    packed : mapping
        The text in base 85, and how many of its bytes are compressed ones.
    """

    def __init__(self, packed):
        value = {sign: i for i, sign in enumerate(ALPHABET)}
        text, out = packed["text"], bytearray()
        for i in range(0, len(text), 5):
            word = 0
            for sign in text[i : i + 5]:
                word = 85 * word + value[sign]
            out += word.to_bytes(4, "big")
        self.bytes = zlib.decompress(bytes(out[: packed["packed"]]))

    def whole(self, column, rows):
        """Whole numbers; None where there is a gap."""
        n, at = column["planes"], column["at"]
        found = [
            sum(self.bytes[at + place * rows + row] << 8 * place for place in range(n)) for row in range(rows)
        ]
        if column.get("steps"):
            for row in range(1, rows):
                found[row] += found[row - 1]
        return [None if value == 0 else value + column["least"] - 1 for value in found]

    def column(self, table, name):
        """Entries as numbers, words, truth, or None."""
        rows, column = table["rows"], table["columns"][name]
        if "double" in column:
            planes = [self.bytes[column["double"] + i * rows :][:rows] for i in range(8)]
            return [struct.unpack("<d", bytes(plane[row] for plane in planes))[0] for row in range(rows)]
        found = self.whole(column, rows)
        if column["type"] == "word":
            return [column["words"][code] if code >= 0 else None for code in found]
        if column["type"] == "bool":
            return [{0: False, 1: True, 2: None}[code] for code in found]
        if "powers" in column:
            powers = self.whole(column["powers"], rows)
            found = [None if v is None else float(f"{v}e{p}") for v, p in zip(found, powers, strict=True)]
        elif column.get("decimals"):
            found = [None if v is None else float(f"{v}e-{column['decimals']}") for v in found]
        for row, text in column.get("odd", []):
            found[row] = float(text)
        return found
