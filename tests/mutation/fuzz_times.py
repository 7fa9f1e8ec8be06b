#!/usr/bin/python3
"""How long does fuzzing take to find a planted fault, beside check?

For each query, mutants of fast are drawn as ./touchstone mutate draws them, from the sources of that query alone, until
enough of them were found by anything: check, or fuzz. check quick and then standard ask the mutant as a subject; three
times `fuzz --empty-corpus` asks it in its own process, with seeds 1, 2 and 3. Where check does not find it, it is fuzzed
for a minute first, and no more if that finds nothing: it may change nothing. A property that fails on the same scene
without the fault is not asked. A table goes to stdout.

The build folder is that of ./touchstone mutate, which must have been run in it. What is measured is kept there, in a
folder beside that of mutate, so both may run at one time."""

import argparse
import functools
import json
import pathlib
import shutil
import statistics
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import draws  # noqa: E402
import limited  # noqa: E402
import mutate  # noqa: E402
import reach  # noqa: E402
import trial  # noqa: E402
import workshop  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
SEEDS = (1, 2, 3)
PROBE = 60  # s: how long a mutant is fuzzed first that check does not find
FOLDER_OF = {"distance": "lin_canny"}  # of the others: their own name


def is_named_after(query, path):
    """What queries share is found by any of them, so sources of one query are taken, by their names."""
    return path == f"fast/{query}.cpp" or path.startswith(f"fast/{FOLDER_OF.get(query, query)}/")


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", default=str(ROOT / "build-mutate"), help="default: %(default)s")
    parser.add_argument("--faults", type=int, default=2, help="found faults for each query; default: %(default)s")
    parser.add_argument("--tries", type=int, default=6, help="mutants for each query at most; default: %(default)s")
    parser.add_argument("--time", type=float, default=300, help="of a run of fuzz, s; default: %(default)s")
    parser.add_argument("--seed", type=int, default=1, help="of the mutants; default: %(default)s")
    parser.add_argument("--query", choices=reach.QUERIES, action="append", help="default: all")
    return parser.parse_args()


