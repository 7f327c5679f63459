"""Files as lines of text: JSON with what is short on one line, tables as they are, and of pictures what sums
tell of each channel."""

import base64
import csv
import hashlib
import json
import re
import struct
import zlib

from pictures import Exr

WIDTH = 108
MOST_LINES = 60  # of a JSON file that is shown as it is
# Keys of what a run takes, and of what is this machine's or this build's.
MASKED = set("""bandwidth_bytes_per_second deviation operations_per_second peak_memory_bytes
prepare_milliseconds share_of_bound milliseconds processor_milliseconds seconds peak stated before after
median least most pareto sentences memory_bytes memory_budget_bytes device program embree path
digest""".split())


def without_times(value, key=""):
    if key in MASKED and not isinstance(value, dict):
        return "MASKED"
    if isinstance(value, dict):
        of_times = key in ("milliseconds", "seconds")
        return {k: "MASKED" if of_times else without_times(v, k) for k, v in value.items()}
    if isinstance(value, list):
        return [without_times(each) for each in value]
    if isinstance(value, str):  # nor this machine's lanes
        return re.sub(r"\d+ lanes \(\w+\)", "lanes", value)
    return value


def laid_out(value, indent="", head=""):
    short = json.dumps(value, ensure_ascii=False)
    if len(indent + head + short) <= WIDTH or not isinstance(value, (dict, list)) or not value:
        return [indent + head + short]
    inner = [(f"{key}: ", each) for key, each in value.items()] if isinstance(value, dict) else [
        ("", each) for each in value]
    if isinstance(value, list) and not any(isinstance(each, (dict, list)) for each in value):
        return [indent + head + short]
    lines = [line for name, each in inner for line in laid_out(each, indent + " ", name)]
    return [indent + head + ("{" if isinstance(value, dict) else "[")] + lines


def by_path(value, path=""):
    """(path, value) of all that is no list and no object; places in lists are left out of the path."""
    if isinstance(value, dict):
        for key, each in value.items():
            yield from by_path(each, f"{path}.{key}" if path else key)
    elif isinstance(value, list):
        yield path + "[]", len(value)
        for each in value:
            yield from by_path(each, path + "[]")
    else:
        yield path, value


def report_lines(text):
    """A study's page without its drawings, its tables' numbers, and the rows that times choose."""
    text = re.sub(r"<(svg|style).*?</\1>", "", text, flags=re.DOTALL).replace(' class="best"', "")
    text = re.sub(r"(nothing beats.*?<tbody>).*?(</tbody>)", r"\1\2", text, count=1, flags=re.DOTALL)
    return re.sub(r"<td[^>]*>(?:[\d.]+(?: \*| \w+)?|front|)</td>", "<td>#</td>", text).splitlines()


def csv_lines(text):
    """Without what a study takes, and finds by it."""
    rows = list(csv.reader(text.splitlines()))
    kept = [i for i, name in enumerate(rows[0])
            if not name.startswith(("ms_", "milliseconds_")) and name != "pareto"]
    return [",".join(row[i] for i in kept) for row in rows]


def summed_up(value):
    """A line for each path: how many values, the sum of numbers, weighted by their places, and a hash of
    words."""
    paths = {}
    for path, each in by_path(value):
        paths.setdefault(path, []).append(each)
    single = {path: values[0] for path, values in paths.items() if path.startswith("settings.")}
    if single:
        paths = {"settings": [f"{path}={value}" for path, value in single.items()]} | {
            path: values for path, values in paths.items() if path not in single}
    for path, values in paths.items():
        numbers = [(i, v) for i, v in enumerate(values) if type(v) in (int, float)]
        words = repr([v for v in values if type(v) not in (int, float)])
        words = hashlib.sha256(words.encode()).hexdigest()[:8]
        told = f"sum {sum((1 + i % 7) * v for i, v in numbers):.8g}" if numbers else ""
        told += f" words {words}" if len(numbers) < len(values) else ""
        yield f"{path}: {len(values)}, {told.strip()}"


