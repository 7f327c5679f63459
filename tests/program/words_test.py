"""What a command says in words is what it says in JSON: plan's passes, probe's histories, and how many meshes
throw no caustic."""

import json
import re

import glb
from program import SMALL, ProgramTest, main

FORMATS = re.compile(r"(\S.*?) (R32F|RG32F|RGBA32F|RGBA8|Depth32F)(?:, |$)")


def veiled(place):
    """The ball of glass above its floor, and there a pane that is blended."""
    document, blob = glb.unpack(glb.scene())
    veil = {"name": "veil", "alphaMode": "BLEND",
            "pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 0.5], "metallicFactor": 0}}
    document["materials"].append(veil)
    document["meshes"].append({"primitives": [document["meshes"][1]["primitives"][0] | {"material": 2}]})
    document["nodes"].append({"name": "veil", "mesh": 2, "translation": place})
    document["scenes"][0]["nodes"].append(len(document["nodes"]) - 1)
    return glb.pack(document, blob)


class Words(ProgramTest):
    def setUp(self):
        super().setUp()
        # One scene's pane lies below its floor; in another a second floor keeps the light from the ball.
        for name, data in (("veiled", veiled([0, -1, 0])), ("tinted", veiled([0, 1.8, 0])),
                           ("dark", glb.scene(floors=((0, 0, 0), (0, 2, 0))))):
            (self.folder / (name + ".glb")).write_bytes(data)

    def both(self, *arguments):
        """The words and the document of a command."""
        return (self.succeeds(*arguments).stdout,
                json.loads(self.succeeds(*arguments, "--json").stdout))

    def test_plan_names_every_texture_that_a_pass_writes_with_its_format(self):
        for scene in ("ball.glb", "tinted.glb", "dark.glb"):
            text, document = self.both("plan", scene, *SMALL)
            listed = text[text.index("\npasses "):text.index("\nnot run")].splitlines()[2:]
            told = [FORMATS.findall(after.strip().removeprefix("writes ").replace("[sun]", ""))
                    for after in listed if after.strip().startswith("writes ")]
            # The only light is named in words, and numbered in JSON.
            written = [[(each["name"].replace("[0]", ""), each["format"]) for each in p["writes"]]
                       for p in document["passes"]]
            self.assertGreater(len(written), 20)
            self.assertEqual(told, written, scene)
            self.assertEqual([line.split("  ")[1].strip() for line in listed if line[2:3] not in ("", " ")],
                             [p["pass"] for p in document["passes"]])

    def test_probe_counts_the_fragments_of_a_history_and_says_why_a_pass_drew_nothing(self):
        why = {False: "no light comes here", True: "the picture has no such layer of blended surfaces"}
        drawn, left_out = 0, set()
        for scene in ("veiled.glb", "dark.glb"):
            plan = json.loads(self.succeeds("plan", scene, *SMALL, "--json").stdout)
            asked = [word for p in plan["passes"] if re.search(r"caustic_|landing|layer|shading", p["pass"])
                     for word in ("--history", p["pass"] + ":9,9")]
            text, document = self.both("probe", scene, *SMALL, *asked)
            counts = r"^(\d+) fragments?, of which (\d+) passed(?:: the pass drew nothing: (.*))?$"
            told = re.findall(counts, text, re.MULTILINE)
            self.assertEqual(len(told), len(document["texels"]))
            for (count, passed, reason), texel in zip(told, document["texels"]):
                outcomes = [fragment["outcome"] for fragment in texel["fragments"]]
                self.assertEqual((int(count), int(passed)), (len(outcomes), outcomes.count("passed")))
                is_layer = ".layer" in texel["pass"]
                self.assertEqual(reason, why[is_layer] if texel["left_out"] else "", texel["pass"])
                drawn += len(outcomes)
                if texel["left_out"]:
                    left_out.add(is_layer)
        self.assertGreater(drawn, 0)
        self.assertEqual(left_out, {False, True})

    def test_one_of_the_meshes_without_a_caustic_is_named_and_the_others_are_counted(self):
        thin, blob = glb.unpack(glb.scene(glb.glass()))
        for balls in (1, 2, 5):
            names = [f"ball {n}" for n in range(balls)]
            document = thin | {"nodes": thin["nodes"][1:] + [
                {"name": name, "mesh": 0, "translation": [n % 3, 0, -(n // 3)]}
                for n, name in enumerate(names)]}
            document["scenes"] = [{"nodes": list(range(len(document["nodes"])))}]
            (self.folder / "thin.glb").write_bytes(glb.pack(document, blob))
            said = re.search(r"^caustic: none; '(.*?)'(?: and (\d+) more)?: thin wall",
                             self.succeeds("thin.glb", *SMALL).stderr, re.MULTILINE)
            self.assertEqual((said[1], int(said[2] or 0)), ("ball 0", balls - 1))
            plan = json.loads(self.succeeds("plan", "thin.glb", *SMALL, "--json").stdout)
            without = {e["mesh"] for e in plan["expectations"] if not e["expected"]}
            self.assertEqual(len(without), balls)


if __name__ == "__main__":
    main()
