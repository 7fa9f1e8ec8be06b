"""Mutants of a small project are built, tried and counted. Its judge is a script; g++, ninja and the linker are real.
Its two sources are compiled together, as the presets do."""

import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

import draws
import limited
import mutants
import reach
import results
import shards
import trial
import workshop

MASS = """#include "fast/limit.h"
namespace fast {
int mass(int a) {
  if (a < 0) return 0;
  return a < limit() ? a : limit();
}
}
"""
FILES = {
    "fast/mass.cpp": MASS,
    "fast/limit.h": "#pragma once\nnamespace fast {\ninline int limit() { return 3; }\n}\n",
    "fast/bounds.cpp": "namespace fast {\nint mass(int);\n"
                       "namespace { [[gnu::noinline]] int one() { return mass(1); } }\n"
                       "int bounds() { return one(); }\n}\n",
    "program.cpp": '#include <cstdio>\nnamespace fast { int mass(int); int bounds(); }\n'
                   'int main() { for (int i = -1; i < 6; ++i) std::printf("%d ", fast::mass(i)); return fast::bounds() == 7; }\n',
    "tests/fast/mass_test.cpp": "",
    "build/compile_commands.json": "",
    "build/build.ninja": """
rule cc
  command = g++ -O2 -fPIC -I$root -o $out -c $in
rule ar
  command = ar rcs $out $in
rule link
  command = : && g++ -O1 $in -o $out $libs && :
build unity_0_cxx.cxx.o: cc unity_0_cxx.cxx
build program.cpp.o: cc $root/program.cpp
build libfast.a: ar unity_0_cxx.cxx.o
build subjects/touchstone-subject-fast: link program.cpp.o | libfast.a
  libs = libfast.a
build touchstone-subject-fast: phony subjects/touchstone-subject-fast
build subjects/touchstone_tests_fast: link program.cpp.o | libfast.a
  libs = libfast.a
build touchstone_tests_fast: phony subjects/touchstone_tests_fast
""",
    # Asks the subject, and compares the answer as well as its property can: it does not look at negative numbers.
    # The property mass.red is red for every subject.
    "build/bin/touchstone": """#!/usr/bin/python3
import json, subprocess, sys
words = sys.argv[1:]
subject = words[words.index("--subjects") + 1].removeprefix("exec:")
run = subprocess.run([subject], capture_output=True, text=True)
reds = {"mass.red": 1, "mass.value": not run.returncode and run.stdout.split()[1:] != "0 1 2 3 3 3".split()}
asked = words[words.index("--properties") + 1].split(",") if "--properties" in words else list(reds)
if "standard" in words: reds["mass.value"] = 0
rows = [{"property": name, "fails": int(reds[name]), "breaks": 0, "worst": {"family": "solids", "index": 4}} for name in asked]
if run.returncode: rows[-1].update(breaks=1, defects={"crashed": 1})
json.dump({"rows": rows, "scenes": {"mass": 7}}, open(words[words.index("--json") + 1], "w"))
sys.exit(1 if any(row["fails"] + row["breaks"] for row in rows) else 0)
""",
}


def mutant(before, after, path="fast/mass.cpp"):
    source = FILES[path]
    begin = source.index(before)
    return mutants.Mutant(path, 1 + source[:begin].count("\n"), "mass", "relational", before, after, begin,
                          begin + len(before), after, id=f"{before} {after}")


