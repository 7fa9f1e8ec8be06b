"""Tries a mutant: check with effort quick, check with effort standard, then the unit tests of its file.

A kill is a red property, a red test, or an answer that is broken. Every way to find one is first tried on the program
without a fault: what fails there is no kill, and what takes many times as long as there is one."""

import dataclasses
import json
import re
import sys
import threading
import time

import limited
import reach
import workshop

QUICK_SEED, STANDARD_SEED = 1, 2  # standard begins with the scenes that quick has asked, so it has a seed of its own
CANARY_TESTS = "canaries prove*,each canary about*"
SIGNALS_OF_A_CRASH = range(-64, 0)
# Of each query so many of quick's scenes are asked first, then all: most faults show in them, and in a query that is not
# the first.
FIRST_SCENES = {"simulation": 60, "constraint": 30}
USUAL_FIRST_SCENES = 300
FAST, REFERENCE = "touchstone-subject-fast", "touchstone-subject-reference"
HANGS_AFTER = "5"  # CPU seconds for one question: on a busy machine an original takes more than the usual limit of 1


@dataclasses.dataclass(frozen=True)
class Limits:
    standard: float = 60  # CPU seconds for all queries together
    slack: float = 30     # CPU seconds that a quick check or a test may take in any case ...
    factor: float = 5     # ... beside so many times what it takes without a fault


@dataclasses.dataclass
class Kill:
    stage: str           # quick, standard or tests
    by: str              # a property, a test, or "broken: ..."
    scenes: int = 0      # how many were asked about, that of the failure included; 0: not known
    scene: str = ""      # family and number


class BaseFails(Exception):
    """The program without a fault does not do what it should, so nothing can be said about mutants."""