def json_lines(text):
    document = without_times(json.loads(text))
    lines = laid_out(document)
    return lines if len(lines) <= MOST_LINES else list(summed_up(document))


def page_lines(text):
    """Of an inspection's page: its recording, and its parts as one hash."""
    recording = re.search(r'id="recording">(.*?)</script>', text, re.DOTALL)[1]
    parts = re.findall(r'id="blob-\d+">(.*?)</script>', text, re.DOTALL)
    hashed = hashlib.sha256()
    for part in parts:
        hashed.update(zlib.decompress(base64.b64decode(part)))
    return json_lines(recording) + [f"{len(parts)} parts, {hashed.hexdigest()[:16]}"]


def sums(values, width):
    """The mean, the mean square, and the means weighted from left to right and from top to bottom: a texel
    that changes or moves changes them. What is no finite number is counted."""
    finite = [(i, v) for i, v in enumerate(values) if abs(v) < 1e30]
    count, rows = max(len(values), 1), max(len(values) // max(width, 1), 1)
    weights = (lambda i, v: v, lambda i, v: v * v, lambda i, v: v * (i % width) / width,
               lambda i, v: v * (i // width) / rows)
    told = " ".join(f"{sum(weigh(i, v) for i, v in finite) / count:.7g}" for weigh in weights)
    return told + (f", {len(values) - len(finite)} not finite" if len(finite) < len(values) else "")


def unfiltered(data, row, step):
    """The bytes of a PNG's rows, without their filters."""
    before, out = bytes(row), bytearray()
    for at in range(0, len(data), row + 1):
        kind, line = data[at], bytearray(data[at + 1:at + 1 + row])
        for i in range(row):
            left, up = line[i - step] if i >= step else 0, before[i]
            corner = before[i - step] if i >= step else 0
            guess = left + up - corner
            paeth = min((abs(guess - near), place, near) for place, near in enumerate((left, up, corner)))[2]
            line[i] = (line[i] + (0, left, up, (left + up) // 2, paeth)[kind]) % 256
        out += line
        before = bytes(line)
    return bytes(out)


def png_channels(data):
    """Width, height, and values by channel."""
    at, body = 8, b""
    while at < len(data):
        size, = struct.unpack_from(">I", data, at)
        if data[at + 4:at + 8] == b"IHDR":
            width, height, depth, colours = struct.unpack_from(">IIBB", data, at + 8)
        if data[at + 4:at + 8] == b"IDAT":
            body += data[at + 8:at + 8 + size]
        at += 12 + size
    count = {0: 1, 2: 3, 4: 2, 6: 4}[colours]
    assert depth == 8, "a picture of 8 bits is expected"
    pixels = unfiltered(zlib.decompress(body), width * count, count)
    return width, height, {"RGBA"[c] if count > 2 else "YA"[c]: list(pixels[c::count]) for c in range(count)}


def lines_of(path):
    data = path.read_bytes()
    if path.suffix == ".exr":
        file = Exr(data)
        return [f"{file.width}x{file.height}"] + [
            f"{name} {sums(values, file.width)}" for name, values in sorted(file.values().items())]
    if path.suffix == ".png":
        width, height, channels = png_channels(data)
        return [f"{width}x{height}"] + [f"{name} {sums(values, width)}" for name, values in channels.items()]
    if path.suffix == ".json":
        return json_lines(data.decode())
    if path.suffix in (".jpg", ".tif", ".hdr", ".state"):
        return [f"{len(data)} bytes, {hashlib.sha256(data).hexdigest()[:16]}"]
    if path.suffix == ".html" and b'id="recording"' in data:
        return page_lines(data.decode())
    if path.suffix == ".csv":
        return csv_lines(data.decode())
    text = re.sub(r"base64,[A-Za-z0-9+/=]+", "base64", data.decode())
    return report_lines(text) if path.suffix == ".html" else text.splitlines()
