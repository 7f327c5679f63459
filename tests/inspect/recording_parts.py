"""A recording part by part, in the form in which the page reads it; and the barest one that there can be."""
from page_file import Blobs, hash_of

STATUS = [
    "no caster",
    "landed",
    "missed",
    "outside",
    "total internal reflection",
    "absorbed",
    "not converged",
    "exit not found",
    "stopped",
    "given up",
]
XYZ = [{"name": name, "meaning": "position", "unit": "metres"} for name in "xyz"]
COVERED = {"name": "w", "meaning": "1 where there is a surface", "unit": ""}
FLUX = [{"name": name, "meaning": "flux that is left", "unit": "m2"} for name in "rgb"]
LUX = [{"name": name, "meaning": "irradiance", "unit": "lux"} for name in "rgb"]


class RunMaker:
    """Collects passes and attachments in the order they ran. `pixels`: of the picture, in all."""

    def __init__(self, name, blobs, settings, pixels):
        self.pixels = pixels
        self.blobs = blobs
        self.run = {
            "name": name,
            "scene": "scenes/tiny <script>window.wasRun = true.glb",
            "device": "software, 8 lanes (avx2), 2 threads",
            "settings": settings,
            "notes": ["The floor is added: the scene has none."],
            "effects": [
                {"name": "hidden receivers", "active": False, "reason": "all receivers are one plane"},
                {"name": "casters", "active": True, "reason": "1 body of glass"},
            ],
            "passes": [],
            "attachments": [],
            "histories": [],
            "lights": [],
            "meshes": [],
            "sweeps": [],
            "skipped": [
                {"pass": "haze", "reason": "the scene has no medium"},
                {"pass": "water_step", "reason": "no water moves"},
            ],
            "left_out": [
                "Vertices between the recorded ones have no way here; caustics probe tiny.glb --texel X,Y "
                "shows any."
            ],
        }

    def add_pass(
        self, label, purpose, reads=(), light=None, milliseconds=1.0, state=None, draws=(), uniforms=()
    ):
        number = len(self.run["passes"])
        self.run["passes"].append(
            {
                "label": label,
                "name": label.split("[")[0],
                "purpose": purpose,
                "reason": "the picture needs it",
                "light": light,
                "milliseconds": milliseconds,
                "processor_milliseconds": 1.8 * milliseconds,
                "vertices": 6,
                "primitives": 2,
                "fragments": self.pixels,
                "samples_passed": self.pixels,
                "left_out": False,
                "reads": list(reads),
                "writes": [],
                "draws": list(draws),
                "uniforms": list(uniforms),
                "state": {
                    "topology": "triangles",
                    "depth": None,
                    "cull": None,
                    "blend": None,
                    **(state or {}),
                },
            }
        )
        return number

    def write(self, texture, kind, size, values, channels, meaning, codes=None, left_out=None):
        number = len(self.run["passes"]) - 1
        identity = len(self.run["attachments"])
        data = None
        if values is not None:
            data = self.blobs.add("u8" if kind == "display" else "f32", values)
        self.run["attachments"].append(
            {
                "id": identity,
                "pass": number,
                "texture": texture,
                "name": texture.split("[")[0],
                "format": "RGBA32F",
                "width": size[0],
                "height": size[1],
                "meaning": meaning,
                "kind": kind,
                "channels": channels,
                "codes": codes,
                "sha256": hash_of(values),
                "data": data,
                "left_out": left_out,
            }
        )
        self.run["passes"][number]["writes"].append(identity)
        return identity

    def write_history(self, size, events, before, channels, vertices_of, draws=False):
        """`events`: for each texel [(draw, primitive, outcome, depth, values)], in order. All go to one
        attachment."""
        starts, flat = [0], []
        for texel in range(size[0] * size[1]):
            flat += events.get(texel, [])
            starts.append(len(flat))
        attachment = self.run["passes"][-1]["writes"][0]
        self.run["histories"].append(
            {
                "pass": len(self.run["passes"]) - 1,
                "width": size[0],
                "height": size[1],
                "start": self.blobs.add("u32", starts),
                "draw": self.blobs.add("u16", [e[0] for e in flat]),
                "primitive": self.blobs.add("u32", [e[1] for e in flat]),
                "outcome": self.blobs.add("u8", [e[2] for e in flat]),
                "depth": self.blobs.add("f32", [e[3] for e in flat]) if draws else None,
                "values": {str(attachment): self.blobs.add("f32", [v for e in flat for v in e[4]])},
                "before": {str(attachment): before},
                "vertices_of": vertices_of,
                "cascade": False,
                "left_out": None,
            }
        )
        assert len(flat) == 0 or len(flat[0][4]) == channels
        return len(self.run["histories"]) - 1


