"""Files that are no scenes: exit code 3, one line, and nothing written."""

import json

import glb
from program import SMALL, ProgramTest, main


class BadInput(ProgramTest):
    def refuses(self, name, content, saying=""):
        (self.folder / name).write_bytes(content)
        self.fails(3, name, *SMALL, saying=saying)
        self.fails(3, "plan", name, saying=name)

    def test_missing_file(self):
        self.fails(3, "nothing.glb", saying="nothing.glb")

    def test_folder(self):
        (self.folder / "folder.glb").mkdir()
        self.fails(3, "folder.glb")

    def test_empty(self):
        self.refuses("empty.glb", b"")
        self.refuses("empty.gltf", b"")

    def test_truncated_everywhere(self):
        whole = glb.scene()
        for length in (4, 11, 12, 19, 40, len(whole) // 2, len(whole) - 1):
            self.refuses("cut.glb", whole[:length])

    def test_wrong_json(self):
        self.refuses("wrong.gltf", b"{")
        self.refuses("wrong.gltf", b"[]")
        self.refuses("wrong.gltf", b'{"asset": 7}')
        self.refuses("wrong.glb", glb.pack({"asset": {"version": "1.0"}}))

    def test_text_that_is_no_scene(self):
        self.refuses("text.glb", b"This is a letter, and not a scene at all.\n" * 40)

    def test_unknown_required_extension_is_named(self):
        document = {"asset": {"version": "2.0"}, "extensionsUsed": ["KHR_draco_mesh_compression"],
                    "extensionsRequired": ["KHR_draco_mesh_compression"]}
        self.refuses("draco.gltf", json.dumps(document).encode(), "KHR_draco_mesh_compression")

    def test_environment(self):
        self.fails(3, "ball.glb", "--environment", "missing.hdr", saying="missing.hdr")
        (self.folder / "bad.hdr").write_bytes(b"no picture")
        self.fails(3, "ball.glb", "--environment", "bad.hdr", saying="bad.hdr")


class Reasons(ProgramTest):
    """Why there is no caustic: said by plan, and by render's closing lines."""

    def expectation(self, material=None, light=None, options=()):
        (self.folder / "case.glb").write_bytes(glb.scene(material, light))
        document = json.loads(self.succeeds("plan", "case.glb", "--json", *options).stdout)
        self.assertEqual(len(document["expectations"]), 1)
        return document["expectations"][0]

    def test_solid_glass(self):
        self.assertTrue(self.expectation()["expected"])

    def test_thin_glass(self):
        thin = self.expectation(glb.glass())
        self.assertFalse(thin["expected"])
        self.assertIn("thin wall", thin["reason"])
        self.assertIn("--assume-solid", thin["reason"])
        self.assertTrue(self.expectation(glb.glass(), options=["--assume-solid"])["expected"])

    def test_rough_glass(self):
        rough = glb.glass(thicknessFactor=1)
        rough["pbrMetallicRoughness"]["roughnessFactor"] = 0.4
        self.assertIn("roughness 0.4", self.expectation(rough)["reason"])

    def test_ior_that_never_refracts(self):
        solid = glb.glass(thicknessFactor=1)
        solid["extensions"]["KHR_materials_ior"]["ior"] = 0
        self.assertIn("never refracts", self.expectation(solid)["reason"])

    def test_mirror(self):
        mirror = {"name": "steel",
                  "pbrMetallicRoughness": {"metallicFactor": 1, "roughnessFactor": 0.05}}
        self.assertIn("mirrored onto what stands around", self.expectation(mirror)["reason"])

    def test_light_without_intensity(self):
        dark = self.expectation(light={"type": "directional", "intensity": 0})
        self.assertFalse(dark["expected"])

    def test_narrow_spot_that_looks_elsewhere(self):
        spot = {"type": "spot", "intensity": 100, "spot": {"outerConeAngle": 0.5}}
        self.assertTrue(self.expectation(light=spot)["expected"])


if __name__ == "__main__":
    main()