class Times:
    def __init__(self, options):
        build = pathlib.Path(options.build).resolve()
        self.options, self.tree = options, draws.SourceTree(ROOT)
        self.shop = workshop.Workshop(ROOT, build, self.tree, build / "fuzz_times" / mutate.digest_of_source())
        self.reader = mutate.Reader(self.shop, self.tree)
        self.reach = reach.Reach(self.tree, self.shop.object_of, self.shop.original)
        self.trial = trial.Trial(self.shop, self.reach, trial.Limits())
        self.file = self.shop.place / "fuzz_times.jsonl"
        lines = self.file.read_text().splitlines() if self.file.exists() else []
        self.known = {(found["query"], found["id"]): found for found in map(json.loads, lines)}
        self.properties = properties_of(self.shop.program("touchstone"))

    def of_query(self, query):
        """The results of mutants until enough are found."""
        enough, tried = self.options.faults, 0
        for mutant in draws.draws(self.tree, self.reader, self.options.seed, ("fast",),
                                  lambda path: is_named_after(query, path) and query in self.reach.queries(path)):
            if enough == 0 or tried == self.options.tries:
                return
            found = self.known.get((query, mutant.id)) or self.measured(query, mutant)
            if found["builds"]:
                tried += 1
                enough -= is_found(found)
                yield found

    def measured(self, query, mutant):
        folder = self.shop.place / "fuzz" / mutant.id
        found = {"query": query, "id": mutant.id, "path": mutant.path, "line": mutant.line, "kind": mutant.kind,
                 "builds": False}
        try:
            if objects := self.shop.objects(mutant, folder):
                is_followed = query == "distance" and not self.is_asked_once(mutant.path)
                name = "fast.warm" if is_followed else "fast"
                subject = self.shop.link(f"touchstone-subject-{name}", objects, folder)
                program = self.shop.link("touchstone", objects, folder)
                check = self.check(query, subject, folder)
                fuzz = functools.partial(self.fuzz, query, f"inproc:{name}", program, folder)
                found.update(builds=True, check=check, fuzz=[fuzz(SEEDS[0], self.options.time if check else PROBE)])
                if is_found(found):
                    found["fuzz"] += [fuzz(seed, self.options.time) for seed in SEEDS[1:]]
        except workshop.DoesNotLink:
            pass
        finally:
            shutil.rmtree(folder, ignore_errors=True)
        self.known[query, mutant.id] = found
        with self.file.open("a") as file:
            file.write(json.dumps(found) + "\n")
        return found

    def is_asked_once(self, path):
        """Whether it is of fast::distance, and not of the collider alone."""
        return bool(self.reach.of_file(path) & self.reach.reached_from(("fast/distance.cpp",)))

    def check(self, query, subject, folder):
        """CPU seconds until a check finds it, the effort, and the law; None: neither does."""
        spent = 0.0
        for effort in ("quick", "standard"):
            kill, seconds = self.trial.killed_by_check(effort, self.shop.program("touchstone"), subject, folder,
                                                       ["--queries", query, "--effort", effort, "--seed", "1"], 600, False)
            spent += seconds
            if kill:
                return {"seconds": round(spent, 1), "effort": effort, "by": kill.by}
        return None

    def fuzz(self, query, subject, program, folder, seed, longest):
        """CPU seconds until it is found, and by what; None: it is not."""
        spent = 0.0
        while True:
            words = [program, "fuzz", query, "--subject", subject, "--properties", *self.properties[query],
                     "--empty-corpus", "--first-failure", "--time", longest, "--seed", seed, "--out",
                     folder / "findings", "--json"]
            run = limited.run(list(map(str, words)), 2 * longest)
            spent += run.seconds
            if run.code == 0 and run.in_time:
                return None
            if run.code not in (1, 3) or not run.in_time:
                return {"seconds": round(spent, 1), "by": "no end" if not run.in_time else f"ends with {run.code}"}
            findings = json.loads(run.output)["findings"]
            by = findings[0]["property"] if findings else "the screen and the properties disagree"
            if not findings or not self.fails_without_fault(findings[0]["case"], subject):
                return {"seconds": round(spent, 1), "by": by}
            self.properties[query].remove(by)

    def fails_without_fault(self, case, subject):
        words = [self.shop.program("touchstone"), "replay", case, "--subject", subject]
        return limited.run(list(map(str, words)), 300).code == 1


def properties_of(program):
    """query -> its properties."""
    listed = subprocess.run([program, "list", "properties"], capture_output=True, text=True, check=True).stdout
    names = [line.split()[0] for line in listed.splitlines() if line]
    return {query: [name for name in names if name.startswith(query + ".")] for query in reach.QUERIES}


def is_found(found):
    return found["check"] is not None or any(found["fuzz"])


def text_of(times):
    """The median of three, and all of them; a run that found nothing counts as the longest."""
    longest = float("inf")
    seconds = [time["seconds"] if time else longest for time in times]
    words = ["-" if each == longest else f"{each:.1f}" for each in (statistics.median(seconds), *seconds)]
    return f"{words[0]} ({', '.join(words[1:])})"


def main():
    options = arguments()
    times = Times(options)
    print("| query | fault of `fast` | by `check`, CPU s | by `fuzz`, CPU s: median (three seeds) | the law that fails |")
    print("|---|---|---|---|---|")
    for query in options.query or reach.QUERIES:
        for found in times.of_query(query):
            check = f"{found['check']['seconds']}, {found['check']['effort']}" if found["check"] else "-"
            by = sorted({time["by"] for time in found["fuzz"] if time})
            print(f"| {query} | `{found['path'].removeprefix('fast/')}`, line {found['line']}: {found['kind']} | {check} | "
                  f"{text_of(found['fuzz'])} | {', '.join(by) or '-'} |", flush=True)


if __name__ == "__main__":
    main()
