"""A recording with known values. The light `sun` shines through a ball of glass; the light `lamp` is made by
hand, so that every share can be computed in the head:

  lamp's map (8 x 8):  cell (1, 1) gave 6 to texel (2, 2), cell (2, 1) gave 3 to (3, 2),
  cell (4, 5) gave 1 to (3, 3)
                       and 2 to (5, 5)
  pixel (2, 2) reads texels 2..4 x 2..4, a quarter of each: 10 in all, of that 60 %, 30 %, 10 %
  pixel (3, 2) reads half of texels (3, 2) and (4, 2): 1.5, all from cell (2, 1)

Run B differs from run A first in landing[sun], texel (10, 12), by 0.25.
"""
import math

import ball_of_glass as ball
from page_file import Blobs
from recording_parts import COVERED, LUX, STATUS, XYZ, RunMaker, pixel_table
from tiny_picture import HEIGHT, WIDTH, floor_of_pixel, pixels, sees_ball
from tiny_sun import MAP, SCRIPT, map_places, shadow_map, sun_grid, sun_map, sun_pixels, sun_shading

LAMP_GRID = LAMP_MAP = 8


def view_surfaces(maker):
    maker.add_pass(
        "view_surfaces",
        "The first opaque surface in each pixel",
        milliseconds=3.1,
        state={"depth": "less, written"},
        draws=[{"mesh": "floor", "material": "chalk"}],
    )
    position = [v for x, y in pixels() for v in (floor_of_pixel(x, y)[0], 0, floor_of_pixel(x, y)[1], 1)]
    maker.write(
        "view_position",
        "position",
        (WIDTH, HEIGHT),
        position,
        XYZ + [COVERED],
        "xyz: position, metres, scene space; w: 1 where there is a surface, else 0",
    )
    maker.write(
        "view_normal",
        "normal",
        (WIDTH, HEIGHT),
        [v for _ in pixels() for v in (0, 1, 0, 3)],
        [{"name": n, "meaning": "unit normal", "unit": ""} for n in "xyz"]
        + [{"name": "w", "meaning": "depth along the camera's axis", "unit": "metres"}],
        "xyz: unit shading normal; w: depth, metres",
    )


def lamp_light(maker):
    """All by hand. (grid, map events, the light's entries.)"""
    maker.add_pass("caster_map[lamp]", "The nearest surface of the casters, seen from the light", light=1)
    entry = [v for j in range(8) for i in range(8) for v in (i / 8, 1, j / 8, 1)]
    entered = maker.write(
        "caster_position[lamp]",
        "position",
        (8, 8),
        entry,
        XYZ + [COVERED],
        "xyz: position, metres; w: 1 a front face",
    )
    maker.add_pass(
        "landing[lamp]",
        "Bends the light of each grid vertex and finds where it lands",
        light=1,
        reads=["caster_position[lamp]"],
    )
    landed = [v for j in range(8) for i in range(8) for v in (i / 4, 0, j / 4, 1)]
    landing = maker.write(
        "landing[lamp]",
        "status",
        (8, 8),
        landed,
        XYZ + [{"name": "w", "meaning": "status", "unit": ""}],
        "xyz: where the light lands, metres; w: status",
        codes={"3": STATUS},
    )
    maker.add_pass(
        "caustic_cells[lamp]",
        "Lays each cell into the caustic map",
        light=1,
        reads=["landing[lamp]"],
        state={"topology": "rectangles", "blend": "add"},
        draws=[{"mesh": None, "material": None}],
    )
    cell = lambda i, j: j * 7 + i
    events = {
        2 * 8 + 2: [(0, cell(1, 1), 0, 0, [6.0])],
        2 * 8 + 3: [(0, cell(2, 1), 0, 0, [3.0])],
        3 * 8 + 3: [(0, cell(4, 5), 0, 0, [1.0])],
        5 * 8 + 5: [(0, cell(4, 5), 0, 0, [2.0])],
        7 * 8
        + 7: [(0, cell(0, 0), 0, 0, [4.0]), (0, cell(1, 0), 0, 0, [0.5]), (0, cell(2, 0), 0, 0, [0.25])],
    }
    sums = [ball.total(event[4][0] for event in events.get(texel, [])) for texel in range(64)]
    mapped = maker.write(
        "caustic_map[lamp]",
        "flux",
        (8, 8),
        sums,
        [{"name": "r", "meaning": "flux in the texel", "unit": "sr"}],
        "r: flux in the texel, relative to the light's intensity",
    )
    history = maker.write_history((8, 8), events, [0.0], 1, "cell")
    return {
        "name": "lamp",
        "maps": [{"attachment": mapped, "histories": [history]}],
        "branches": [{"name": "", "landing": [landing], "entry": entered, "exit": None}],
    }


