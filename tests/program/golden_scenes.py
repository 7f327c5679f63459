"""Scenes in which as much as possible is away from its default, turned, off centre and of three different
sizes: what golden_test.py draws beside the sample scenes. Each is a function that returns a Scene of
scenes/making."""
import math

from golden_geometry import stored  # noqa: F401
from golden_parts import (CLAMP, MIRROR, NEAREST, REPEAT, above, around, bumps, carried, floors, moved, noise,
                          place, png, texture, three_lights, view)
from making.gltf_scene import Scene, diffuse, glass, metal, pane
from making.shapes import box, icosphere, lens, square, torus, upright


def crystal():
    """A caster with all textures, attenuation and dispersion, squeezed and turned, before three lights."""
    s = Scene()
    material = glass("crystal", 1.62, ((0.9, 0.6, 0.4), 0.5), dispersion=0.6)
    material["pbrMetallicRoughness"]["baseColorFactor"] = [0.95, 0.9, 0.85, 1]
    material["pbrMetallicRoughness"]["baseColorTexture"] = texture(
        s, png(8, 6, noise(2, 3, (0.3,) * 4, (1.0,) * 4)), (CLAMP, MIRROR),
        extensions=moved([0.1, 0.2], [0.8, 1.4], -0.3))
    material["normalTexture"] = texture(s, png(12, 10, bumps(0.4)), (REPEAT, MIRROR), scale=0.3,
                                        extensions=moved([-0.2, 0.1], [0.6, 0.9], 0.8))
    material["extensions"]["KHR_materials_transmission"]["transmissionTexture"] = texture(
        s, png(6, 5, noise(3, 3, (0.75, 0, 0), (1, 1, 1))), (MIRROR, CLAMP))
    shape = icosphere((0, 0, 0), 0.3, 2)
    s.mesh("crystal", shape, material, around(shape))
    place(s, (0.1, 0.65, -0.1), (1, 2, 0.5), 35, (1.1, 0.7, 0.9))
    shape = box((-0.15, -0.04, -0.2), (0.15, 0.04, 0.2))
    cut = glass("lattice", 1.4)
    cut.update(alphaMode="MASK", alphaCutoff=0.4)
    cut["pbrMetallicRoughness"].update(baseColorFactor=[1, 1, 1, 0.9], baseColorTexture=texture(
        s, png(5, 5, noise(4, 5)), (MIRROR, REPEAT), mag=NEAREST))
    s.mesh("lattice", shape, cut, above(shape, 2.0))
    place(s, (-0.5, 0.5, 0.3), (0.3, 1, 0.2), -40, (1.3, 1.0, 0.8))
    floors(s)
    three_lights(s)
    view(s)
    return carried(s, (31.0, -7.0, 12.0), (0.1, 1.0, -0.05), 20, 1.3)


