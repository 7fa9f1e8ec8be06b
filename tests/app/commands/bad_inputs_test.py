"""Each row of bad_inputs.py gives exit code 2 and a message that names the place, or the right answer; both soon."""

import concurrent.futures
import json
import os
import re
import socket
import subprocess
import tempfile
import threading
import time
import unittest

from bad_inputs import *
from program import PROGRAM, Test

MOST_BYTES = 300_000_000  # a child starts as a copy of this process, which must therefore stay small
MOST_SECONDS = 10
AT_ONCE = 2
# The memory that AddressSanitizer uses is not the reader's.
IS_SANITIZED = "TOUCHSTONE_SANITIZED" in os.environ


def steps(path):
    return [int(word[1:]) if word.startswith("[") else word for word in re.findall(r"\[\d+|[^.\[\]]+", path)] or [""]


def spoilt(base, path, value):
    document = json.loads(json.dumps(base))
    *outer, last = steps(path)
    holder = document
    for step in outer:
        holder = holder[step]
    if value is GONE:
        del holder[last]
    elif isinstance(holder, list) and last == len(holder):
        holder.append(value)
    else:
        holder[last] = value
    return document


def an_item_a_line(document):
    return json.dumps(document, indent=1)


def line_of(document, path):
    """The line of the value at this path, found by putting a mark there."""
    marked = an_item_a_line(spoilt(document, path, "@@@"))
    return marked[: marked.index('"@@@"')].count("\n") + 1


class Row:
    def __init__(self, words, says, files=None, stdin=None, title=""):
        self.words, self.says, self.files, self.stdin = words, says, files or {}, stdin
        self.title = f"{title or stdin or words!r}"[:120]
        self.is_right = isinstance(says, Right)


def scene_row(base, path, value, says):
    document, words = BASES[base]
    document = spoilt(document, path, value)
    name = "case.json" if base == "case" else "scene.json"
    if not isinstance(says, Right):
        said = says.replace("~: ", f"{path}: ", 1)
        place = said.partition(": ")[0]
        if "unknown key" in said or said.endswith(" now"):  # the line is that of the key, the path that of its object
            said = said.replace(place + ": ", place.rpartition(".")[0] + ": ", 1).removeprefix(": ")
        if not re.fullmatch(r"[\w.\[\]]+", place):
            place = ""
        is_there = not place or steps(place)[0] in document
        line = f":{line_of(document, place) if place else 1}:\\d+" if is_there else ""
        says = re.compile(f"touchstone: {re.escape(name)}{line}: {re.escape(said)}")
    return Row([*words, name], says, {name: an_item_a_line(document)}, title=f"{base} {path} = {value!r}")


def text_row(content, says):
    if not isinstance(says, Right):
        place = "" if says.startswith(":") else r":\d+:\d+: .*"
        says = re.compile(r"touchstone: scene\.json" + place + re.escape(says))
    return Row(["ask", "distance", "scene.json"], says, {"scene.json": content}, title=repr(content)[:60])


def mesh_row(name, content, says):
    if not isinstance(says, Right):
        says = re.compile("touchstone: " + re.escape(name + says))
    return Row(["import", name], says, {name: content}, title=f"{name} {content!r}")


def word_row(words, says, stdin=None):
    return Row(words, says if isinstance(says, Right) else re.compile(".*" + re.escape(says), re.DOTALL), stdin=stdin)


CLASSES = {
    "text": [text_row(*row) for row in TEXT],
    "shapes": [scene_row(*row) for row in SHAPES],
    "masses": [scene_row(*row) for row in MASS],
    "contacts": [scene_row(*row) for row in CONTACTS],
    "rasters": [scene_row(*row) for row in RASTERS],
    "motions": [scene_row(*row) for row in MOTIONS],
    "paths": [word_row(*row) for row in WORDS] + [word_row(words, says, stdin) for words, stdin, says in STDIN],
    "cases": [scene_row(*row) for row in CASES],
    "meshes": [mesh_row(*row) for row in MESHES],
    "names": [scene_row(*row) for row in SCENE_NAMES] + [word_row(*row) for row in NAMES],
}


