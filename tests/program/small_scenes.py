"""The scenes of outputs_test.py that no sample scene is: made by glb.py and named here."""

import math
import pathlib
import struct

import glb
from pictures import exr, png

SCENES = pathlib.Path(__file__).resolve().parents[2] / "scenes"

SUN = {"name": "low sun", "type": "directional", "intensity": 900, "color": [1, 0.8, 0.5]}


def two_lights():
    """A ball of 10 cm, of green glass that disperses, under a sun and a lamp, over a reddish floor."""
    green = glb.glass(thicknessFactor=0.05, attenuationDistance=0.03, attenuationColor=[0.2, 0.9, 0.4])
    green["extensions"]["KHR_materials_dispersion"] = {"dispersion": 0.4}
    document, blob = glb.unpack(glb.scene(green, light=SUN))
    document["materials"][1]["pbrMetallicRoughness"]["baseColorFactor"] = [0.9, 0.5, 0.3, 1]
    lights = document["extensions"]["KHR_lights_punctual"]["lights"]
    lights.append({"name": "lamp", "type": "point", "intensity": 70, "color": [0.4, 0.6, 1]})
    turn = math.radians(-60) / 2
    document["nodes"][2]["rotation"] = [math.sin(turn), 0, 0, math.cos(turn)]
    document["nodes"].append({"name": "lamp", "translation": [1.5, 2.5, 0.5],
                              "extensions": {"KHR_lights_punctual": {"light": 1}}})
    # All of it a tenth as large.
    top = len(document["nodes"])
    document["nodes"].append({"name": "all", "scale": [0.1] * 3, "children": list(range(top))})
    document["scenes"] = [{"nodes": [top]}]
    return glb.pack(document, blob)


def mixed():
    """A golden ball under one lamp and a thin pane's glass: a mirror, a spot light, no camera."""
    gold = {"name": "gold", "pbrMetallicRoughness": {"metallicFactor": 1, "roughnessFactor": 0.05,
                                                     "baseColorFactor": [1, 0.8, 0.3, 1]}}
    spot = {"name": "spot", "type": "spot", "intensity": 500,
            "spot": {"innerConeAngle": 0.2, "outerConeAngle": 0.5}}
    document, blob = glb.unpack(glb.scene(gold, light=spot, floors=((0, 0, 0), (0, 0.4, -1))))
    document["nodes"] = [node for node in document["nodes"] if "camera" not in node]
    document["scenes"] = [{"nodes": list(range(len(document["nodes"])))}]
    return glb.pack(document, blob)


def pool():
    """The sample pool with few cells, half a second after its plops begin."""
    document, blob = glb.unpack((SCENES / "water_plops.glb").read_bytes())
    document["nodes"][0]["extras"]["water"] = {"cells": 24, "start": 0.5}
    return glb.pack(document, blob)


def files():
    """By name."""
    ramp = [x / 8 for _ in range(6) for x in range(8)]
    bent = [v + (0.25 if i % 7 == 3 else 0) for i, v in enumerate(ramp)]
    rising = [i / 48 for i in range(48)]
    zero = [0.0] * 48
    shades = [(i * 5 % 256, i * 3 % 256, 128) for i in range(48)]
    rows = [list(range(x, x + 8)) for x in range(40, -1, -8)]
    waves = {"R": [0.1 + math.sin(i) ** 2 for i in range(48)], "G": [1 / (3 + i) for i in range(48)],
             "B": [0.7 * math.cos(i) ** 2 for i in range(48)]}
    return {
        "two.glb": two_lights(), "gold.glb": mixed(), "opaque.glb": glb.scene({"name": "clay"}),
        "pool.glb": pool(), "thin.glb": glb.scene(glb.glass()), "lamps.glb": glb.many_lights([40, 0, 3]),
        "a.exr": exr({"R": ramp, "G": rising, "B": zero, "depth.R": rising}, 8, 6),
        "b.exr": exr({"R": bent, "G": [v * 1.01 for v in rising], "B": zero, "depth.R": rising}, 8, 6),
        "c.exr": exr({"R": ramp, "G": rising, "normal.R": zero}, 8, 6),
        "nan.exr": exr({"R": ramp[:-1] + [math.nan], "G": [math.inf] + rising[1:], "B": zero,
                        "depth.R": rising}, 8, 6),
        "wide.exr": exr({"R": ramp, "G": rising, "B": zero, "depth.R": rising}, 6, 8),
        "mask.exr": exr({"R": [float(i % 3 == 0) for i in range(48)]}, 8, 6),
        "nothing.exr": exr({"R": zero}, 8, 6), "waves.exr": exr(waves, 8, 6),
        "turned.exr": exr({name: [v[i] for row in rows for i in row] for name, v in waves.items()}, 8, 6),
        "swapped.exr": exr({"R": waves["B"], "G": waves["G"], "B": waves["R"]}, 8, 6),
        "rolled.exr": exr({"R": waves["G"], "G": waves["B"], "B": waves["R"]}, 8, 6),
        "halves.exr": exr({name: [struct.unpack("e", struct.pack("e", v))[0] for v in values]
                           for name, values in waves.items()}, 8, 6),
        "double.exr": exr({name: [2 * v for v in values] for name, values in waves.items()}, 8, 6),
        "a.png": png(shades, 8, 6), "b.png": png(shades[::-1], 8, 6),
    }
