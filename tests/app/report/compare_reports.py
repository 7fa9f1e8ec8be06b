"""Usage: compare_reports.py OLD NEW. Compares two reports: subjects, properties, rows, outcomes, counts, classes,
findings and minimised scenes. OLD and NEW are report.json files; the cases are read from the folder cases/ beside each.

Prints each difference in one line. Two kinds are explained, and printed once for each pattern: a key that has a new
name (RENAMED), and prose with other words around the same numbers. Returns 1 if a difference is not explained.

Numbers are equal if they are the same double; 0 and -0 are different."""

import collections
import json
import pathlib
import re
import sys

# The key of an object that contains it -> old key -> new key. "" is the report itself.
RENAMED = {
    "": {"cases_per_stem": "cases_per_query"},
    "properties": {"stem": "query"},
    "scene": {"flight": "motion"},
    "motion": {"times": "sample_times", "since": "start_times", "pushes": "forces"},
    # Below these, of "classes": the names of classes of scenes.
    "broad_phase": {
        "film": "sequence",
        "film: body taken away": "sequence: body removed",
        "film: pairs begin": "sequence: pairs begin",
        "film: pairs end": "sequence: pairs end",
        "film: put where it is": "sequence: unchanged pose",
        "film: still frame": "sequence: empty frame",
        "film: touching boxes": "sequence: touching boxes",
        "film: two taken away at once": "sequence: two removed at once",
    },
    "simulation": {"pushes": "applied forces"},
    "time_of_impact": {"pushes": "applied forces"},
}

# Keys with sentences for people. Everything else is compared as it is.
PROSE = {"about", "certificate", "expected", "name", "note", "observed", "says", "unit", "what", "why", "why_abstains"}

NUMBER = re.compile(r"[-+]?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?")
LONGEST = 60  # characters of a value that are printed


def renamed(value, key=""):
    """The value with the new names of all its keys. A list's items have the list's key."""
    if isinstance(value, list):
        return [renamed(item, key) for item in value]
    if not isinstance(value, dict):
        return value
    names = {old: RENAMED.get(key, {}).get(old, old) for old in value}
    return {names[old]: renamed(inner, names[old]) for old, inner in value.items()}


def read(path):
    """The report, with its rows by property and subject, and with the content of each row's case."""
    report = renamed(json.loads(path.read_text()))
    rows = {}
    for row in report.pop("rows"):
        if "case" in row:
            case = path.parent / row["case"]
            row["case"] = renamed(json.loads(case.read_text())) if case.exists() else f"no file {row['case']}"
        rows[f"{row['property']} of {row['subject']}"] = row
    report["rows"] = rows
    report["properties"] = {one["id"]: one for one in report["properties"]}
    report["subjects"] = {one["name"]: one for one in report["subjects"]}
    return report


def is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def same(old, new):
    if is_number(old) and is_number(new):
        return old == new and str(float(old)) == str(float(new))
    return type(old) is type(new) and old == new


def same_numbers(old, new):
    """Two texts with the same numbers in the same order."""
    return isinstance(old, str) and isinstance(new, str) and NUMBER.findall(old) == NUMBER.findall(new)


def shown(value):
    text = json.dumps(value, ensure_ascii=False)
    return text if len(text) <= LONGEST else text[:LONGEST] + " …"


class Comparison:
    def __init__(self):
        self.unexplained = []                   # lines
        self.explained = collections.Counter()  # line -> how often

    def compare(self, place, key, old, new):
        if isinstance(old, dict) and isinstance(new, dict):
            self.compare_objects(place, old, new)
        elif isinstance(old, list) and isinstance(new, list) and len(old) == len(new):
            for i, (a, b) in enumerate(zip(old, new)):
                self.compare(f"{place}[{i}]", key, a, b)
        elif same(old, new):
            pass
        elif key in PROSE and same_numbers(old, new):
            self.explained[f"wording of {key}: {shown(NUMBER.sub('#', old))} -> {shown(NUMBER.sub('#', new))}"] += 1
        else:
            self.unexplained.append(f"{place}: {shown(old)} -> {shown(new)}")

    def compare_objects(self, place, old, new):
        dot = ": " if place in ("rows", "properties", "subjects") else "."
        for key in old:
            inner = f"{place}{dot}{key}" if place else key
            if key in new:
                self.compare(inner, key, old[key], new[key])
            else:
                self.unexplained.append(f"{inner}: {shown(old[key])} -> absent")
        for key in new:
            if key not in old:
                self.unexplained.append(f"{place}{dot if place else ''}{key}: absent -> {shown(new[key])}")
        common = [key for key in old if key in new]
        if place == "rows" and common != [key for key in new if key in old]:
            self.unexplained.append("rows: in another order")


def renames_in(value, key=""):
    """How often each old key occurs: (old, new) -> count."""
    counts = collections.Counter()
    if isinstance(value, list):
        for item in value:
            counts += renames_in(item, key)
    elif isinstance(value, dict):
        for old, inner in value.items():
            name = RENAMED.get(key, {}).get(old, old)
            if name != old:
                counts[old, name] += 1
            counts += renames_in(inner, name)
    return counts


def renames_of(path):
    """The same for the report and its cases."""
    counts = renames_in(json.loads(path.read_text()))
    for case in sorted((path.parent / "cases").glob("*.json")):
        counts += renames_in(json.loads(case.read_text()))
    return counts


def main(old, new):
    comparison = Comparison()
    comparison.compare("", "", read(old), read(new))
    for line in comparison.unexplained:
        print(line)
    for (key, name), count in sorted((renames_of(old) - renames_of(new)).items()):
        print(f"explained, {count} times: the key {key} is {name}")
    for line, count in sorted(comparison.explained.items()):
        print(f"explained, {count} times: {line}")
    print(f"{len(comparison.unexplained)} differences are not explained")
    return 1 if comparison.unexplained else 0


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    sys.exit(main(*map(pathlib.Path, sys.argv[1:])))
