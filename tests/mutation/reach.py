"""Which queries a source can have an effect on, and which tests are about it."""

import collections
import functools
import pathlib
import re
import subprocess

import draws

# The cheap ones first.
QUERIES = ("mass", "bounds", "broad_phase", "pixel", "distance", "penetration", "impulse", "time_of_impact",
           "constraint", "simulation")
ROOTS = {"fast": "fast/", "reference": "reference/", "judge": "properties/"}
ALSO = {"broad_phase": ("pair_history", "broad_phase_sequences")}  # files that answer or judge the same query
STRATEGIES = ("all_pairs", "sweep_and_prune", "sweep_2d", "bsp", "octree", "uniform_grid", "hierarchical_hash",
              "wrapped_grid")
TEST_FOLDERS = {"fast": ("fast",), "reference": ("reference",), "judge": ("oracle", "properties")}
# About all of a group. Of fast: what exact arithmetic repairs changes no answer, but costs more. Of the judge: an
# allowance that is too wide accuses nobody.
ABOUT_ALL = {"fast": "marks_test", "judge": "allowances_test"}


def symbols(objects):
    """(defined, needed) names of each object file; weak names are in every object that uses them."""
    listed = subprocess.run(["nm", "-AP", *map(str, objects)], capture_output=True, text=True, check=True).stdout
    defined, needed = collections.defaultdict(set), collections.defaultdict(set)
    for line in listed.splitlines():
        path, _, rest = line.partition(": ")
        name, kind = rest.split()[:2]
        (needed if kind == "U" else defined if kind in "TDBR" else {}).setdefault(path, set()).add(name)
    return defined, needed


class Reach:
    """From the objects of the build folder: what the linker would take into a program that asks one query."""

    def __init__(self, tree, object_of):
        self.tree = tree
        self.objects = {path: str(object_of(path)) for path in tree.code if path.endswith(".cpp")}
        defined, needed = symbols(path for path in self.objects.values() if pathlib.Path(path).exists())
        definer = {name: path for path, names in defined.items() for name in names}
        self.uses = {path: {definer[name] for name in needed[path] if name in definer} for path in self.objects.values()}

    @functools.lru_cache(maxsize=None)
    def of_query(self, group, query):
        names = [f"{ROOTS[group]}{name}.cpp" for name in (query, *ALSO.get(query, ()))]
        waiting = [self.objects[name] for name in names if name in self.objects]
        seen = set(waiting)
        while waiting:
            for other in self.uses[waiting.pop()] - seen:
                seen.add(other)
                waiting.append(other)
        return seen

    def queries(self, path):
        """The queries that reach a file, its own first. A judge's file that none reaches draws scenes or speaks with
        subjects, for all queries, or it makes failing scenes smaller, for none."""
        group = draws.group_of(path)
        sources = {self.objects[source] for source in self.tree.sources_of(path)}
        reached = [query for query in QUERIES if sources & self.of_query(group, query)]
        serves_all = group == "judge" and not reached and not path.startswith("oracle/minimise/")
        if path.startswith("oracle/subjects/") or serves_all:
            reached = [query for query in QUERIES if self.of_query(group, query)]
        return sorted(reached, key=lambda query: own_query(path) != query)


def own_query(path):
    """The query that a file's name or folder says; None if it serves several."""
    parts = pathlib.PurePosixPath(path).with_suffix("").parts[1:]
    for part in parts:
        for query in QUERIES:
            if part == query or part.startswith(query + "_"):
                return query
    return None


def folder_of(path):
    return path.rsplit("/", 1)[0]


def strategies(path):
    """The broad phases beside the default one that a file of fast/broad_phase is a part of."""
    if not path.startswith(("fast/broad_phase/", "oracle/subjects/touchstone/fast_strategies")):
        return ()
    name = pathlib.PurePosixPath(path).stem
    return (name,) if name in STRATEGIES else STRATEGIES


def tests_of(root, path):
    """(folder of tests/, names of its sources) for each folder that has tests of a file: those that are named after it or
    its folder, and those that include its header."""
    parts = pathlib.PurePosixPath(path).with_suffix("").parts
    header = pathlib.PurePosixPath(path).with_suffix(".h").as_posix()
    for folder in TEST_FOLDERS[draws.group_of(path)]:
        names = []
        for test in sorted((pathlib.Path(root) / "tests" / folder).rglob("*_test.cpp")):
            about = test.stem.removesuffix("_test")
            places = test.relative_to(pathlib.Path(root) / "tests" / folder).parts[:-1]
            is_named = about in parts[1:] or (places and places[-1] == parts[-2])
            if is_named or re.search(rf'^#include "{re.escape(header)}"', test.read_text(), re.MULTILINE):
                names.append(test.stem)
        if names:
            yield folder, names
    about_all = ABOUT_ALL.get(draws.group_of(path))
    if any((pathlib.Path(root) / "tests/properties").rglob(f"{about_all}.cpp")):
        yield "properties", [about_all]