def pixel_table(blobs, size, looks, direct, caustic):
    """What a light gives to each pixel. `looks`: by pixel [(u, v)] of the look-ups in map 0 that give it
    light, each worth one unit of irradiance for each unit of flux."""
    starts = [0]
    for pixel in looks:
        starts.append(starts[-1] + len(pixel))
    all_looks = [look for pixel in looks for look in pixel]
    return {
        "width": size[0],
        "height": size[1],
        "start": blobs.add("u32", starts),
        "samples": blobs.add("u8", [1] * len(looks)),
        "map": blobs.add("u8", [0] * len(all_looks)),
        "fetches": blobs.add("f32", [v for u, w in all_looks for v in (u, w, 1, 1)]),
        "direct": blobs.add("f32", direct),
        "caustic": blobs.add("f32", caustic),
    }


def bare_recording():
    """All that a page may leave out is left out."""
    left_out = "too large; caustics probe tiny.glb --history caustic_cells[sun]:X,Y shows one texel's"
    attachment = {
        "id": 0,
        "pass": 0,
        "texture": "caustic_map[sun]",
        "name": "caustic_map",
        "format": "R32F",
        "width": 8,
        "height": 8,
        "meaning": "r: flux",
        "kind": "flux",
        "channels": [],
        "codes": None,
        "sha256": "0",
        "data": None,
        "left_out": "too large",
    }
    one_pass = {
        "label": "caustic_cells[sun]",
        "name": "caustic_cells",
        "purpose": "",
        "reason": "",
        "light": 0,
        "milliseconds": None,
        "processor_milliseconds": None,
        "vertices": None,
        "primitives": None,
        "fragments": None,
        "samples_passed": None,
        "left_out": False,
        "reads": [],
        "writes": [0],
        "draws": [],
        "uniforms": [],
        "state": {"topology": "rectangles", "depth": None, "cull": None, "blend": "add"},
    }
    history = {
        "pass": 0,
        "width": 8,
        "height": 8,
        "start": None,
        "draw": None,
        "primitive": None,
        "outcome": None,
        "depth": None,
        "values": {},
        "before": {},
        "vertices_of": "cell",
        "cascade": False,
        "left_out": left_out,
    }
    light = {
        "index": 0,
        "name": "sun",
        "type": "directional",
        "intensity": 1,
        "unit": "lux",
        "color": [1, 1, 1],
        "position": None,
        "direction": None,
        "flux_unit": "m2",
        "ledger": None,
        "estimated_error": None,
        "grid": 8,
        "branches": [{"name": "", "landing": [], "entry": None, "exit": None}],
        "maps": [{"attachment": 0, "histories": [0]}],
        "pixels": None,
        "paths": None,
    }
    run = {
        "name": "A",
        "scene": "bare.glb",
        "device": "software",
        "settings": {},
        "notes": [],
        "effects": [],
        "passes": [one_pass],
        "skipped": [],
        "attachments": [attachment],
        "histories": [history],
        "lights": [light],
        "meshes": [
            {"name": "ball", "material": "glass", "role": "refractor", "positions": None, "indices": None}
        ],
        "sweeps": [],
        "left_out": ["Pictures at other settings; caustics inspect tiny.glb --sweep makes them."],
    }
    return {"format": 1, "program": "caustics 0.1.0", "runs": [run]}, Blobs()
