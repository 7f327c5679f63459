"""caustics paper: rows made again, checked and reported."""

import json

from program import ProgramTest, main


class Paper(ProgramTest):
    def test_a_row_is_made_checked_and_reported(self):
        result = self.succeeds("paper", "-o", "out", "--row", "21")
        self.assertIn("holds", result.stdout)
        rows = json.loads((self.folder / "out/paper.json").read_text())["rows"]
        self.assertEqual([(r["row"], r["holds"]) for r in rows], [("21", True)])
        # The command is one that a person can type.
        self.assertTrue(rows[0]["commands"][0].startswith("caustics render scenes/glass_sphere.glb"))
        self.assertTrue((self.folder / "out/paper_weights.png").exists())
        self.assertIn("| 21 |", (self.folder / "out/paper.md").read_text())

    def test_an_unknown_row_is_refused_before_anything_is_made(self):
        self.fails(2, "paper", "-o", "out", "--row", "99", saying="there is no row '99'")
        self.assertFalse((self.folder / "out").exists())


if __name__ == "__main__":
    main()