def lamp_pixels(maker, direct, caustic):
    """Pixel (2, 2) looks where four texels meet, (3, 2) between two, others at the middle of their own."""
    places = {(2, 2): (3, 3), (3, 2): (4, 2.5)}
    looks = []
    for x, y in pixels():
        u, v = places.get((x, y), (x + 0.5, y + 0.5))
        looks.append([(u / LAMP_MAP, v / LAMP_MAP)] if x < LAMP_MAP and y < LAMP_MAP else [])
    return pixel_table(maker.blobs, (WIDTH, HEIGHT), looks, direct, caustic)


def lamp_irradiance():
    """(direct, caustic) of every pixel, four channels each."""
    direct, caustic = [0] * (4 * WIDTH * HEIGHT), [0] * (4 * WIDTH * HEIGHT)
    for x, y, lux in ((2, 2, 200), (3, 2, 60), (3, 3, 20), (5, 5, 40), (7, 7, 95)):
        at = 4 * (y * WIDTH + x)
        direct[at : at + 3], caustic[at : at + 3] = [64] * 3, [lux] * 3
    return direct, caustic


def write_irradiance(maker, direct, caustic):
    alpha = [{"name": "a", "meaning": "0", "unit": ""}]
    maker.write(
        "direct",
        "radiance",
        (WIDTH, HEIGHT),
        direct,
        LUX + alpha,
        "rgb: direct irradiance after shadows, lux",
    )
    maker.write(
        "caustic", "radiance", (WIDTH, HEIGHT), caustic, LUX + alpha, "rgb: irradiance from caustics, lux"
    )


def finish_picture(maker, direct, caustic, number_of_run):
    maker.add_pass(
        "compose", "Puts the camera's picture together", reads=["direct", "caustic"], milliseconds=1.9
    )
    beauty = [
        v
        for at in range(0, len(direct), 4)
        for v in [(direct[at + c] + caustic[at + c]) * 0.2 for c in range(3)] + [1]
    ]
    for number, (x, y) in enumerate(pixels()):
        if sees_ball(x, y):
            beauty[4 * number : 4 * number + 3] = [2500, 3600, 4300]
    maker.write(
        "beauty",
        "radiance",
        (WIDTH, HEIGHT),
        beauty,
        [{"name": n, "meaning": "radiance towards the camera", "unit": "nit"} for n in "rgb"]
        + [{"name": "a", "meaning": "1", "unit": ""}],
        "rgb: radiance towards the camera, nit; a: 1",
    )
    maker.add_pass("glass", "What is seen through glass", reads=["beauty"], milliseconds=8.3)
    maker.write(
        "glass_way",
        "position",
        (WIDTH, HEIGHT),
        None,
        XYZ,
        "xyz: where the seen ray goes",
        left_out=f"it would add 40 MB; caustics render tiny.glb --dump DIR writes it {number_of_run}".strip(),
    )
    maker.add_pass("tone_map", "Turns radiance into values for a screen", reads=["beauty"], milliseconds=0.6)
    screen = [
        round(255 * min(1, v / 16000) ** (1 / 2.2))
        for at in range(0, len(beauty), 4)
        for v in beauty[at : at + 3]
    ]
    maker.write(
        "picture",
        "display",
        (WIDTH, HEIGHT),
        screen,
        [{"name": n, "meaning": "display value", "unit": ""} for n in "rgb"],
        "rgb: display values",
    )
    return screen


def recorded_ways(ways):
    """Every sixth vertex; the estimators' errors shrink as they would: squared, or by a factor."""
    vertices = [[i, j] for j in range(2, ball.GRID, 6) for i in range(2, ball.GRID, 6)]
    errors = {
        "secant": [0.5, 0.1, 4e-3, 6e-6, 1e-9],
        "newton": [0.5, 0.2, 0.05, 4e-3, 3e-5],
        "paper": [0.5, 0.2, 0.08, 0.03, 0.012],
    }
    return {
        "vertices": vertices,
        "estimators": {
            name: [recorded_way(ways[i, j], wrong) for i, j in vertices] for name, wrong in errors.items()
        },
    }


def recorded_way(way, errors):
    if way is None:
        return {"points": [], "iterates": [], "status": "no caster"}
    points = [
        {"at": way[0], "surface": "entry", "medium": "inside"},
        {"at": way[1], "surface": "exit", "medium": "outside"},
    ]
    if way[2] is None:
        return {"points": points, "iterates": [], "status": "total internal reflection"}
    points.append({"at": way[2], "surface": "landing", "medium": "outside"})
    to = ball.plus(way[2], way[1], -1.0)
    length = math.sqrt(ball.dot(to, to))
    iterates = [
        {
            "label": f"iterate {k + 1}",
            "at": ball.plus(way[1], to, 1 - error),
            "distance": length * (1 - error),
            "error": length * error,
        }
        for k, error in enumerate(errors)
    ]
    return {"points": points, "iterates": iterates, "status": "landed"}