class Project(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.root = pathlib.Path(cls.folder.name).resolve()
        build = cls.root / "build"
        for name, text in FILES.items():
            (cls.root / name).parent.mkdir(parents=True, exist_ok=True)
            (cls.root / name).write_text(text)
        (build / "bin/touchstone").chmod(0o755)
        (build / "build.ninja").write_text(f"root = {cls.root}\n" + FILES["build/build.ninja"])
        (build / "unity_0_cxx.cxx").write_text("".join(f'#include "{cls.root}/fast/{name}.cpp"\n'
                                                       for name in ("mass", "bounds")))
        subprocess.run(["ninja", "-C", build, "touchstone-subject-fast", "touchstone_tests_fast"], check=True,
                       stdout=subprocess.DEVNULL)
        (build / "compile_commands.json").write_text(json.dumps([
            {"directory": str(build), "file": str(build / "unity_0_cxx.cxx"),
             "command": f"ccache g++ -O2 -fPIC -MD -MT x -MF x.d -Werror -I{cls.root} -o unity_0_cxx.cxx.o "
                        f"-c {build}/unity_0_cxx.cxx"}]))
        cls.tree = draws.SourceTree(cls.root)
        cls.shop = workshop.Workshop(cls.root, build, cls.tree, build / "mutation")
        cls.reach = reach.Reach(cls.tree, cls.shop.object_of, cls.shop.original)
        cls.trial = trial.Trial(cls.shop, cls.reach, trial.Limits())

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def verdict(self, planted, by=None):
        folder = self.shop.place / "work"
        shutil.rmtree(folder, ignore_errors=True)
        return (by or self.trial).verdict(planted, "fast", folder)

    def test_a_red_property_kills(self):
        found = self.verdict(mutant("a < limit()", "a > limit()"))
        self.assertEqual((found["outcome"], found["stage"], found["by"], found["scenes"], found["scene"]),
                         ("killed", "quick", "mass.value", 7, "solids 4"))

    def test_without_check_no_property_kills(self):
        tests_only = trial.Trial(self.shop, self.reach, trial.Limits(), tests_only=True)
        self.assertEqual(self.verdict(mutant("a < limit()", "a > limit()"), tests_only)["outcome"], "survived")

    def test_a_broken_answer_kills(self):
        found = self.verdict(mutant("return 0;", "__builtin_trap();"))
        self.assertEqual((found["outcome"], found["by"]), ("killed", "broken: crashed (mass.value)"))

    def test_what_no_property_sees_is_killed_by_no_red_property_of_the_original(self):
        self.assertEqual(self.verdict(mutant("return 0;", "return 5;"))["outcome"], "survived")

    def test_a_red_test_kills(self):
        test, program = self.root / "tests/fast/mass_test.cpp", self.root / "build/subjects/touchstone_tests_fast"
        kept = self.shop.link
        test.write_text('#include "fast/mass.h"\n')

        def link(target, objects, folder):
            """A test that is red for this mutant."""
            made = kept(target, objects, folder)
            if target == "touchstone_tests_fast":
                made.write_text("#!/bin/sh\nprintf -- '%079d\\nno mass below zero\\n%079d\\n' 0 0 | tr 0 -\nexit 1\n")
            return made
        self.shop.link = link
        try:
            found = self.verdict(mutant("return 0;", "return 6;"))
        finally:
            self.shop.link = kept
        self.assertEqual((found["outcome"], found["stage"], found["by"]), ("killed", "tests", "test: no mass below zero"))
        self.assertTrue(program.exists())

    def test_a_compiler_error_is_no_kill(self):
        self.assertEqual(self.verdict(mutant("a < 0", "a < nothing"))["outcome"], "does not compile")

    def test_where_the_original_does_not_compile_no_mutant_is_tried(self):
        place = self.root / "build/other"  # without the originals that other tests have compiled
        broken = workshop.Workshop(self.root, self.root / "build", self.tree, place)
        broken.commands = {name: {**entry, "command": entry["command"].replace("-O2", "-no-such-option")}
                           for name, entry in broken.commands.items()}
        with self.assertRaisesRegex(workshop.BuildFailed, "original of fast/mass.cpp does not compile: .*no-such-option"):
            broken.objects(mutant("return 0;", "return 5;"), place / "work")

    def test_a_linker_error_is_no_kill(self):
        planted = mutant("return 0;", "{ extern int nothing(int); return nothing(a); }")
        self.assertEqual(self.verdict(planted)["outcome"], "does not compile")

    def test_the_machine_code_of_the_original_is_no_survivor(self):
        self.assertEqual(self.verdict(mutant("a < 0", "a <= -1"))["outcome"], "same code")

    def test_a_header_is_built_into_the_sources_that_include_it(self):
        found = self.verdict(mutant("return 3;", "return 4;", "fast/limit.h"))
        self.assertEqual((found["outcome"], found["by"]), ("killed", "mass.value"))

    def test_a_function_is_replaced_within_the_object_that_it_shares(self):
        folder = self.shop.place / "work"
        shutil.rmtree(folder, ignore_errors=True)
        objects = self.shop.objects(mutant("? a :", "? 7 * a :"), folder)
        program = self.shop.link("touchstone-subject-fast", objects, folder)
        self.assertEqual(limited.run([str(program)], 10).code, 1)  # bounds() is mass(1), which is 7

    def test_neither_the_source_nor_the_build_is_changed(self):
        def state():
            return {path: path.read_bytes() for path in self.root.rglob("*")
                    if path.is_file() and self.shop.place not in path.parents}
        before = state()
        self.verdict(mutant("a < limit()", "a >= limit()"))
        self.assertEqual(state(), before)

    def test_a_file_is_asked_about_the_queries_that_reach_it(self):
        self.assertEqual(self.reach.queries("fast/mass.cpp"), ["mass", "bounds"])
        self.assertEqual(self.reach.queries("fast/limit.h"), ["mass", "bounds"])
        self.assertEqual(self.reach.queries("fast/bounds.cpp"), ["bounds"])

    def test_places_without_a_symbol_connect_nothing(self):
        self.assertNotIn(None, self.reach.uses)
        self.assertNotIn(None, set().union(*self.reach.uses.values()))


class Limit(unittest.TestCase):
    def test_the_cpu_time_of_children_counts(self):
        began = time.monotonic()
        run = limited.run(["sh", "-c", "sh -c 'while :; do :; done' & wait"], 0.3)
        self.assertFalse(run.in_time)
        self.assertLess(time.monotonic() - began, 60)  # the limit for a program that sleeps is later

    def test_code_and_output(self):
        run = limited.run(["sh", "-c", "echo a; echo b >&2; exit 3"], 10)
        self.assertEqual((run.code, run.output, run.in_time), (3, "a\nb\n", True))
        self.assertEqual(limited.run(["sh", "-c", "kill -SEGV $$"], 10).code, -11)


class Results(unittest.TestCase):
    def result(self, key, outcome, **more):
        return {"id": key, "outcome": outcome, "path": "fast/mass.cpp", "line": 3, "function": "f", "kind": "sign",
                "before": "a | b", "after": "a", "group": "fast", "query": "mass", "seconds": 2.0, "cpu_seconds": 1.0,
                "scenes": 8, **more}

    def test_the_table_counts(self):
        every = [self.result("1", "killed", stage="quick", by="mass.value"), self.result("2", "survived"),
                 self.result("3", "killed", stage="tests", by="test: x"), self.result("4", "survived"),
                 self.result("5", "same code"), self.result("6", "does not compile")]
        page = "\n".join(results.tables(every, {"4": "no answer differs"}, 1))
        self.assertIn("| all | 3 | 1 | 0 | 1 | 1 | 1 | 33 % | 67 % |", page)
        self.assertIn("4 mutants, seed 1. Not counted, and others drawn instead: 1 that do not compile, 1 with the", page)
        self.assertIn("`a \\| b` becomes `a` | no answer differs |", page)

    def test_a_line_that_was_cut_off_is_tried_again(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "results.jsonl"
            results.add_result(file, self.result("1", "survived"))
            with file.open("a") as out:
                out.write('{"id": "2", "outc')
            self.assertEqual(list(results.read_results(file)), ["1"])

    def test_every_argument_is_complete(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "equivalent.toml"
            file.write_text('[[equivalent]]\nid = "1"\nmutant = "a"\nwhy = "since"\n')
            self.assertEqual(results.read_equivalent(file), {"1": "since"})
            file.write_text('[[equivalent]]\nid = "1"\nmutant = "a"\nwhy = " "\n')
            self.assertRaises(ValueError, results.read_equivalent, file)
        results.read_equivalent(pathlib.Path(__file__).parent / "equivalent.toml")


class Sample(unittest.TestCase):
    def try_all(self, sample, known, outcomes):
        import mutate
        tried, kept = [], []

        def judge(planted):
            tried.append(planted.id)
            return {"id": planted.id, "outcome": outcomes.get(planted.id, "killed"), "path": "x", "line": 1}
        wanted = (mutants.Mutant("x", 1, "f", "sign", "", "", 0, 0, "", id=str(n)) for n in range(20))
        found = mutate.try_all(wanted, sample, 2, known, judge, kept.append)
        return [result["id"] for result in found], sorted(tried), len(kept)

    def test_others_are_drawn_for_those_that_do_not_count(self):
        found, tried, kept = self.try_all(3, {}, {"1": "does not compile", "3": "same code", "2": "survived"})
        self.assertEqual((found, tried, kept), (["0", "1", "2", "3", "4"], ["0", "1", "2", "3", "4"], 5))

    def test_it_goes_on_where_it_was(self):
        known = {str(n): {"id": str(n), "outcome": "killed"} for n in range(2)}
        self.assertEqual(self.try_all(4, known, {}), (["0", "1", "2", "3"], ["2", "3"], 2))


class Shards(unittest.TestCase):
    run_of = {"source": "0123", "sample": 7, "seed": 1}

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def write(self, index, count=3, **other):
        shard = shards.Shard(index, count)
        found = [{"id": str(n), "outcome": "killed", "path": "x", "line": 1} for n in shard.of(range(7))]
        shards.write(self.folder.name, shard, {**self.run_of, **other}, found)
        return shard.file(self.folder.name)

    def refusal(self):
        with self.assertRaises(shards.BadShards) as raised:
            shards.read(self.folder.name, self.run_of)
        return str(raised.exception)

    def test_the_shards_of_a_run_are_the_whole_run(self):
        for index in (3, 1, 2):
            self.write(index)
        known = shards.read(self.folder.name, self.run_of)
        self.assertEqual(sorted(known), [str(n) for n in range(7)])
        self.assertEqual(Sample.try_all(self, 7, known, {}), ([str(n) for n in range(7)], [], 0))

    def test_a_shard_that_is_lost_is_named(self):
        self.write(1)
        self.write(3)
        self.assertIn("lacks 2/3; the same command with --shard 2/3 --out", self.refusal())

    def test_a_shard_that_is_cut_off_or_of_another_run_is_refused(self):
        self.write(1)
        self.write(2)
        file = self.write(3, source="4567")
        self.assertIn("3-of-3.jsonl is of another run: its source is 4567, here it is 0123", self.refusal())
        file = self.write(3)
        for text in ("", file.read_text()[:-2], file.read_text().splitlines()[0], "[]", "1\n2"):
            file.write_text(text)
            self.assertIn("is no whole shard", self.refusal())
        self.write(3)
        self.write(1, 2)
        self.assertIn("has the shards of 2 runs", self.refusal())

    def test_words(self):
        self.assertEqual(shards.shard_of("3/8"), shards.Shard(3, 8))
        for word in ("", "3", "0/8", "9/8", "3/", "-1/8", "3/8/1", "a/b"):
            self.assertRaises(ValueError, shards.shard_of, word)


class CommandLine(unittest.TestCase):
    def run_command(self, *words):
        return subprocess.run([sys.executable, pathlib.Path(__file__).parent / "mutate.py", *words], capture_output=True,
                              text=True, env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"})

    def test_bad_words_are_refused(self):
        for words in (["--sample", "0"], ["--sample", "x"], ["--seed", "-1"], ["--group", "app"], ["--only", "app/main.cpp"],
                      ["--only", "fast/nothing.cpp"], ["--id", "1"], ["more"], ["--shard", "3"],
                      ["--shard", "1/2", "--merge", "x"], ["--samp", "3"]):
            run = self.run_command(*words)
            self.assertEqual((run.returncode, run.stdout), (2, ""), words)
            self.assertIn("./touchstone mutate: error: ", run.stderr)

    def test_the_help_teaches(self):
        run = self.run_command("--help")
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        for word in ("Examples:", "Exit codes:", "--sample", "--seed", "equivalent.toml"):
            self.assertIn(word, run.stdout)
        self.assertLessEqual(max(map(len, run.stdout.splitlines())), 120)


unittest.main()