def surfaces():
    """Receivers of many materials, four and more of them blended over one another, a mirror between them."""
    s = Scene()
    floors(s)
    rows = {
        "coat": {"pbrMetallicRoughness": {
            "baseColorTexture": texture(s, png(16, 16, noise(5, 8)), mag=NEAREST),
            "metallicRoughnessTexture": texture(s, png(7, 9, noise(6, 3)), (CLAMP, REPEAT)),
            "metallicFactor": 0.8, "roughnessFactor": 0.7},
            "normalTexture": texture(s, png(12, 8, bumps(0.5)), (MIRROR, MIRROR), scale=0.8),
            "occlusionTexture": texture(s, png(6, 6, noise(7, 3)), strength=0.7),
            "emissiveTexture": texture(s, png(5, 6, noise(8, 2))), "emissiveFactor": [0.3, 0.2, 0.6],
            "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 1.5}}},
        "holes": {"alphaMode": "MASK", "alphaCutoff": 0.6, "doubleSided": True, "pbrMetallicRoughness": {
            "baseColorTexture": texture(s, png(8, 8, noise(9, 8))), "metallicFactor": 0.0,
            "baseColorFactor": [0.9, 0.9, 0.5, 0.95]}},
        "plain": {"extensions": {"KHR_materials_unlit": {}}, "pbrMetallicRoughness": {
            "baseColorFactor": [0.2, 0.7, 0.5, 1]}},
        "metal": metal("metal", (0.9, 0.6, 0.3)),
        "brushed": {"pbrMetallicRoughness": {"metallicFactor": 0.9, "roughnessFactor": 0.35,
                                             "baseColorFactor": [0.6, 0.7, 0.9, 1]}},
    }
    for k, (name, material) in enumerate(rows.items()):
        shape = icosphere((0, 0, 0), 0.17, 2) if k % 2 else box((-0.15,) * 3, (0.15,) * 3)
        s.mesh(name, shape, {**material, "name": name}, around(shape))
        place(s, (-0.8 + 0.4 * k, 0.22 + 0.03 * k, -0.5 + 0.25 * k), (k, 1, 2), 30 * k,
              (1.0, 0.8 + 0.1 * k, 1.1))
    for k in range(5):
        veil = {"name": f"veil {k}", "alphaMode": "BLEND", "doubleSided": k != 1, "pbrMetallicRoughness": {
            "baseColorFactor": [0.2 + 0.15 * k, 0.9 - 0.1 * k, 0.5, 0.3 + 0.1 * k], "metallicFactor": 0.0}}
        if k % 2:
            veil["pbrMetallicRoughness"]["baseColorTexture"] = texture(s, png(4, 4, noise(20 + k, 4)))
        shape = upright(0.0, 0.3, 0.05, 0.6)
        s.mesh(veil["name"], shape, veil, [(p[2], p[1]) for p in shape[0]])
        place(s, (0.2 - 0.07 * k, 0.05, 0.75 + 0.04 * k), (0, 1, 0.1), 70 + 9 * k)
    three_lights(s)
    view(s)
    s.extensions |= {"KHR_materials_emissive_strength", "KHR_materials_unlit"}
    return carried(s, (-4.0, 3.0, 9.0), (0.2, 1.0, 0.1), -35, 0.7)


def frosted():
    """Rough glass, solid, thin and with one interface, under a lamp with a size."""
    s = Scene()
    floors(s)
    ball = glass("frosted", 1.45, ((0.7, 0.9, 0.8), 0.3), dispersion=0.4)
    ball["pbrMetallicRoughness"].update(roughnessFactor=0.45, baseColorFactor=[0.9, 0.95, 1, 1])
    s.mesh("frosted", icosphere((0, 0, 0), 0.25, 2), ball)
    place(s, (0.1, 0.5, 0.1), (1, 1, 0), 40, (1.0, 0.8, 1.2))
    wall = pane("frosted pane", (0.8, 0.9, 0.7))
    wall["pbrMetallicRoughness"]["roughnessFactor"] = 0.3
    s.mesh("pane", upright(0.0, 0.25, 0.1, 0.7), wall)
    place(s, (-0.5, 0, -0.3), (0, 1, 0), -30)
    clear = glass("clear", 1.5)
    s.mesh("clear", icosphere((0, 0, 0), 0.12, 2), clear)
    place(s, (0.6, 0.35, -0.35), (0, 1, 1), 40, (1.0, 1.2, 0.8))
    s.light((-0.4, -1.0, -0.2), (0.5, 1.7, 0.3), name="lamp", type="spot", intensity=25.0,
            color=[1, 0.9, 0.7], spot={"innerConeAngle": 0.5, "outerConeAngle": 0.9}, extras={"radius": 0.08})
    s.sun((0.6, -1.0, -0.2), 3.0, extras={"angular_diameter": 4.0})
    view(s)
    return s


def window():
    """Panes that are tinted, textured, cut out and blended before a spot and a point light, in haze."""
    s = Scene()
    floors(s)
    for k in range(3):
        material = pane(f"pane {k}", (0.9 - 0.3 * k, 0.4 + 0.2 * k, 0.3 + 0.3 * k))
        material["extensions"]["KHR_materials_ior"] = {"ior": 1.3 + 0.2 * k}
        material["extensions"]["KHR_materials_transmission"]["transmissionFactor"] = 0.95 - 0.1 * k
        if k:
            material["pbrMetallicRoughness"]["baseColorTexture"] = texture(
                s, png(6, 7, noise(30 + k, 3, (0.3,) * 4, (1.0,) * 4)), (CLAMP, MIRROR),
                extensions=moved([0.1 * k, 0.2], [1.5, 0.8], 0.4 * k))
        if k == 2:
            material.update(alphaMode="MASK", alphaCutoff=0.55)
        shape = upright(0.0, 0.3, 0.05, 0.8)
        s.mesh(material["name"], shape, material, [(1.4 * p[2] + 0.2, 1.3 * p[1] - 0.1) for p in shape[0]])
        place(s, (-0.2 - 0.15 * k, 0, 0.4 * k - 0.4), (0, 1, 0.1), 15 * k - 10)
    veil = {"name": "veil", "alphaMode": "BLEND", "doubleSided": True, "pbrMetallicRoughness": {
        "baseColorFactor": [0.7, 0.5, 0.9, 0.6], "metallicFactor": 0.0,
        "baseColorTexture": texture(s, png(5, 4, noise(40, 3)))}}
    shape = upright(0.0, 0.3, 0.05, 0.7)
    s.mesh("veil", shape, veil, [(p[2], p[1]) for p in shape[0]])
    place(s, (0.5, 0, -0.5), (0, 1, 0), 35)
    s.mesh("ball", icosphere((0.3, 0.4, 0.45), 0.18, 2), glass("amber", 1.5, ((0.95, 0.7, 0.3), 0.3)))
    s.light((-1.0, -0.8, -0.2), (1.2, 1.3, 0.4), name="spot", type="spot", intensity=18.0,
            color=[1, 0.8, 0.6], spot={"innerConeAngle": 0.3, "outerConeAngle": 0.7})
    s.light((0, -1, 0), (-1.0, 1.2, -0.3), name="point", type="point", intensity=5.0, color=[0.6, 0.8, 1])
    view(s)
    s.gltf["scenes"][0]["extras"] = {"medium": {"scattering": [0.15, 0.2, 0.25],
                                                "absorption": [0.1, 0.03, 0.06], "anisotropy": 0.45}}
    return s


def misty():
    """Casters of glass and metal in haze, before a sun with a colour and a lamp among them."""
    s = Scene()
    floors(s)
    s.mesh("lens", lens(0.25, 0.45, 20, 4), glass("lens", 1.55, ((0.6, 0.8, 0.9), 0.4)))
    place(s, (-0.2, 0.7, 0.0), (1, 0, 0.4), 15, (1.1, 1.0, 0.9))
    s.mesh("ring", torus((0.4, 0.3, -0.3), 0.2, 0.05, (0.2, 1.0, 0.3), 12), metal("gold", (1.0, 0.8, 0.4)))
    s.light((0.4, -1.0, 0.2), name="sun", type="directional", intensity=6.0, color=[1.0, 0.9, 0.7])
    s.light((0, -1, 0), (0.2, 0.9, 0.5), name="lamp", type="point", intensity=3.0, color=[0.5, 0.7, 1.0])
    view(s)
    s.gltf["scenes"][0]["extras"] = {"medium": {"scattering": 0.2, "absorption": 0.05, "anisotropy": -0.3}}
    return s


def oblong_pool():
    """Water that moves on a grid of other than square shape, away from the origin."""
    s = Scene()
    s.mesh("pool", square(1.0, 0.0), glass("water", 1.33, ((0.7, 0.9, 0.95), 0.8)))
    place(s, (0.3, 0.35, -0.2), (0, 1, 0), 0, (1.2, 1.0, 0.7))
    s.gltf["nodes"][-1]["extras"] = {"water": {
        "speed": 0.8, "damping": 0.3, "cells": 24, "start": 0.9,
        "plops": {"interval": 0.3, "radius": 0.32, "height": 0.06, "seed": 5}}}
    floors(s)
    s.light((0.3, -1.0, -0.2), name="sun", type="directional", intensity=8.0, color=[1.0, 0.95, 0.8])
    view(s)
    return s


def nested():
    """Bodies in bodies, tinted, opaque things among them, before a mirror: light that is followed."""
    s = Scene()
    floors(s)
    s.mesh("body", icosphere((0, 0, 0), 0.35, 2), glass("body", 1.5, ((0.8, 0.9, 0.7), 0.6)))
    place(s, (0, 0.55, 0), (1, 0, 1), 20, (1.0, 0.9, 1.1))
    s.mesh("bubble", icosphere((0.08, 0.6, 0.05), 0.12, 2), glass("bubble", 1 / 1.5))
    s.mesh("seed", icosphere((-0.15, 0.5, 0.05), 0.07, 1), diffuse("seed", (0.7, 0.2, 0.2)))
    s.mesh("neighbour", box((0.4, 0.1, -0.3), (0.6, 0.5, 0.1)), glass("neighbour", 1.4, dispersion=0.5))
    s.mesh("mirror", upright(0.0, 0.5, 0.02, 0.8), metal("silver", (0.95, 0.9, 0.85)))
    place(s, (-0.7, 0, 0), (0, 1, 0.1), 15)
    s.light((0.5, -1.0, 0.2), name="sun", type="directional", intensity=6.0, color=[1.0, 0.9, 0.8])
    s.light((0, -1, 0), (0.3, 1.5, 0.6), name="point", type="point", intensity=7.0, color=[0.7, 0.8, 1.0])
    view(s)
    return s


def many_lamps():
    """Lamps of many strengths, meshes that shine, and lights with a size."""
    s = Scene()
    floors(s)
    s.mesh("ball", icosphere((0.1, 0.5, 0.0), 0.25, 2), glass("ball", 1.5))
    for k in range(17):
        s.light((0, -1, 0), (1.2 * math.cos(k), 1.0 + 0.05 * k, 1.2 * math.sin(k)), name=f"lamp {k}",
                type="point", intensity=8.0 / (1 + k * k), color=[1.0, 0.5 + 0.03 * k, 1.0 - 0.04 * k])
    view(s)
    return s


def shining():
    """Meshes that shine, one of them textured, one to both sides; a panel."""
    s = Scene()
    floors(s)
    s.extensions.add("KHR_materials_emissive_strength")
    s.mesh("ball", icosphere((0.1, 0.45, 0.0), 0.2, 2), glass("ball", 1.5))
    glow = {"name": "glow", "emissiveFactor": [1.0, 0.7, 0.4], "pbrMetallicRoughness": {
        "baseColorFactor": [0.3, 0.3, 0.3, 1], "metallicFactor": 0.0},
        "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 30.0}}}
    s.mesh("tube", torus((0, 0, 0), 0.2, 0.05, (0.3, 1.0, 0.2), 8), glow)
    place(s, (0.5, 1.0, 0.3), (1, 0, 0), 25, (1.0, 1.2, 0.9))
    sheet = {"name": "sheet", "emissiveFactor": [0.5, 0.8, 1.0], "doubleSided": True,
             "emissiveTexture": texture(s, png(4, 4, noise(50, 2))),
             "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 40.0}}}
    shape = upright(0.0, 0.25, 0.4, 0.9)
    s.mesh("sheet", shape, sheet, [(p[2] + 0.5, p[1]) for p in shape[0]])
    place(s, (-0.6, 0.1, 0.1), (0, 1, 0), 20)
    s.light((0.3, -1.0, 0.1), (0.0, 1.5, -0.4), name="panel", type="point", intensity=4.0,
            extras={"rectangle": [0.5, 0.2]})
    view(s)
    return s
