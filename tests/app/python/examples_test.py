"""The script of resources/examples ends in a picture, and the code of the module's page runs."""

import os
import pathlib
import re
import subprocess
import sys
import unittest

from program import CLI, InFolder

EXAMPLE = os.environ["HEXODERM_EXAMPLE"]
PAGE = pathlib.Path(os.environ["HEXODERM_SOURCE_DIR"]) / "app/python/README.md"


class Examples(InFolder):
    def test_the_script_ends_in_a_picture(self):
        import matplotlib.image

        result = subprocess.run([sys.executable, EXAMPLE, self.folder / "skin.png"], capture_output=True, text=True,
                                env={**os.environ, "MPLCONFIGDIR": str(self.folder)})
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("4 poses: Good", result.stdout)
        picture = matplotlib.image.imread(self.folder / "skin.png")
        self.assertEqual(picture.shape[:2], (600, 1320))
        # The left half has the cells, in many colours.
        colors = {tuple(pixel) for pixel in (picture[150:450, 100:500] * 255).astype(int).reshape(-1, picture.shape[2])}
        self.assertGreater(len(colors), 30)

    def test_the_page_runs_from_top_to_bottom(self):
        # Code, and what it prints.
        blocks = re.findall(r"```python\n(.*?)```\n\n```\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)
        self.assertGreater(len(blocks), 4)
        program = "\n".join(code for code, _ in blocks)
        subprocess.run([CLI, "simulate", "--poses", "3", "-o", self.folder / "arm.session.json"], check=True,
                       capture_output=True)
        result = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, cwd=self.folder)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stdout, "".join(printed for _, printed in blocks))
