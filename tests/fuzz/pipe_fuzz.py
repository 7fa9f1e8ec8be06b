"""Sends mutated scenes to a subject's program: it must answer every query and stay alive.

usage: pipe_fuzz.py PROGRAM [--count 20000] [--seed 1] [--first 0] [--time-limit 20] [--say]

Query i of a seed does not depend on earlier queries. Exit code 1: the program crashed, hung, or printed something else
than one answer. Each such query is printed, to be added to kept.jsonl, whose lines are sent before all others."""

import argparse
import collections
import json
import os
import pathlib
import random
import select
import subprocess
import sys
import tempfile
import time

import mutation
import scenes

QUESTIONS = list(scenes.questions())
TICK = os.sysconf("SC_CLK_TCK")


def question(seed, index):
    """The line to send, with its seq, 1 + index; sometimes it is not even a query."""
    chance = random.Random(f"{seed} {index}")
    query, scene = chance.choice(QUESTIONS)
    asked = mutation.mutated(chance, scene, scenes.SHAPES) if index % 20 else scene
    if chance.random() < 0.02:
        query = chance.choice(["", "distanz", "mass"])
    message = {"op": "ask", "seq": 1 + index, "query": query, "scene": asked}
    if chance.random() < 0.01:
        message = chance.choice(ACCIDENTS_OF_MESSAGES)(message)
    return mutation.text_of(message)


ACCIDENTS_OF_MESSAGES = [lambda m: m["scene"], lambda m: [m], lambda m: {**m, "seq": -1}, lambda m: {**m, "op": "sing"},
                         lambda m: {**m, "seq": "1"}, lambda m: {"op": "ask", "seq": m["seq"]}, lambda m: None,
                         lambda m: {**m, "op": "start", "protocol": 2}, lambda m: {**m, "x": 1}, lambda m: {"op": "stop", "x": 0}]


class Program:
    def __init__(self, command, limit):
        self.command, self.limit = command, limit
        self.start()

    def start(self):
        self.errors = tempfile.TemporaryFile()
        self.process = subprocess.Popen(self.command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=self.errors)
        self.unread = b""

    def cpu_seconds(self):
        words = pathlib.Path(f"/proc/{self.process.pid}/stat").read_text().rsplit(")", 1)[1].split()
        return (int(words[11]) + int(words[12])) / TICK

    def last_words(self):
        self.errors.seek(0)
        return self.errors.read().decode(errors="replace")[:6000]

    def ask(self, line):
        """Returns (its answer, None) or (None, what went wrong); in the second case it has been restarted."""
        began, before = time.monotonic(), self.cpu_seconds()
        try:
            self.process.stdin.write(line.encode() + b"\n")
            self.process.stdin.flush()
        except BrokenPipeError:
            pass
        while b"\n" not in self.unread:
            if select.select([self.process.stdout], [], [], 1)[0]:
                read = os.read(self.process.stdout.fileno(), 1 << 20)
                if not read:
                    return None, self.anew(f"crashed: exit status {self.process.wait()}\n{self.last_words()}")
                self.unread += read
            elif self.cpu_seconds() - before > self.limit or time.monotonic() - began > 30 * self.limit:
                self.process.kill()
                return None, self.anew(f"hung: no answer within {self.limit} s of its CPU time")
        answer, self.unread = self.unread.split(b"\n", 1)
        return answer.decode(), None

    def anew(self, wrong):
        self.process.wait()
        self.process.stdin.close()
        self.process.stdout.close()
        self.start()
        return wrong

    def end(self):
        self.process.stdin.close()
        return self.process.wait()


def kind_of(answer, line):
    """Returns "result", "abstains" or "breaks"; or what is wrong with the answer."""
    try:
        said = json.loads(answer)
    except json.JSONDecodeError:
        return None, f"not JSON: {answer[:300]}"
    if set(said) - {"seq", "result", "abstains", "breaks"} or len(said) != 2 or "seq" not in said:
        return None, f"not one answer: {answer[:300]}"
    kind = next(key for key in said if key != "seq")
    try:
        asked = json.loads(line)["seq"]
    except (ValueError, TypeError, KeyError):
        asked = 0
    if said["seq"] not in (asked, 0) or (said["seq"] == 0 and kind != "breaks"):
        return None, f"another seq: {answer[:300]}"
    return kind, None


def lines(options):
    for kept in (pathlib.Path(__file__).parent / "kept.jsonl").read_text().splitlines():
        yield "kept", kept
    for i in range(options.first, options.first + options.count):
        yield i, question(options.seed, i)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=20000)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--time-limit", type=float, default=20)
    parser.add_argument("--say", action="store_true", help="print how each breaks, and what took longest")
    options = parser.parse_args()
    program = Program([options.program], options.time_limit)
    kinds, breaks, failures = collections.Counter(), collections.Counter(), 0
    longest = (0, None)
    for index, line in lines(options):
        before = time.monotonic()
        answer, wrong = program.ask(line)
        longest = max(longest, (time.monotonic() - before, str(index)))
        kind = None
        if answer is not None:
            kind, wrong = kind_of(answer, line)
        if wrong:
            failures += 1
            print(f"question {index}: {wrong}\n{line}", flush=True)
            continue
        kinds[kind] += 1
        if kind == "breaks":
            breaks[json.loads(answer)["breaks"]["how"][:100]] += 1
    if options.say:
        for how, count in breaks.most_common():
            print(f"{count:6} {how}")
    status = program.end()
    if status != 0:
        failures += 1
        print(f"exit status {status}\n{program.last_words()}")
    print(f"{options.program}: {dict(kinds)}, {failures} failures; the longest took {longest[0]:.1f} s (question {longest[1]})")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
