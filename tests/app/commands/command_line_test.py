"""The command line itself: suggestions, help, numbers, stdin, completion in a shell."""

import json
import re
import shutil
import subprocess
import unittest

from program import *

TWO_BALLS = scene(body(ball(1)), body(ball(1), (3, 0, 0)))
LARGEST_SEED = 2**64 - 1


def commands(help_text):
    return re.findall(r"(?m)^  ([a-z-]+) {2,}", help_text.split("Subcommands:" if "Subcommands:" in help_text else "SUBCOMMANDS:")[1])


class Suggestions(Test):
    def test_what_was_probably_meant(self):
        name = self.file("balls.json", TWO_BALLS)
        for words, meant in [
            (["reprot"], "report"),
            (["help", "chekc"], "check"),
            (["ask", "distanse", name], "distance"),
            (["list", "subject"], "subjects"),
            (["bench", "distanc"], "distance"),
            (["completion", "bsh"], "bash"),
            (["check", "--effort", "quik"], "quick"),
            (["check", "--queries", "distanse"], "distance"),
            (["check", "--properties", "distance.valeu"], "distance.value"),
            (["check", "--subjects", "refrence"], "reference"),
            (["check", "--subjects", "inproc:refrence"], "inproc:reference"),
            (["replay", name, "--subjct", "fast"], "--subject"),
            (["ask", "--jsn", "distance"], "--json"),
            (["check", "--sede=3"], "--seed"),
            (["--verison"], "--version"),
            (["simulate", "bouncing_bal"], "bouncing_ball"),
            (["plan", "motion_turntable"], "turntable"),
            (["simulate", "gas", "--engine", "fsat"], "fast"),
        ]:
            self.assertRegex(self.refused(*words, says="unknown" if words[0] not in ("simulate", "plan") else ""),
                             rf"did you mean (.*(, | or ))?{re.escape(meant)}\b", words)

    def test_an_option_that_was_renamed(self):
        self.refused("check", "--stems", "mass", says="--stems: is --queries now; see `touchstone help check`")

    def test_nothing_is_suggested_where_nothing_is_near(self):
        for words in (["frobnicate"], ["ask", "xyzzy", "a.json"], ["check", "--effort", "x" * 1000]):
            self.assertNotIn("did you mean", self.refused(*words, says="unknown; there are"))


class Errors(Test):
    def test_they_begin_with_the_program_and_end_with_what_to_do(self):
        for words, help_words in [
            ([], "help"), (["reprot"], "help"), (["--colour"], "help"), (["check", "--colour"], "help check"),
            (["check", "--seed"], "help check"), (["check", "--seed", "x"], "help check"), (["ask"], "help ask"),
            (["ask", "mass"], "help ask"), (["ask", "mass", "a.json", "more"], "help ask"), (["list", "x"], "help list"),
            (["soak", "--jobs", "0"], "help soak"), (["check", "--seed", "1", "--seed", "2"], "help check"),
        ]:
            error = self.refused(*words, says="")
            self.assertTrue(error.startswith("touchstone: "), error)
            self.assertIn(f"`touchstone {help_words}`", error.splitlines()[0], words)
            self.assertNotIn("--help-all for more", error)

    def test_the_launcher_has_the_tests(self):
        for words in (["test"], ["test", "-R", "model"], ["test", "--preset", "asan"]):
            self.refused(*words, says=["touchstone: test: ", "./touchstone test"])

    def test_the_launcher_has_the_source_to_mutate(self):
        for words in (["mutate"], ["mutate", "--sample", "3"]):
            self.refused(*words, says=["touchstone: mutate: ", "./touchstone mutate"])