class Trial:
    def __init__(self, shop, reached, limits, tests_only=False):
        self.workshop, self.reach, self.limits, self.tests_only = shop, reached, limits, tests_only
        self.base, self.lock = {}, threading.Lock()
        self.base_file = shop.place / "base.json"

    # --- without a fault -----------------------------------------------------------------------------------------

    def without_fault(self, key, measure):
        """What `measure` found out about the program without a fault; found out once."""
        with self.lock:
            if not self.base and self.base_file.exists():
                self.base = json.loads(self.base_file.read_text())
            if key not in self.base:
                self.base[key] = measure()
                self.base_file.parent.mkdir(parents=True, exist_ok=True)
                self.base_file.write_text(json.dumps(self.base, indent=1))
            return self.base[key]

    def base_check(self, subject, query):
        """{"seconds", "red"}: red are properties that the subject fails without a fault."""
        def measure():
            folder = self.workshop.place / "base"
            folder.mkdir(parents=True, exist_ok=True)
            run, rows = self.check(self.workshop.program("touchstone"), self.workshop.program(subject), folder,
                                   ["--queries", query, *quick_words(subject, query)], 3600)
            if run.code not in (0, 1) or not run.in_time:
                raise BaseFails(f"check of {subject} about {query} ends with {run.code}: {run.output[-500:]}")
            return {"seconds": run.seconds, "red": [row["property"] for row in rows if is_red(row)],
                    "green": [row["property"] for row in rows if not is_red(row)]}
        return self.without_fault(f"check {subject} {query}", measure)

    def base_tests(self, target, words):
        def measure():
            run = limited.run([self.workshop.program(target), *words], 3600, self.workshop.build)
            if run.code != 0 or "No test" in run.output:
                raise BaseFails(f"{target} {' '.join(words)} fails: {run.output[-500:]}")
            return {"seconds": run.seconds}
        return self.without_fault(f"{target} {' '.join(words)}", measure)

    def allowed(self, seconds):
        return self.limits.slack + self.limits.factor * seconds

    # --- with a fault --------------------------------------------------------------------------------------------

    def check(self, judge, subject, folder, words, limit):
        """(the run, the rows of its report)."""
        report = folder / "report.json"
        report.unlink(missing_ok=True)
        if judge == self.workshop.program("touchstone"):  # its own answers are right
            words = [*words, "--skip-self-test"]
        run = limited.run([judge, "check", "--subjects", f"exec:{subject}", "--jobs", "1", "--skip-adapter-check",
                           "--time-limit", HANGS_AFTER, "--json", report, *words], limit)
        return run, rows_of(report)

    def killed_by_check(self, stage, judge, subject, folder, words, limit, judge_is_mutant):
        """(a kill or None, CPU seconds)."""
        run, rows = self.check(judge, subject, folder, [*words, "--first-failure"], limit)
        red = next((row for row in rows if is_red(row)), None)
        if run.code == 1 and red:
            how = red["property"] if red["fails"] else f"broken: {', '.join(red.get('defects', {}))} ({red['property']})"
            worst = red["worst"]
            return Kill(stage, how, scenes_of(folder / "report.json"), f"{worst['family']} {worst['index']}"), run.seconds
        if run.code == 2 and (judge_is_mutant or "subject" in run.output):  # it does not introduce itself
            return Kill(stage, "broken: " + last_line(run.output)), run.seconds
        if judge_is_mutant and (run.code == 3 or run.code in SIGNALS_OF_A_CRASH and run.in_time):
            return Kill(stage, "broken: " + (last_line(run.output) or f"the judge ends with {run.code}")), run.seconds
        if judge_is_mutant and not run.in_time and stage == "quick":
            return Kill(stage, f"broken: the judge takes more than {limit:.0f} s of CPU time"), run.seconds
        if run.code == 3:
            print(f"touchstone: the judge itself fails: {last_line(run.output)}", file=sys.stderr)
        return None, run.seconds

    def killed_by_tests(self, stage, program, target, words):
        base = self.base_tests(target, words)
        limit = self.allowed(base["seconds"])
        run = limited.run([program, *words, "--abort"], limit, self.workshop.build)
        if not run.in_time:
            return Kill(stage, f"broken: {target} takes more than {limit:.0f} s of CPU time"), run.seconds
        return (Kill(stage, "test: " + red_test(run)) if run.code != 0 else None), run.seconds

    def stages(self, mutant, group, objects, folder):
        """Kills and CPU seconds, one for each thing that is tried, in order."""
        link = self.linker(objects, folder)
        if not self.tests_only:
            yield from self.checks(mutant, group, link, folder)
        for layer, names in reach.tests_of(self.workshop.root, mutant.path):
            target = f"touchstone_tests_{layer}"
            words = ["--filenames-as-tags", ",".join(f"[#{name}]" for name in names)]
            yield self.killed_by_tests("tests", link(target), target, words)

    def checks(self, mutant, group, link, folder):
        queries, original = self.reach.queries(mutant.path), self.workshop.program
        if group == "fast":
            judge, program = original("touchstone"), link
            asked = [(f"{FAST}{name}", query) for query in queries for name in
                     ["", *(f".{further}" for further in self.reach.further_subjects(mutant.path, query))]]
        else:  # a fault of the reference is in the truth of the judge too
            judge, faulty = link("touchstone"), [REFERENCE] if group == "reference" else []
            program = lambda name: (link if name in faulty else original)(name)
            asked = [(FAST, query) for query in queries]
            asked += [(REFERENCE, query) for query in (queries if group == "reference" else queries[:1])]
        for only_first in (True, False):
            for name, query in asked:
                if only_first or name != REFERENCE:
                    yield from self.if_green(
                        name, query, lambda: self.quick(name, query, judge, program(name), group, folder, only_first))
        if group == "judge":
            target = "touchstone_tests_properties"
            yield self.killed_by_tests("quick", link(target), target, [CANARY_TESTS])
        limit = self.limits.standard / max(1, len(queries))
        for name, query in asked:
            if name == REFERENCE:
                continue
            yield from self.if_green(name, query,
                                     lambda: self.standard(name, query, judge, program(name), group, folder, limit))

    def if_green(self, name, query, stage):
        """The original is asked only when its turn comes: most mutants are killed by their first query."""
        if self.base_check(name, query)["green"]:
            yield stage()

    def linker(self, objects, folder):
        linked = {}

        def link(target):
            if target not in linked:
                linked[target] = self.workshop.link(target, objects, folder)
            return linked[target]
        return link

    def quick(self, name, query, judge, program, group, folder, only_first):
        base = self.base_check(name, query)
        words = ["--properties", ",".join(base["green"])] if base["red"] else ["--queries", query]
        limit = self.allowed(base["seconds"])
        return self.killed_by_check("quick", judge, program, folder, words + quick_words(name, query, only_first), limit,
                                    group != "fast")

    def standard(self, name, query, judge, program, group, folder, limit):
        """The original is not known to hold everything here, so what kills is asked of it too."""
        words = ["--properties", ",".join(self.base_check(name, query)["green"])]
        words += ["--effort", "standard", "--seed", str(STANDARD_SEED)]
        kill, seconds = self.killed_by_check("standard", judge, program, folder, words, limit, group != "fast")
        if kill:
            again, more = self.killed_by_check("standard", self.workshop.program("touchstone"),
                                               self.workshop.program(name), folder, words, limit + 2 * seconds, False)
            return None if again and again.scene == kill.scene else kill, seconds + more
        return None, seconds

    def verdict(self, mutant, group, folder):
        """The result of a mutant, as a dictionary for the results' file."""
        began = time.monotonic()
        objects = self.workshop.objects(mutant, folder)
        built = time.monotonic() - began
        result = {"id": mutant.id, "path": mutant.path, "line": mutant.line, "function": mutant.function,
                  "kind": mutant.kind, "before": mutant.before, "after": mutant.after, "group": group,
                  "query": reach.own_query(mutant.path) or "several", "build_seconds": round(built, 1)}
        if not objects:
            return {**result, "outcome": "same code" if objects == [] else "does not compile"}
        seconds = 0.0
        try:
            for kill, spent in self.stages(mutant, group, objects, folder):
                seconds += spent
                if kill:
                    result.update(outcome="killed", **dataclasses.asdict(kill))
                    break
            else:
                result["outcome"] = "survived"
        except workshop.DoesNotLink:
            result["outcome"] = "does not compile"
        return {**result, "cpu_seconds": round(seconds, 1), "seconds": round(time.monotonic() - began, 1)}


def quick_words(subject, query, only_first=False):
    """Of the reference a tenth of the first scenes: it is exact and slow, and quick would take 40 minutes."""
    first = FIRST_SCENES.get(query, USUAL_FIRST_SCENES)
    words = ["--effort", "quick", "--seed", str(QUICK_SEED)]
    if subject == REFERENCE:
        return [*words, "--cases", str(first // 10)]
    return [*words, "--cases", str(first)] if only_first else words


def is_red(row):
    return row["fails"] + row["breaks"] > 0


def rows_of(report):
    return json.loads(report.read_text())["rows"] if report.exists() else []


def scenes_of(report):
    return sum(json.loads(report.read_text())["scenes"].values())


def last_line(text):
    lines = [line for line in text.splitlines() if line.strip()]
    return lines[-1][:200] if lines else ""


def red_test(run):
    """The name of the test that failed, from Catch2's console report."""
    found = re.search(r"^-{79}\n(.+?)\n-{79}$", run.output, re.MULTILINE | re.DOTALL)
    return " / ".join(line.strip() for line in found.group(1).splitlines()) if found else f"ends with {run.code}"
