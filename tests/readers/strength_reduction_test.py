"""scripts/strength-reduction finds a known factor of safety with settle-mpm, whose body moves when it fails."""

import pathlib
import re
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCRIPT = ROOT / "scripts" / "strength-reduction"
SOLVER = ""


def search(*arguments):
    return subprocess.run([sys.executable, SCRIPT, ROOT / "cases/soils/slope.toml", "--solver", SOLVER,
                           "--set=mpm.element_size=1", "--within=0.02", *arguments], capture_output=True, text=True, check=False)


class StrengthReduction(unittest.TestCase):
    def test_growth_of_the_settlement_tells_the_factor_of_a_slope(self):
        run = search("--from=1.2", "--to=1.6", "--growth=3")
        self.assertEqual(run.returncode, 0, run.stderr)
        low, high = map(float, re.search(r"factor of safety: (\S+) to (\S+)", run.stdout).groups())
        # 1.38 by charts (Bishop & Morgenstern 1960); elements of 1 m find 1.41 to 1.42
        self.assertLess(abs((low + high) / 2 - 1.38), 0.04 * 1.38)

    def test_without_it_a_slope_that_has_slid_stands(self):
        run = search("--from=1.2", "--to=1.5")
        self.assertEqual(run.returncode, 1)
        self.assertIn("it stands at F = 1.5", run.stderr)

    def test_a_growth_of_one_is_refused(self):
        run = search("--growth=1")
        self.assertEqual(run.returncode, 2)
        self.assertIn("--growth > 1", run.stderr)


if __name__ == "__main__":
    SOLVER = sys.argv.pop(1)
    unittest.main()
