"""benchmark_figures_test.py SETTLE_MPM SOURCES: whole runs are measured, and their figures drawn."""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

try:
    import matplotlib  # noqa: F401
except ImportError:
    print("skipped: python3-matplotlib is not installed")
    sys.exit(77)

programs, bench = pathlib.Path(sys.argv[1]).parent, pathlib.Path(sys.argv[2]) / "bench"

# Two sizes of one space, the first one measured three times, and the memory.
steps = {"context": {"num_cpus": 2}, "benchmarks": [
    {"name": "triad/threads:1/real_time", "run_type": "iteration", "bytes": 2.16e10},
    {"name": "one_phase<TriangleSpace, mixed>/side:41/phase:2", "run_type": "iteration", "updates": 8e7},
    *({"name": "whole_step<TriangleSpace, mixed>/side:6/threads:1/real_time", "run_type": "iteration",
       "points": 216.0, "updates": updates} for updates in (1e7, 4e7, 3e7)),
    {"name": "whole_step<TriangleSpace, mixed>/side:41/threads:1/real_time", "run_type": "iteration",
     "points": 10086.0, "updates": 5e7}]}


def call(script, *arguments):
    return subprocess.run([sys.executable, "-B", bench / script, *arguments], capture_output=True, text=True)


class Benchmarks(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_whole_runs_count_updates_of_the_points_that_are_there(self):
        file = self.folder / "runs.json"
        done = call("whole-runs", "mpm", "--programs", programs, "--sizes", "600", "--set",
                    "mpm.quasi_static.increments=2", "--json", file)
        self.assertEqual(done.returncode, 0, done.stderr)
        (run,) = json.loads(file.read_text())["runs"]
        self.assertEqual(run["size"], 600)
        self.assertEqual(run["steps"], 5 * 2)
        updates = 2 * 600 * (1 + 2 + 3 + 4 + 5) / 5  # of two increments a layer
        self.assertGreater(run["updates_per_second"], updates / run["seconds"])  # which is of the whole process

    def test_a_page_has_the_medians(self):
        file, page = self.folder / "steps.json", self.folder / "page.html"
        file.write_text(json.dumps(steps))
        done = call("figures", file, "--out", page)
        self.assertEqual(done.returncode, 0, done.stderr)
        text = page.read_text()
        self.assertIn("<svg", text)
        self.assertIn("21.6 GB/s", text)
        self.assertIn("<td>12.5</td>", text)  # ns a point of the phase that moves them

    def test_a_file_of_something_else_is_refused(self):
        file = self.folder / "other.json"
        file.write_text("{}")
        done = call("figures", file, "--out", self.folder / "page.html")
        self.assertEqual(done.returncode, 1)
        self.assertIn("other.json", done.stderr)
        self.assertFalse((self.folder / "page.html").exists())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
