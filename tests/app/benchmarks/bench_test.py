"""touchstone bench: bad input, and a tiny comparison if its program was built."""

import pathlib
import unittest

from program import PROGRAM, Test

BUILT = (pathlib.Path(PROGRAM).parent.parent / "tests/bench/touchstone_broad_phase_bench").exists()


class Bench(Test):
    def test_bad_input_is_told_and_nothing_is_written(self):
        for words in (["nothing"], ["broad_phase", "--rounds", "0"], ["broad_phase", "--sizes", "-5"],
                      ["broad_phase", "--sizes", "10;ls"], ["broad_phase", "--workloads", ""]):
            done = self.run_program("bench", *words)
            self.assertEqual(done.returncode, 2, words)
            self.assertTrue(done.stderr, words)

    def test_help_teaches(self):
        done = self.run_program("bench", "--help")
        self.assertEqual(done.returncode, 0)
        self.assertIn("Examples:", done.stdout)

    @unittest.skipIf(BUILT, "the comparison is there")
    def test_a_comparison_that_was_not_built_says_so(self):
        done = self.run_program("bench", "broad_phase")
        self.assertEqual(done.returncode, 2)
        self.assertIn("was not built", done.stderr)

    @unittest.skipUnless(BUILT, "a build without benchmarks")
    def test_a_tiny_comparison(self):
        done = self.run_program("bench", "broad_phase", "--sizes", "50,100", "--workloads", "coherent,settled",
                                "--rounds", "1", "--out", "here")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("How many times faster", done.stdout)
        for name in ("broad_phase.csv", "broad_phase.txt", "broad_phase.svg"):
            self.assertTrue((self.folder / "here" / name).read_text())

    @unittest.skipUnless(BUILT, "a build without benchmarks")
    def test_an_unknown_workload_is_told_the_known_ones(self):
        done = self.run_program("bench", "broad_phase", "--workloads", "chaos")
        self.assertEqual(done.returncode, 2)
        self.assertIn("coherent", done.stderr)


if __name__ == "__main__":
    unittest.main()