def ledger():
    shares = [
        ("landed", "flux that lands on receivers", 0.871),
        ("fresnel", "mirrored at the surfaces", 0.083),
        ("absorbed", "taken by the glass", 0.021),
        ("outside", "left the receiver map's window", 0.0145),
        ("missed", "met no receiver", 0.0081),
        ("total internal reflection", "stays inside the body", 0.0024),
        ("not converged", "the search found no landing", 0.0),
        ("exit not found", "met no second surface", 0.0),
    ]
    lines = [{"account": name, "meaning": text, "flux": [share * 1.5] * 3} for name, text, share in shares]
    return [{"account": "entered", "meaning": "flux that enters the casters", "flux": [1.5] * 3}] + lines


def meshes(maker):
    positions, indices = ball.sphere_mesh()
    add = maker.blobs.add
    return [
        {
            "name": f"ball {SCRIPT}",
            "material": "glass",
            "role": "refractor",
            "positions": add("f32", positions),
            "indices": add("u32", indices),
        },
        {
            "name": "floor",
            "material": "chalk",
            "role": "receiver",
            "positions": add("f32", [-3, 0, -3, 3, 0, -3, 3, 0, 3, -3, 0, 3]),
            "indices": add("u32", [0, 1, 2, 0, 2, 3]),
        },
        {"name": "far wall", "material": "chalk", "role": "receiver", "positions": None, "indices": None},
    ]


def sweeps(maker, screen):
    dimmed = lambda k: maker.blobs.add("u8", [min(255, round(v * k)) for v in screen])
    return [
        {
            "setting": "iterations",
            "values": ["1", "2", "3", "5"],
            "width": WIDTH,
            "height": HEIGHT,
            "pictures": [dimmed(k) for k in (0.6, 0.8, 0.95, 1)],
            "error": [0.4, 0.11, 0.045, 0.04],
        },
        {
            "setting": "grid",
            "values": ["64", "128", "256"],
            "width": WIDTH,
            "height": HEIGHT,
            "pictures": [dimmed(k) for k in (0.7, 0.9, 1)],
            "error": [0.2, 0.06, None],
        },
    ]


def make_run(name, blobs, wrong=False):
    maker = RunMaker(name, blobs, {"grid": ball.GRID, "map": MAP}, WIDTH * HEIGHT)
    view_surfaces(maker)
    shadow_map(maker)
    ways, branch = sun_grid(maker, wrong)
    sums, mapped = sun_map(maker, ways)
    places = map_places()
    direct, caustic = sun_shading(maker, sums, places)
    if wrong:
        caustic[4 * (30 * WIDTH + 60)] += 512
    write_irradiance(maker, direct, caustic)
    read = sun_pixels(maker, places, direct, caustic)
    lamp = lamp_light(maker)
    maker.add_pass(
        "light_shading[lamp]",
        "What one light gives to the surfaces that the camera sees",
        light=1,
        reads=["view_position", "caustic_map[lamp]"],
        state={"blend": "add"},
        milliseconds=2.2,
    )
    of_lamp = lamp_irradiance()
    direct, caustic = ([a + b for a, b in zip(sun, lamp)] for sun, lamp in zip((direct, caustic), of_lamp))
    write_irradiance(maker, direct, caustic)
    screen = finish_picture(maker, direct, caustic, "")
    sun = {
        "index": 0,
        "name": "sun",
        "type": "directional",
        "intensity": 50000,
        "unit": "lux",
        "color": [1, 0.97, 0.9],
        "position": None,
        "direction": list(ball.LIGHT),
        "flux_unit": "m2 (lumen per lux)",
        "ledger": ledger(),
        "estimated_error": {"total": 0.041, "map": 0.012},
        "grid": ball.GRID,
        "branches": [branch],
        "maps": [mapped],
        "pixels": read,
        "paths": recorded_ways(ways),
    }
    maker.run["lights"] = [
        sun,
        {
            "index": 1,
            "type": "point",
            "intensity": 100,
            "unit": "candela",
            "color": [1, 1, 1],
            "position": [0, 3, 0],
            "direction": None,
            "flux_unit": "sr (lumen per candela)",
            "ledger": None,
            "estimated_error": None,
            "grid": LAMP_GRID,
            "pixels": lamp_pixels(maker, *of_lamp),
            "paths": None,
            **lamp,
        },
    ]
    maker.run["meshes"] = meshes(maker)
    maker.run["sweeps"] = sweeps(maker, screen) if not wrong else []
    return maker.run


def tiny_recording(runs=2):
    blobs = Blobs()
    made = [make_run("A", blobs)] + ([make_run("B", blobs, wrong=True)] if runs == 2 else [])
    return {"format": 1, "program": "caustics 0.1.0", "runs": made}, blobs
