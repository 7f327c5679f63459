"""Put into the planted copy of the sources (plant.py): what a page's script needs to choose a
fault, as fault.cpp says it."""
import os


def number(name):
    """FNV-1a without the sign bit; 0 for no fault."""
    hashed = 2166136261
    for byte in name.encode():
        hashed = (hashed ^ byte) * 16777619 % 2**32
    return hashed & 0x7FFFFFFF if name else 0


def text():
    return (
        "const caustics_reached = new Set();\n"
        "const FAULT = (number) => { caustics_reached.add(number); return number === "
        f"{number(os.environ.get('CAUSTICS_FAULT', ''))}; }};\n"
        "const altered = (value) => /[0-9]/.test(`${value}`) ? "
        "`${value}`.replace(/[0-9]/, (digit) => (+digit + 1) % 10)\n"
        '  : `?${[...`${value}`].reverse().join("")}`;\n'
    )
