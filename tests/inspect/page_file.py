"""Puts a recording into the inspect page, as `caustics inspect` does: for tests that need a page with
known values."""
import base64
import hashlib
import html
import json
import pathlib
import struct
import zlib

PAGE = pathlib.Path(__file__).resolve().parents[2] / "app" / "inspect" / "page"
CODES = {"u8": "B", "u16": "H", "u32": "I", "f32": "f"}


class Blobs:
    """The arrays of a page: base64 of a zlib stream of byte planes, lowest bytes first."""

    def __init__(self):
        self.texts = []

    def add(self, kind, values):
        values = list(values)
        packed = struct.pack(f"<{len(values)}{CODES[kind]}", *values)
        size = struct.calcsize(CODES[kind])
        planes = b"".join(packed[plane::size] for plane in range(size))
        self.texts.append(base64.b64encode(zlib.compress(planes)).decode("ascii"))
        return {"blob": len(self.texts) - 1, "type": kind, "count": len(values)}

    def values(self, array):
        """What was added, as the page holds it."""
        size, count = struct.calcsize(CODES[array["type"]]), array["count"]
        planes = zlib.decompress(base64.b64decode(self.texts[array["blob"]]))
        packed = b"".join(planes[i::count] for i in range(count))
        return struct.unpack(f"<{count}{CODES[array['type']]}", packed)

    def elements(self):
        return "\n".join(
            f'<script type="text/plain" id="blob-{number}">{text}</script>'
            for number, text in enumerate(self.texts)
        )


def hash_of(values):
    return hashlib.sha256(repr(values).encode()).hexdigest()


def script():
    names = (PAGE / "modules.txt").read_text().split()
    return '(() => {\n"use strict";\n' + "\n".join((PAGE / name).read_text() for name in names) + "\n})();"


def page(recording, blobs, title="Recording"):
    # "<" would end the script element in a name like "</script>".
    document = json.dumps(recording).replace("<", "\\u003c")
    parts = {
        "@TITLE@": html.escape(title),
        "@STYLE@": (PAGE / "page.css").read_text(),
        "@SCRIPT@": script(),
        "@RECORDING@": document,
        "@BLOBS@": blobs.elements(),
    }
    text = (PAGE / "page.html").read_text()
    for mark, part in parts.items():
        before, after = text.split(mark)
        text = before + part + after
    return text
