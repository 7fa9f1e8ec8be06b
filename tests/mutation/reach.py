"""Which queries a source can have an effect on, and which tests are about it."""

import bisect
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
# Further files that answer or judge a query, and the folder in which all do.
ALSO = {"broad_phase": ("pair_history", "collider", "broad_phase_sequences"), "distance": ("collider",),
        "mass": ("motion/mass",), "bounds": ("hull/bounds",), "pixel": ("pixel/pixel",), "impulse": ("impulse_laws",),
        "constraint": ("constraint_motions",)}
JUDGED_IN = {"simulation": "properties/simulation/"}
PAIRS = ("warm", "cold")  # of bodies that are followed
STRATEGIES = ("all_pairs", "sweep_and_prune", "sweep_2d", "bsp", "octree", "uniform_grid", "hierarchical_hash",
              "wrapped_grid")
TEST_FOLDERS = {"fast": ("fast",), "reference": ("reference",), "judge": ("oracle", "properties")}
# About all of a group: what its answers, its work, its findings and its scenes were.
ABOUT_ALL = {"fast": ("marks_test", "pinned_answers_test", "fast_pairs_test"), "reference": ("pinned_answers_test",),
             "judge": ("allowances_test", "pinned_findings_test", "pinned_scenes_test")}


def listing(option, path):
    return subprocess.run(["readelf", option, "-W", str(path)], capture_output=True, text=True, check=True).stdout


def defined(path):
    """The external functions and tables that an object defines; weak ones are in every object that uses them."""
    rows = (line.split() for line in listing("-s", path).splitlines())
    return {row[7] for row in rows if len(row) > 7 and row[4] == "GLOBAL" and row[6].isdigit()}


def key(section):
    """A section by as much of its name as readelf says of one that has relocations."""
    return section[:251]


class Object:
    """The symbols of an object file, with their places, and what each of them refers to."""

    def __init__(self, path):
        self.path, self.places = path, collections.defaultdict(list)
        sections = {number: name for number, name in re.findall(r"^ +\[ *(\d+)\] (\S+)", listing("-S", path), re.MULTILINE)}
        self.local = set()
        for row in (line.split() for line in listing("-s", path).splitlines()):
            if len(row) > 7 and row[6].isdigit() and row[3] in ("FUNC", "OBJECT"):
                self.places[key(sections[row[6]])].append((int(row[1], 16), row[7]))
                if row[4] == "LOCAL":
                    self.local.add(row[7])
        for places in self.places.values():
            places.sort()

    def name(self, symbol):
        return (self.path, symbol) if symbol in self.local else symbol

    def at(self, section, offset):
        """The symbol that has this place, or None."""
        places = self.places.get(key(section), ())
        index = bisect.bisect_right(places, (offset, "\x7f")) - 1
        return self.name(places[index][1]) if index >= 0 else None

    def references(self):
        """(symbol, symbol that it refers to), over and over. A second name of one place refers to what at() returns."""
        for section, places in self.places.items():
            yield from ((self.name(symbol), self.at(section, offset)) for offset, symbol in places)
        section = ""
        for line in listing("-r", self.path).splitlines():
            if heading := re.match(r"Relocation section '\.rela(\S+)'", line):
                section = heading[1]
            elif row := re.match(r"([0-9a-f]{16})  \S+ +\S+ +\S+ (\S+) ([+-]) ([0-9a-f]+)$", line):
                target, addend = row[2], int(row[3] + row[4], 16)
                is_place = target.startswith(".")
                # A relative reference is counted from its end, 4 bytes on; a table's, which is absolute, is not, but
                # its addends are beginnings of functions, and these are at least 4 bytes long.
                yield self.at(section, int(row[1], 16)), self.at(target, addend + 4) if is_place else self.name(target)
        yield from self.calls_within_a_section()

    def calls_within_a_section(self):
        """The assembler resolves these, so they have no relocation."""
        words = ["objdump", "-d", "-r", "-w", "--no-show-raw-insn", str(self.path)]
        user = None
        for line in subprocess.run(words, capture_output=True, text=True, check=True).stdout.splitlines():
            if heading := re.match(r"[0-9a-f]+ <(\S+)>:$", line):
                user = self.name(heading[1])
            elif call := re.search(r"\t(?:call|j\w+|lea)\s.*<(\S+?)(?:\+0x[0-9a-f]+)?>$", line):
                yield user, self.name(call[1])