class Numbers(Test):
    def test_seeds(self):
        for seed in ("1e3", "0x10", "1.5", "-1", "+1", " 1", "1 ", "", "nan", "1_000", "1'000", "٣", str(LARGEST_SEED + 1),
                     "9" * 1000):
            self.refused("soak", "--pairs", 1, "--seed", seed,
                         says=[f"--seed: expected a whole number from 0 to {LARGEST_SEED}, found \"{seed}\""])
        for seed, meant in [("0", 0), ("010", 10), (str(LARGEST_SEED), LARGEST_SEED), (str(2**53 + 1), 2**53 + 1)]:
            self.assertIn(f"seed {meant}:", self.succeeds("soak", "--pairs", 1, "--seed", seed))

    def test_counts(self):
        for command, option in [("check", "--cases"), ("check", "--jobs"), ("report", "--cases"), ("soak", "--pairs"),
                                ("soak", "--jobs"), ("minimise", "--budget"), ("bench", "--rounds")]:
            for value in ("0", "-3", "1e3", "0x10", "1.5", "99999999999", "many"):
                argument = {"minimise": ["a.json"], "bench": ["distance"]}.get(command, [])
                self.refused(command, *argument, option, value,
                             says=[f"{option}: expected a whole number from 1 to ", f'found "{value}"'])

    def test_seconds(self):
        for value in ("0", "-1", "nan", "inf", "1e9", "0x10", "1s", "", "1e-400"):
            self.refused("check", "--time-limit", value, says=["--time-limit: expected seconds", f'found "{value}"'])
        for value in ("0", "1e10", "nan"):
            self.refused("simulate", "gas", "--until", value, says="--until: expected seconds")


class Help(Test):
    def test_help_is_a_command_too(self):
        everything = self.succeeds("help")
        self.assertEqual(everything, self.succeeds("--help"))
        self.assertLessEqual(max(map(len, everything.splitlines())), 120)
        self.assertLessEqual({"report", "check", "test", "bench", "help", "completion"}, set(commands(everything)))
        for command in commands(everything):
            self.assertEqual(self.succeeds("help", command), self.succeeds(command, "--help"))

    def test_each_command_has_examples_exit_codes_and_names_for_its_values(self):
        for command in commands(self.succeeds("help")):
            text = self.succeeds("help", command)
            self.assertRegex(text, rf"Examples:\n  (.*\| )?(source <\()?(\./)?touchstone {command}\b", command)
            self.assertIn("Exit codes:\n  0 ", text, command)
            self.assertNotRegex(text, r"\b(TEXT|INT|UINT|FLOAT)\b", command)
            self.assertLessEqual(max(map(len, text.splitlines())), 120, command)

    def test_examples_are_accepted_by_the_command_line(self):
        """Checks, without their files and minutes, that each option in an example exists."""
        for command in commands(self.succeeds("help")):
            options, examples = self.succeeds("help", command).split("Examples:")
            for line in examples.split("\n\n")[0].splitlines():
                if command in ("test", "mutate") or f"touchstone {command}" not in line:
                    continue
                for option in re.findall(r" (--[a-z-]+)", re.sub(r'"exec:[^"]*"', "", line.split("|")[0])):
                    self.assertIn(option, options, line)


class Stdin(Test):
    def run_with(self, content, *words):
        return subprocess.run([PROGRAM, *as_asked(words)], cwd=self.folder, capture_output=True, text=True, timeout=60,
                              input=content if isinstance(content, str) else json.dumps(content))

    def test_scenes(self):
        self.file("balls.json", TWO_BALLS)
        for words in (["ask", "distance"], ["plan"]):
            self.assertEqual(self.run_with(TWO_BALLS, *words, "-").stdout, self.succeeds(*words, "balls.json"))
        self.assertIn("impact 0", self.run_with(TWO_BALLS, "simulate", "-", "--until", "1", "--engine", "inproc:fast").stdout)

    def test_a_mesh_and_what_is_made_of_it(self):
        mesh = "".join(f"v {x} {y} {z}\n" for x, y, z in TETRAHEDRON) + "f 1 2 3\n"
        imported = self.run_with(mesh, "import", "-")
        self.assertEqual(self.run_with(imported.stdout, "ask", "mass", "-").returncode, 0, imported.stderr)

    def test_a_smaller_case_gets_a_name(self):
        case = {"touchstone": "case/1", "property": "distance.survives", "subject": "inproc:reference", "seed": 1, "index": 0,
                "finding": {"outcome": "holds", "defect": "none", "error": 0, "allowed": 0}, "scene": TWO_BALLS}
        self.assertIn("holds", self.run_with(case, "replay", "-").stdout)
        done = self.run_with(case, "minimise", "-", "--subject", f"exec:{CANARY} canary.nan")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual([p.name for p in self.folder.iterdir()], ["smaller.json"])


