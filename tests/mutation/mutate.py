#!/usr/bin/python3
"""The command ./touchstone mutate: plants faults in the source, one at a time, and sees which are found."""

import argparse
import concurrent.futures
import fcntl
import functools
import hashlib
import itertools
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import draws  # noqa: E402
import limited  # noqa: E402
import mutants  # noqa: E402
import reach  # noqa: E402
import results  # noqa: E402
import shards  # noqa: E402
import trial  # noqa: E402
import workshop  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
EQUIVALENT = pathlib.Path(__file__).parent / "equivalent.toml"
JUDGED_FOLDERS = ("app", "cmake", "fast", "model", "oracle", "properties", "reference", "tests")

ABOUT = """Plants small faults in the source, one at a time, and sees which are found.

A mutant is a copy of one file of fast/, reference/, oracle/ or properties/ with one fault in it: another operator or
constant, a condition negated, a statement dropped, arguments exchanged, a wrong index or sign, the other direction of
rounding, an early return. The seed decides which mutants are tried. Each is built in a folder of its own (the source
is never changed) and tried in this order until something is red:
  quick      check --effort quick with the queries that reach the file. A mutant of fast is the subject. A fault of the
             reference is in the judge, which asks fast, and of few scenes in the subject too. A mutant of the judge
             (oracle, properties) judges fast, the reference and the canaries.
  standard   check --effort standard, with another seed, for a limited time
  tests      the unit tests of the file
A mutant that does not compile, or whose machine code is that of the original, counts for nothing; another is drawn."""

EXAMPLES = """Examples:
  ./touchstone mutate --sample 200 --seed 1
  ./touchstone mutate --sample 20 --group judge      faults of oracle/ and properties/ alone
  ./touchstone mutate --only fast/mass.cpp --list    all mutants of a file; nothing is tried
  ./touchstone mutate --id 0123abcd --only fast/mass.cpp --show
  ./touchstone mutate --sample 60 --tests-only       what the unit tests see by themselves, within minutes
  ./touchstone mutate --sample 200 --shard 1/8 --out shards     on one machine, 2/8 on another, and so on; then
  ./touchstone mutate --sample 200 --merge shards               the table that one run would have written

The table goes to stdout. The same command goes on where an interrupted one was, and a greater sample contains the
smaller one, as long as no source changes. Survivors that no question can tell from the original are argued in
tests/mutation/equivalent.toml, which takes them out of the rates. See docs/how_to/mutate.md.

Exit codes:
  0    the table is written, whatever survived
  2    bad usage; a shard is missing, cut off or of another run
  3    the set-up or the build failed, or a run on the source without a fault fails
  130  interrupted; what was tried until then is kept (SIGHUP: 129, SIGTERM: 143)"""


def whole_number(least, most):
    def read(word):
        if not word.isascii() or not word.isdigit() or not least <= int(word) <= most:
            raise argparse.ArgumentTypeError(f'expected a whole number from {least} to {most}, found "{word}"')
        return int(word)
    return read


def shard_word(word):
    try:
        return shards.shard_of(word)
    except ValueError as error:
        raise argparse.ArgumentTypeError(str(error)) from error


def arguments(words):
    parser = argparse.ArgumentParser(prog="./touchstone mutate", description=ABOUT, epilog=EXAMPLES, allow_abbrev=False,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sample", metavar="NUMBER", type=whole_number(1, 100_000), default=200,
                        help="how many mutants are tried (default: 200)")
    parser.add_argument("--seed", metavar="NUMBER", type=whole_number(0, 2**64 - 1), default=1,
                        help="chooses the mutants (default: 1)")
    parser.add_argument("--group", choices=list(draws.GROUPS), help="only mutants of this part of the source")
    parser.add_argument("--only", metavar="FILE", help="only mutants of this file, named from the root of the source")
    parser.add_argument("--id", metavar="ID", help="only this mutant; --only names its file")
    parser.add_argument("--list", action="store_true", help="print all mutants that could be drawn, and try none")
    parser.add_argument("--show", action="store_true", help="print how the mutants change the source, and try none")
    parser.add_argument("--tests-only", action="store_true", help="ask only the unit tests, which takes seconds a mutant; "
                                                                  "kept apart from what other runs find")
    parser.add_argument("--jobs", metavar="NUMBER", type=whole_number(1, 1024), default=os.cpu_count(),
                        help="how many mutants are tried at a time (default: one for each processor)")
    parser.add_argument("--shard", metavar="I/N", type=shard_word,
                        help="try only every N-th mutant of the sample, from the I-th on, and write what was found to --out")
    parser.add_argument("--out", metavar="FOLDER", default="shards", help="the folder of the shards (default: shards)")
    parser.add_argument("--merge", metavar="FOLDER", help="take what the shards in this folder have found; only mutants "
                                                          "that replace some which do not count are tried here")
    parser.add_argument("--build", metavar="FOLDER", help="a build folder; it is made if there is none "
                                                          "(default: build-mutate beside the source)")
    chosen = parser.parse_args(words)
    if chosen.only and (draws.group_of(chosen.only) is None or not (ROOT / chosen.only).is_file()):
        parser.error(f"--only {chosen.only}: no file of fast/, reference/, oracle/ or properties/ that is mutated")
    if chosen.id and not chosen.only:
        parser.error("--id: --only must name the file")
    if chosen.shard and chosen.merge:
        parser.error("--shard makes a part, --merge needs all of them: one at a time")
    return chosen