class Reach:
    """From the objects of the build folder: what is reached from the functions that answer or judge one query.
    `object_of(source)`: the object of the build folder; `alone(source)`: one of this source and no other."""

    def __init__(self, tree, object_of, alone):
        self.tree, self.alone, self.uses = tree, alone, collections.defaultdict(set)
        for path in sorted({str(object_of(path)) for path in tree.code if path.endswith(".cpp")}):
            if pathlib.Path(path).exists():
                for user, used in Object(path).references():
                    if user and used:  # else it is in a place without a symbol, which would connect all that has one
                        self.uses[user].add(used)

    @functools.lru_cache(maxsize=None)
    def symbols(self, source):
        return frozenset(defined(self.alone(source)))

    @functools.lru_cache(maxsize=None)
    def of_query(self, group, query):
        names = [f"{ROOTS[group]}{name}.cpp" for name in (query, *ALSO.get(query, ()))]
        if group == "judge" and query in JUDGED_IN:
            names += [name for name in self.tree.code if name.startswith(JUDGED_IN[query]) and name.endswith(".cpp")]
        return self.reached_from(tuple(name for name in names if name in self.tree.code))

    @functools.lru_cache(maxsize=None)
    def reached_from(self, sources):
        waiting = [symbol for source in sources for symbol in self.symbols(source)]
        seen = set(waiting)
        while waiting:
            for other in self.uses[waiting.pop()] - seen:
                seen.add(other)
                waiting.append(other)
        return seen

    def of_file(self, path):
        return {symbol for source in self.tree.sources_of(path) for symbol in self.symbols(source)}

    def further_subjects(self, path, query):
        """The subjects beside `fast` that answer the query by this file of fast: the strategies of the broad phase, and
        pairs that are followed."""
        if query == "broad_phase":
            return strategies(path) or (("warm",) if "collider" in path or "fast_pairs" in path else ())
        if path.startswith("oracle/subjects/touchstone/fast_pairs"):
            return PAIRS if query in ("distance", "penetration") else ()
        followed_by = {"distance": "fast/collider.cpp", "penetration": "fast/penetration.cpp"}.get(query)
        return PAIRS if followed_by and self.of_file(path) & self.reached_from((followed_by,)) else ()

    def queries(self, path):
        """The queries that reach a file, its own first. A judge's file that none reaches draws scenes or speaks with
        subjects, for all queries, or it makes failing scenes smaller, for none."""
        group = draws.group_of(path)
        defines = self.of_file(path)
        reached = [query for query in QUERIES if defines & self.of_query(group, query)]
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
    after a folder that it is in, those in the tests' folder of that name, and those that include its header."""
    parts = pathlib.PurePosixPath(path).with_suffix("").parts
    header = pathlib.PurePosixPath(path).with_suffix(".h").as_posix()
    for folder in TEST_FOLDERS[draws.group_of(path)]:
        names = []
        for test in sorted((pathlib.Path(root) / "tests" / folder).rglob("*_test.cpp")):
            about = test.stem.removesuffix("_test")
            places = test.relative_to(pathlib.Path(root) / "tests" / folder).parts[:-1]
            is_named = about in parts[1:] or (places and places[-1] in parts[1:-1])
            if is_named or re.search(rf'^#include "{re.escape(header)}"', test.read_text(), re.MULTILINE):
                names.append(test.stem)
        if names:
            yield folder, names
    about_all = [name for name in ABOUT_ALL.get(draws.group_of(path), ())
                 if any((pathlib.Path(root) / "tests/properties").rglob(f"{name}.cpp"))]
    if about_all:
        yield "properties", about_all