class SceneByName(Test):
    def test_it_can_be_asked_about(self):
        by_file = self.succeeds("ask", "mass", SOURCE / "docs/scenes/motion/billiards/newtons_cradle.json")
        self.assertEqual(self.succeeds("ask", "mass", "newtons_cradle"), by_file)


class Completion(Test):
    def completed(self, *words):
        """The words that bash offers as completions of the last of these words."""
        script = self.succeeds("completion", "bash")
        quoted = " ".join("'" + word + "'" for word in ("touchstone", *words))
        run = f"{script}\nCOMP_WORDS=({quoted})\nCOMP_CWORD={len(words)}\n_touchstone\nprintf '%s\\n' \"${{COMPREPLY[@]}}\""
        done = subprocess.run(["bash", "--norc", "-u", "-c", run], cwd=self.folder, capture_output=True, text=True, timeout=60)
        self.assertEqual((done.returncode, done.stderr), (0, ""), words)
        return done.stdout.split()

    def test_commands(self):
        self.assertEqual(self.completed("re"), ["report", "replay"])
        self.assertEqual(self.completed("help", "che"), ["check"])
        self.assertEqual(set(self.completed("")), set(commands(self.succeeds("help"))))

    def test_every_option_of_every_command(self):
        for command in commands(self.succeeds("help")):
            options = set(re.findall(r"(?m)^  (?:-h,)?(--[a-z-]+)", self.succeeds("help", command)))
            self.assertEqual(set(self.completed(command, "-")), options, command)

    def test_values(self):
        for words, offered in [
            (["check", "--effort", ""], ["quick", "standard", "soak"]),
            (["check", "--effort", "=", "st"], ["standard"]),
            (["check", "--effort", "="], ["quick", "standard", "soak"]),
            (["check", "--seed", "3", "--effort", "so"], ["soak"]),
            (["check", "--queries", "dist"], ["distance"]),
            (["check", "--queries", "mass,dist"], ["mass,distance"]),
            (["check", "--properties", "distance.val"], ["distance.value"]),
            (["check", "--queries", "simul"], ["simulation"]),
            (["ask", "simul"], []),
            (["check", "--subjects", "refer"], ["reference"]),
            (["ask", "pene"], ["penetration"]),
            (["ask", "--json", "pene"], ["penetration"]),
            (["ask", "distance", "bouncing_ball_fo"], ["bouncing_ball_forever"]),
            (["simulate", "turntable_t"], ["turntable_tilted"]),
            (["simulate", "--until", "3", "turntable_t"], ["turntable_tilted"]),
            (["simulate", "gas", "--engine", "ode"], ["ode", "ode.quick"]),
            (["list", "can"], ["canaries"]),
            (["bench", "pix"], ["pixel"]),
            (["completion", ""], ["bash", "zsh"]),
            (["check", "--seed", ""], []),
            (["check", "nothing_comes_here"], []),
            (["nonsense", ""], []),
        ]:
            self.assertEqual(self.completed(*words), offered, words)

    def test_bash_knows_it_by_the_programs_name(self):
        script = self.succeeds("completion", "bash")
        done = subprocess.run(["bash", "--norc", "-c", script + "\ncomplete -p touchstone"], capture_output=True, text=True)
        self.assertEqual(done.stdout, "complete -o default -F _touchstone touchstone\n")

    @unittest.skipUnless(shutil.which("zsh"), "zsh is not installed")
    def test_zsh_reads_its_script(self):
        script = self.file("completion.zsh", self.succeeds("completion", "zsh"))
        done = subprocess.run(["zsh", "-f", "-c", f"source ./{script} && whence -w _touchstone"], cwd=self.folder,
                              capture_output=True, text=True)
        self.assertEqual((done.stdout, done.stderr), ("_touchstone: function\n", ""))


if __name__ == "__main__":
    unittest.main()
