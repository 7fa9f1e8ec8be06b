#!/usr/bin/python3
"""Publishes a report here: its page and its JSON, compressed, and the tables of README.md and of ../../../README.md.

Some of its programs in the engines' own API are run as written: those that begin with a command of g++ are built by it,
the others are run by Node.js beside the installed engines. What they print goes into a table. Counts go to stdout. Exit
code 1: a program ended with an error, or not at all.

  docs/reports/engines/publish.py report/ --build build
"""

import argparse
import collections
import concurrent.futures
import json
import lzma
import pathlib
import re
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
TOP = HERE.parents[2]
AT_MOST = 6  # programs that are run of a subject
AT_MOST_OF = {"fcl": 3}  # each takes half a minute to build
LONGEST = 150  # characters of a cell
SECONDS = {"g++": 120, "node": 60}


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("report", type=pathlib.Path, help="the folder that `touchstone report` wrote")
    parser.add_argument("--build", type=pathlib.Path, default=TOP / "build", help="default: %(default)s")
    return parser.parse_args()


def chosen(rows):
    """Failing rows with a program, by subject."""
    found = collections.defaultdict(list)
    for row in rows:
        if row.get("snippet") and (row["fails"] or row["breaks"]):
            found[row["subject"]].append(row)
    return [row for name in sorted(found) for row in found[name][:AT_MOST_OF.get(name.split(".")[0], AT_MOST)]]


def ran(program, engines):
    """Whether the program ends without an error, and what it prints, in one line. One for Node.js reads from the folder
    where the engines are installed."""
    command = program.split("\n", 1)[0].removeprefix("// ")
    with tempfile.TemporaryDirectory() as name, tempfile.NamedTemporaryFile("w", dir=engines, suffix=".mjs") as script:
        folder, words, seconds = name, ["/bin/sh", "-c", command], SECONDS["g++"]
        if command.startswith("g++"):
            pathlib.Path(name, re.search(r"\w+\.cpp", command)[0]).write_text(program)
        else:
            folder, words, seconds = engines, ["node", script.name], SECONDS["node"]
            script.write(program)
            script.flush()
        try:
            done = subprocess.run(words, cwd=folder, capture_output=True, text=True, timeout=seconds)
        except subprocess.TimeoutExpired:
            return False, f"does not end in {seconds} s"
    said = " ".join(done.stdout.split())
    if done.returncode == 0:
        return True, said
    return False, f"{said} (exit status {done.returncode}) {' '.join(done.stderr.split()[-12:])}"


def cell(text):
    text = text.replace("|", "\\|")
    return text if len(text) <= LONGEST else text[:LONGEST - 3] + "..."


def line(row, version, said):
    """A program first prints what is expected, if that is known."""
    expected = " ".join(row["finding"].get("expected", "").split())
    printed = bool(expected) and said.startswith(f"expected: {expected}")
    if printed:
        said = said.removeprefix(f"expected: {expected}").strip()
    else:
        expected = "(not printed) " + (expected or row["finding"].get("why", ""))
    return f"| `{row['subject']}` {version} | {row['property']} | {cell(said)} | {cell(expected)} |", printed


def with_table(text, begin, table):
    """The text with another table in the place of the one that begins like this."""
    blocks = text.split("\n\n")
    [place] = [i for i, block in enumerate(blocks) if block.startswith(begin)]
    blocks[place] = table
    return "\n\n".join(blocks).rstrip("\n") + "\n"


def main():
    options = arguments()
    report = json.loads((options.report / "report.json").read_text())
    versions = {subject["name"]: subject["version"] for subject in report["subjects"]}
    rows = chosen(report["rows"])
    with concurrent.futures.ThreadPoolExecutor() as pool:
        results = list(pool.map(lambda row: ran(row["snippet"], options.build / "adapters/engines"), rows))
    lines = [line(row, versions[row["subject"]], said) for row, (_, said) in zip(rows, results)]
    programs = "\n".join(["| engine | property | the program prints of the engine | and as expected |", "|---|---|---|---|",
                          *(text for text, _ in lines)])

    def summary(*words):
        run = subprocess.run([options.build / "bin/touchstone", "summary", options.report / "report.json", *words],
                             capture_output=True, text=True, check=True)
        return run.stdout.split("\n\n")[0]

    begin = "| properties that hold;"
    page = with_table((HERE / "README.md").read_text(), begin, summary())
    page = with_table(page, "| engine | property | the program", programs)
    readme = (TOP / "README.md").read_text()
    before = next(block for block in readme.split("\n\n") if block.startswith(begin))
    readme = with_table(readme, begin, summary("--subjects", ",".join(re.findall(r"(?m)^\| `([\w.]+)` ", before))))
    for name in ("index.html", "report.json"):
        text = (options.report / name).read_bytes()
        for folder in (options.report, options.build):  # its commands: from the folder of the two
            text = text.replace(f"{folder.resolve().parent}/".encode(), b"")
        (HERE / f"{name}.xz").write_bytes(lzma.compress(text, preset=9 | lzma.PRESET_EXTREME))
    (HERE / "README.md").write_text(page)
    (TOP / "README.md").write_text(readme)

    failing = [row for row in report["rows"] if row["fails"] or row["breaks"]]
    print(f"{len(failing)} failing rows, {len(report['causes'])} causes, "
          f"{len({row['subject'] for row in failing})} of {len(versions)} subjects")
    print(f"{sum(bool(row.get('snippet')) for row in failing)} programs; of {len(rows)} that were run "
          f"{sum(printed for _, printed in lines)} print what is expected")
    bad = [f"{row['subject']} {row['property']}: {said}" for row, (well, said) in zip(rows, results) if not well]
    print(*bad, sep="\n", end="\n" if bad else "")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
