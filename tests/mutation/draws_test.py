"""Draws are a function of the source and the seed; a header counts with the sources that include it."""

import itertools
import pathlib
import tempfile
import types
import unittest

import draws

PINNED = [0.7148419663873945, 0.5505740180299228]

FILES = {
    "fast/mass.cpp": '#include "fast/mass.h"\n' + "int a;\n" * 30, "fast/mass.h": '#include "fast/deep.h"\nint b;\n',
    "fast/deep.h": "// words\nint c;\n", "fast/bounds.cpp": '#include "fast/deep.h"\n' + "int d;\n" * 10,
    "reference/mass.cpp": "int e;\n", "oracle/judge.cpp": "int f;\n", "properties/mass.cpp": "int g;\n",
    "oracle/subjects/ode/ode.cpp": "int h;\n", "oracle/subjects/touchstone/fast.cpp": '#include "fast/mass.h"\nint i;\n',
}


def tree_of(files):
    with tempfile.TemporaryDirectory() as folder:
        for name, text in files.items():
            path = pathlib.Path(folder) / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        return draws.SourceTree(folder)


def mutants_of(path):
    return [types.SimpleNamespace(id=f"{path} {number}", path=path) for number in range(40)]


def taken(tree, count, seed, groups=draws.TURNS):
    found = draws.draws(tree, mutants_of, seed, groups)
    return [next(found) for _ in range(count)]


class Draws(unittest.TestCase):
    def setUp(self):
        self.tree = tree_of(FILES)

    def test_the_same_seed_gives_the_same_sample_and_a_smaller_one_begins_it(self):
        self.assertEqual(taken(self.tree, 60, 1), taken(self.tree, 60, 1))
        self.assertEqual(taken(self.tree, 60, 1)[:20], taken(self.tree, 20, 1))
        self.assertNotEqual(taken(self.tree, 20, 1), taken(self.tree, 20, 2))

    def test_these_are_the_first_draws_of_seed_1(self):
        """A regression pin: another version of Python must draw alike."""
        self.assertEqual([draws.fraction(1, number, "file") for number in (0, 1)], PINNED)

    def test_no_mutant_is_drawn_twice_and_draws_end_when_there_are_no_more(self):
        every = [mutant.id for mutant in draws.draws(self.tree, mutants_of, 1)]
        self.assertEqual(len(every), len(set(every)))
        self.assertGreater(len(every), 0.9 * 40 * 8)

    def test_half_of_the_draws_are_of_fast_and_a_file_has_its_share_of_the_code(self):
        found = [mutant.path for mutant in taken(self.tree, 80, 3)]
        self.assertAlmostEqual(sum(draws.group_of(path) == "fast" for path in found), 40, delta=3)
        self.assertGreater(found.count("fast/mass.cpp"), found.count("fast/bounds.cpp"))

    def test_groups(self):
        self.assertEqual([draws.group_of(path) for path in FILES],
                         ["fast"] * 4 + ["reference", "judge", "judge", None, "fast"])
        self.assertIsNone(draws.group_of("app/main.cpp"))
        self.assertEqual({mutant.path for mutant in taken(self.tree, 10, 1, ("reference",))}, {"reference/mass.cpp"})

    def test_the_draws_of_some_files_are_those_of_all_and_no_other_file_is_read(self):
        is_wanted = lambda path: path.startswith("fast/")  # noqa: E731
        read = []
        some = draws.draws(self.tree, lambda path: read.append(path) or mutants_of(path), 1, is_wanted=is_wanted)
        every = draws.draws(self.tree, mutants_of, 1)
        self.assertEqual([next(some).id for _ in range(20)],
                         [mutant.id for mutant in itertools.islice(filter(lambda m: is_wanted(m.path), every), 20)])
        self.assertTrue(all(map(is_wanted, read)))

    def test_a_header_is_built_with_the_sources_that_include_it(self):
        self.assertEqual(self.tree.sources_of("fast/deep.h"),
                         ["fast/bounds.cpp", "fast/mass.cpp", "oracle/subjects/touchstone/fast.cpp"])
        self.assertEqual(self.tree.sources_of("fast/mass.cpp"), ["fast/mass.cpp"])

    def test_a_header_of_many_sources_is_left_out(self):
        many = {f"fast/x{number}.cpp": '#include "fast/deep.h"\nint x;\n' for number in range(draws.MOST_USERS)}
        tree = tree_of({**FILES, **many})
        self.assertNotIn("fast/deep.h", tree.files("fast"))
        self.assertEqual(tree.headers_left_out(), ["fast/deep.h"])

    def test_only_code_counts(self):
        self.assertEqual(draws.lines_of_code("// words\n\n#include <x>\nint a;\n  return;\n"), 2)


unittest.main()