def say(text):
    print(f"touchstone: {text}", file=sys.stderr)


class GiveUp(Exception):
    """The set-up failed; the text says what is missing."""


def own_libclang():
    try:
        import clang.cindex
        clang.cindex.Index.create()
        return clang.cindex
    except Exception as error:  # one that is missing or too old raises many kinds
        raise GiveUp(f"libclang for Python: {error} (Debian: apt-get install python3-clang)") from error


def prepare(build, jobs, groups):
    """Builds all programs that are tried, without a fault. Two runs in one build folder take turns."""
    build.mkdir(parents=True, exist_ok=True)
    lock = (build / ".lock").open("a")
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        say(f"waiting for another run that builds or uses {build}")
        fcntl.flock(lock, fcntl.LOCK_EX)
    steps = [] if (build / "build.ninja").exists() else [["cmake", "--preset", "mutate", "-B", str(build)]]
    targets = [f"mutation_{group}" for group in groups]
    for step in [*steps, ["ninja", "-C", str(build), "-j", str(jobs), *targets]]:
        try:
            if subprocess.run(step, cwd=ROOT, stdout=sys.stderr).returncode != 0:
                raise GiveUp(f"failed: {' '.join(step)}")
        except FileNotFoundError as error:
            raise GiveUp(f"{step[0]} is missing") from error
    return lock


def groups_of(options):
    if options.only:
        return [draws.group_of(options.only)]
    return [options.group] if options.group else list(draws.GROUPS)


def digest_of_source():
    """What is measured holds only for the source, tests and tester that it was measured with."""
    total = hashlib.sha256()
    for folder in JUDGED_FOLDERS:
        for path in sorted((ROOT / folder).rglob("*")):
            if path.suffix in (".cpp", ".h", ".in", ".py", ".txt", ".cmake") and path.is_file():
                total.update(f"{path.relative_to(ROOT)}\n".encode() + path.read_bytes())
    return total.hexdigest()[:12]


class Reader:
    """The mutants of each file, which libclang reads once: later runs find them in the build folder."""

    def __init__(self, shop, tree):
        self.shop, self.tree, self.clang, self.seen = shop, tree, own_libclang(), {}
        self.tester = pathlib.Path(mutants.__file__).read_bytes()

    def source_with(self, path):
        """A source through which a file is read: itself or, for a header, one that includes it."""
        return (self.tree.sources_of(path) or [None])[0]

    def __call__(self, path):
        if path not in self.seen:
            self.seen[path] = self.read(path)
        return self.seen[path]

    def read(self, path):
        source = (ROOT / path).read_bytes()
        included = (ROOT / name for name in sorted(self.tree.reached(path)))
        content = b"\n".join([self.tester, path.encode(), source, *(name.read_bytes() for name in included)])
        kept = self.shop.build / "mutation/mutants" / f"{hashlib.sha256(content).hexdigest()[:16]}.json"
        if kept.exists():
            return [mutants.Mutant(**fields) for fields in json.loads(kept.read_text())]
        through = self.source_with(path)
        unit = self.clang.Index.create().parse(str(ROOT / through), self.shop.options_for_clang(through) + ["-w"])
        errors = [d.spelling for d in unit.diagnostics if d.severity >= self.clang.Diagnostic.Error]
        if errors:
            raise GiveUp(f"libclang cannot read {through}: {errors[0]}")
        found = mutants.in_file(unit, path, source, str(ROOT / path))
        kept.parent.mkdir(parents=True, exist_ok=True)
        kept.write_text(json.dumps([vars(mutant) for mutant in found]))
        return found


def chosen_draws(options, tree, reader):
    if options.only:
        every = reader(options.only)
        if options.id:
            every = [mutant for mutant in every if mutant.id == options.id]
            if not every:
                raise GiveUp(f"{options.only} has no mutant {options.id}; --list names them")
        return iter(sorted(every, key=lambda mutant: draws.fraction(options.seed, 0, mutant.id)))
    return draws.draws(tree, reader, options.seed, (options.group,) if options.group else draws.TURNS)


