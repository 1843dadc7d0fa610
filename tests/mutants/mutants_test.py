"""mutants_test.py SOURCES: the list of defects fits the sources; one that does not is named; two calls do not meet."""
import fcntl
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

sources = pathlib.Path(sys.argv[1])


def run(folder, *arguments):
    return subprocess.run([sys.executable, "-B", folder / "scripts" / "mutants", *arguments], capture_output=True, text=True)


class Mutants(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.addCleanup(self.scratch.cleanup)
        self.folder = pathlib.Path(self.scratch.name).resolve()
        (self.folder / "scripts").mkdir()
        shutil.copy(sources / "scripts" / "mutants", self.folder / "scripts")
        (self.folder / "tests" / "mutants").mkdir(parents=True)
        (self.folder / "code.cpp").write_text("a + b; a - b; a - b;")

    def list(self, *texts):
        entries = [f"[defect-{i}]\nmeans = ''\nfile = 'code.cpp'\ntext = '{text}'\ndefect = ''\n" for i, text in enumerate(texts)]
        (self.folder / "tests" / "mutants" / "part.toml").write_text("\n".join(entries))

    def test_the_list_fits_the_sources(self):
        done = run(sources, "--check")
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_texts_that_are_not_found_once_are_named(self):
        self.list("a + b", "a - b", "a * b")
        done = run(self.folder, "--check")
        self.assertEqual(done.returncode, 2)
        self.assertNotIn("defect-0", done.stderr)
        self.assertIn("part/defect-1: its text is found 2 times in code.cpp, not once", done.stderr)
        self.assertIn("part/defect-2: its text is found 0 times in code.cpp, not once", done.stderr)

    def test_a_second_call_is_refused_while_the_first_one_runs(self):
        lock = self.folder / "build" / "mutants" / "lock"
        lock.parent.mkdir(parents=True)
        with lock.open("w") as held:
            fcntl.flock(held, fcntl.LOCK_EX)
            held.write("4711")
            held.flush()
            done = run(self.folder)
        self.assertEqual(done.returncode, 2)
        self.assertIn("another call works on", done.stderr)
        self.assertIn("(process 4711); wait for it to end", done.stderr)
        self.assertEqual(lock.read_text(), "4711")


unittest.main(argv=sys.argv[:1])
