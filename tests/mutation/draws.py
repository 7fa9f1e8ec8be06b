"""Which mutants are tried: draws that depend on the source and on a seed, and on nothing else.

A draw takes a file in proportion to its lines of code, and one of its mutants evenly. So only the files that are drawn
need be read by libclang, which takes a few seconds a file. A smaller sample is the beginning of a greater one."""

import hashlib
import pathlib
import re

# fast has about half of the code; the judge is what asks, compares and draws scenes.
GROUPS = {"fast": ("fast/", "oracle/subjects/touchstone/fast"),
          "reference": ("reference/", "oracle/subjects/touchstone/reference"),
          "judge": ("oracle/", "properties/")}
TURNS = ("fast", "reference", "fast", "judge")

# Adapters of other engines, and subjects that are wrong on purpose: they are accused, they do not judge.
LEFT_OUT = re.compile(r"oracle/subjects/(?!touchstone/)")

# A mutant in a header is built with all sources that include it. Headers with more of them would take minutes.
MOST_USERS = 6


def group_of(path):
    if LEFT_OUT.match(path):
        return None
    for group, beginnings in GROUPS.items():
        if path.startswith(beginnings):
            return group
    return None


def lines_of_code(text):
    lines = (line.strip() for line in text.splitlines())
    return sum(1 for line in lines if line and not line.startswith(("//", "#")))


class SourceTree:
    """The sources that may be mutated, what they include, and how much code they have."""

    def __init__(self, root):
        self.root = pathlib.Path(root)
        paths = [path for folder in ("fast", "oracle", "properties", "reference")
                 for path in sorted((self.root / folder).rglob("*")) if path.suffix in (".cpp", ".h")]
        texts = {path.relative_to(self.root).as_posix(): path.read_text() for path in paths}
        self.included = {path: [name for name in re.findall(r'^#include "([^"]+)"', text, re.MULTILINE) if name in texts]
                         for path, text in texts.items()}
        self.code = {path: lines_of_code(text) for path, text in texts.items() if group_of(path)}

    def reached(self, path):
        """The files that a file includes, directly or not."""
        seen, waiting = set(), [path]
        while waiting:
            for name in self.included[waiting.pop()]:
                if name not in seen:
                    seen.add(name)
                    waiting.append(name)
        return seen

    def sources_of(self, path):
        """The sources that are compiled again if a file changes: those of its group that include it."""
        if path.endswith(".cpp"):
            return [path]
        group = group_of(path)
        return sorted(other for other in self.code
                      if other.endswith(".cpp") and group_of(other) == group and path in self.reached(other))

    def files(self, group):
        return [path for path in sorted(self.code)
                if group_of(path) == group and 0 < len(self.sources_of(path)) <= MOST_USERS]

    def headers_left_out(self):
        return [path for path in sorted(self.code) if len(self.sources_of(path)) > MOST_USERS]


def fraction(seed, number, what):
    """A number in [0, 1) that any version of Python gives alike."""
    digest = hashlib.sha256(f"{seed} {number} {what}".encode()).digest()
    return int.from_bytes(digest[:8], "big") / 2**64


def file_at(tree, files, part):
    """The file in which this part of all lines of code ends."""
    left = part * sum(tree.code[path] for path in files)
    for path in files:
        left -= tree.code[path]
        if left < 0:
            return path
    return files[-1]


def draws(tree, mutants_of, seed, groups=TURNS, is_wanted=lambda path: True):
    """Endless, without repetition as long as there are others; `mutants_of(path)` gives the mutants of a file. Files that
    are not wanted are not read, and their mutants are left out."""
    files = {group: tree.files(group) for group in set(groups)}
    seen, number, misses = set(), 0, 0
    while misses < 10_000:
        group = groups[number % len(groups)]
        path = file_at(tree, files[group], fraction(seed, number, "file"))
        mutants = mutants_of(path) if is_wanted(path) else []
        number += 1
        mutant = mutants[int(fraction(seed, number, "mutant") * len(mutants))] if mutants else None
        if mutant is None or mutant.id in seen:
            misses += 1
            continue
        misses = 0
        seen.add(mutant.id)
        yield mutant