def list_mutants(options, tree, reader):
    every = [path for group in groups_of(options) for path in tree.files(group)]
    for path in [options.only] if options.only else every:
        for mutant in reader(path):
            if options.id in (None, mutant.id):
                print(f"{mutant.id} {mutant.path}:{mutant.line}: {mutant.kind}: {mutant.after}")


def show(mutant):
    print(f"{mutant.id} {mutant.path}:{mutant.line} {mutant.function}: {mutant.kind}\n- {mutant.before}\n+ {mutant.after}")


class Progress:
    """One line that is drawn again, if stderr is a terminal."""

    def __init__(self, whole):
        self.whole, self.live = whole, sys.stderr.isatty() and os.environ.get("TERM") != "dumb"

    def step(self, judged, result):
        if self.live:
            print(f"\r\033[K{judged}/{self.whole} {result['outcome']}: {result['path']}:{result['line']}", end="",
                  file=sys.stderr, flush=True)

    def end(self):
        if self.live:
            print("\r\033[K", end="", file=sys.stderr, flush=True)


def try_all(wanted, sample, jobs, known, judge, keep):
    """The results of the first mutants of which `sample` count, in the order of the draws. `known`: results by id, to
    which those of `judge` are added; `keep` writes them down as they come."""
    progress, drawn, lacking = Progress(sample), [], sample
    pool = concurrent.futures.ThreadPoolExecutor(jobs)
    try:
        while lacking and (batch := list(itertools.islice(wanted, lacking))):
            drawn += [mutant.id for mutant in batch]
            tried = [pool.submit(judge, mutant) for mutant in batch if mutant.id not in known]
            for future in concurrent.futures.as_completed(tried):
                result = future.result()
                known[result["id"]] = result
                keep(result)
                progress.step(sum(known[key]["outcome"] not in results.DROPPED for key in drawn if key in known), result)
            lacking = sample - sum(known[key]["outcome"] not in results.DROPPED for key in drawn)
    except BaseException:
        limited.stopping.set()
        raise
    finally:
        pool.shutdown(cancel_futures=True)
        progress.end()
    return [known[key] for key in drawn]


def judge_one(shop, trier, mutant):
    folder = shop.place / "work" / mutant.id
    try:
        return trier.verdict(mutant, draws.group_of(mutant.path), folder)
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def interrupt(number, _):
    limited.stopping.set()
    raise KeyboardInterrupt(number)


def main(words):
    options = arguments(words)
    build = pathlib.Path(options.build or ROOT / "build-mutate").resolve()
    results.read_equivalent(EQUIVALENT)
    source = digest_of_source()
    run = {"source": source, "sample": options.sample, "seed": options.seed, "group": options.group, "only": options.only,
           "tests_only": options.tests_only}
    merged = shards.read(options.merge, run) if options.merge else {}
    own_libclang()
    lock = prepare(build, options.jobs, groups_of(options))
    tree = draws.SourceTree(ROOT)
    shop = workshop.Workshop(ROOT, build, tree, build / "mutation" / source)
    reader = Reader(shop, tree)
    if options.list:
        list_mutants(options, tree, reader)
        return 0
    wanted = chosen_draws(options, tree, reader)
    if options.show:
        for mutant in itertools.islice(wanted, options.sample):
            show(mutant)
        return 0
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, interrupt)
    file = shop.place / ("results_of_tests.jsonl" if options.tests_only else "results.jsonl")
    known = results.read_results(file) | merged
    if options.shard:
        wanted = iter(options.shard.of(list(itertools.islice(wanted, options.sample))))
    trier = trial.Trial(shop, reach.Reach(tree, shop.object_of, shop.original), trial.Limits(), options.tests_only)
    found = try_all(wanted, options.sample, options.jobs, known,
                    functools.partial(judge_one, shop, trier), functools.partial(results.add_result, file))
    if options.shard:
        shards.write(options.out, options.shard, run, found)
        say(f"wrote {options.shard.file(options.out)}, {len(found)} mutants")
        return 0
    print("\n".join(results.tables(found, results.read_equivalent(EQUIVALENT), options.seed)))
    print(f"\nNot mutated: {len(tree.headers_left_out())} headers that more than {draws.MOST_USERS} sources include.")
    lock.close()
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except KeyboardInterrupt as signal_number:
        sys.exit(128 + (signal_number.args[0] if signal_number.args else signal.SIGINT))
    except shards.BadShards as error:
        say(error)
        sys.exit(2)
    except (GiveUp, workshop.BuildFailed, trial.BaseFails) as error:
        say(error)
        sys.exit(3)