def write(path, content):
    with open(path, "wb") as file:
        for piece in content.pieces() if isinstance(content, Long) else [content]:
            file.write(piece if isinstance(piece, bytes) else piece.encode())


def furnish(folder):
    """Writes the files to which the rows about paths refer."""
    write(f"{folder}/scene.json", G)
    write(f"{folder}/case_of_no_property.json", json.dumps({**CASE, "property": "distance.valeu"}))
    write(f"{folder}/case_of_no_subject.json", json.dumps({**CASE, "subject": ""}))
    for name in ("folder.json", "folder.obj"):
        os.mkdir(f"{folder}/{name}")
    for name in ("pipe", "pipe.obj"):
        os.mkfifo(f"{folder}/{name}")
    for name, target in [("link", "scene.json"), ("link_to_pipe", "pipe"), ("dangling", "nothing"), ("loop", "loop"),
                         ("zero.stl", "/dev/zero")]:
        os.symlink(target, f"{folder}/{name}")
    for name in ("huge", "huge.ply"):
        with open(f"{folder}/{name}", "wb") as file:
            file.truncate(300_000_000)
    with socket.socket(socket.AF_UNIX) as mine:
        mine.bind(f"{folder}/socket")


def run(row):
    """Returns the exit code, both streams, the greatest memory and the time."""
    with tempfile.TemporaryDirectory(prefix="touchstone_") as folder, tempfile.TemporaryFile() as out, \
            tempfile.TemporaryFile() as err:
        furnish(folder)
        for name, content in row.files.items():
            write(f"{folder}/{name}", content)
        stdin = row.stdin if (row.stdin or "").startswith("/dev/") else f"{folder}/.stdin"
        if stdin != row.stdin:
            write(stdin, row.stdin or "")
        started = time.monotonic()
        with open(stdin, "rb") as given:
            child = subprocess.Popen([PROGRAM, *row.words], cwd=folder, stdin=given, stdout=out, stderr=err)
        killer = threading.Timer(MOST_SECONDS, child.kill)
        killer.start()
        _, status, usage = os.wait4(child.pid, 0)
        killer.cancel()
        child.returncode = os.waitstatus_to_exitcode(status)
        out.seek(0)
        err.seek(0)
        texts = [stream.read().decode(errors="replace") for stream in (out, err)]
        return child.returncode, *texts, usage.ru_maxrss * 1024, time.monotonic() - started


def fault(row):
    """Says what is wrong with the program's reaction to this row; empty if nothing is."""
    code, out, err, memory, seconds = run(row)
    said = f"exit code {code}, {memory / 1e6:.0f} MB, {seconds:.1f} s: {(err or out)[:400]!r}"
    if row.is_right:
        is_well = code == 0 and row.says in out
    else:
        is_well = code == 2 and out == "" and row.says.match(err) is not None and len(err) < 4_000
    is_cheap = memory < MOST_BYTES or IS_SANITIZED
    if is_well and is_cheap and seconds < MOST_SECONDS:
        return ""
    return f"{row.title}\n    expected {row.says if row.is_right else row.says.pattern!r}\n    {said}"


class BadInputs(Test):
    def test_there_are_many_and_all_differ(self):
        rows = [row for rows in CLASSES.values() for row in rows]
        self.assertGreaterEqual(len(rows), 300)
        asked = [(str(row.words), str(row.files), str(row.stdin)) for row in rows]
        self.assertEqual(len(set(asked)), len(asked), sorted(key for key in set(asked) if asked.count(key) > 1))

    def expect_no_fault(self, name):
        with concurrent.futures.ThreadPoolExecutor(AT_ONCE) as pool:
            faults = [found for found in pool.map(fault, CLASSES[name]) if found]
        if faults:
            self.fail(f"{len(faults)} of {len(CLASSES[name])}:\n" + "\n".join(faults))


def add_test(name):
    setattr(BadInputs, f"test_{name}", lambda self: self.expect_no_fault(name))


for name in CLASSES:
    add_test(name)

if __name__ == "__main__":
    unittest.main()
