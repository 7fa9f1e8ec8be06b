"""Usage: words_test.py ROOT. Checks the language of the repository: no retired words, no word with two definitions in
docs/glossary.md, sorted source lists, and no lines over 120 columns.

Reads C++ comments and identifiers, Markdown, Python docstrings and file names. String literals are not read, since
property ids, family ids and JSON keys are pinned. Reports every fault as FILE:LINE."""

import ast
import pathlib
import re
import sys
import unicodedata

WIDTH = 120

# Retired words: (words, write instead). A body, a pair and a caller are "it"; functions act, persons do not.
RETIRED = [
    ("who whom whoever whomever", "that, which"),
    ("nobody himself herself", "no body, no pair, no caller; it"),
    ("foot feet footing", "contact point; nearest point, projection"),
    ("joint joints", "contact pair"),
    ("rider riders", "island body"),
    ("flyer flyers", "rigid body model"),
    ("stance stances", "pose"),
    ("station stations", "cached pose"),
    ("swelling swellings", "inflation"),
    ("slab slabs", "separating plane"),
    ("tiling tilings", "hash grid"),
    ("roster rosters", "subject list"),
    ("crew crews", "workers"),
    ("film films", "sequence"),
    ("flight flights", "ballistic motion, motion, trajectory"),
    ("leg legs", "segment"),
    ("stem stems", "query"),
    ("hop hops", "micro-bounce"),
    ("plainer", "simpler"),
]

# Words that are English in a sentence, but retired as a part of an identifier or a file name.
RETIRED_IN_NAMES = [
    ("anew", "restart"),
    ("blow blows", "ImpactProblem"),
    ("books bookkeeper", "Statistics, EnergyReport"),
    ("course courses", "Simulation, Timeline, trajectory"),
    ("glide glides", "follow_step"),
    ("look looks", "sample, SeparationQuery"),
    ("mover movers", "body"),
    ("patience", "max_iterations"),
    ("tell tells told", "report, emit"),
    ("tires tired", "needs_restart"),
]

# Whole identifiers: words that have other good uses.
RETIRED_IDENTIFIERS = {
    "Due": "PairEvent",
    "Group": "Island",
    "Hold": "ContactConstraint",
    "Jump": "Phase",
    "Laid": "RestCandidate",
    "Meeting": "Status, FirstContact",
    "Placed": "PosedHull",
    "Push": "AppliedForce",
    "Stretch": "Phase",
    "set_out": "set_trajectory",
}

# Files in which a word keeps its place: (files, words, why).
EXCEPTIONS = [
    (r"docs/reports/.*|CHANGELOG\.md", None, "records of what was run and changed, with the words of their time"),
    (r"oracle/subjects/(dart|ode|simbody)/.*", "joint joints", "the engines' own type for a contact, or of a body"),
    (r"docs/design/generators\.md", "films flights", "groups of families, named by their pinned ids"),
]

# Files whose lines may have any width: (files, why).
ANY_WIDTH = [
    (r"docs/reports/[^/]*\.md", "written by programs: records of what was run"),
    (r"docs/spec/(clauses|canaries)\.md", "written by tests, with one row for each clause, property and canary"),
]

# Phrases in which a retired word is right, and ids that reports and case files have pinned.
KEPT = re.compile(r"""
    \b(authors?|people|persons?|readers?|someone|users?)\ who\b   # persons
  | \d{4},\ who\b                                                # the authors of a paper
  | contact\ joints?                                             # ODE's own term
  | perpendicular\ foot | foot\ of\ the\ perpendicular           # the term of geometry
  | Overmars'\ tiling                                            # Overmars' own term
  | file\ stems? | \.stem\(                                      # the name of a file without its extension
  | look_ahead
  | broad_phase\.film\b | simulation\.flights | canary\.\w+      # properties and canaries
  | films\.\w+ | flights\.\w+ | extreme\.(far_film|wild_flight)  # families of scenes
""", re.VERBOSE | re.IGNORECASE)

SOURCE_SUFFIXES = (".h", ".cpp", ".cpp.in")
TOKEN = re.compile(
    r"""(?P<comment>//[^\n]*|/\*.*?\*/)|R"(?P<mark>\w*)\(.*?\)(?P=mark)"|"(?:\\.|[^"\\\n])*"|(?<!\w)'(?:\\.|[^'\\\n])+'""",
    re.DOTALL)
SOURCE_BLOCK = re.compile(r'R"(?P<mark>\w*)\(.*?\)(?P=mark)"|// clang-format off.*?// clang-format on', re.DOTALL)
MARKDOWN_BLOCK = re.compile(r"^[ >]*```.*?^[ >]*```", re.DOTALL | re.MULTILINE)
MARKDOWN_CODE = re.compile(MARKDOWN_BLOCK.pattern + r"|`[^`\n]*`", re.DOTALL | re.MULTILINE)


def table(rows):
    return {word: instead for words, instead in rows for word in words.split()}


IN_TEXT = table(RETIRED)
IN_NAMES = IN_TEXT | table(RETIRED_IN_NAMES)


def blank(text):
    return re.sub(r"[^\n]", " ", text)


def words_of(text):
    """(word, place) of each word of a sentence."""
    for match in re.finditer(r"[A-Za-z]+", text):
        yield match.group(), match.start()


def parts_of(text):
    """(identifier, its words, place): hash_grid and HashGrid are hash, grid."""
    for match in re.finditer(r"[A-Za-z_]\w*", text):
        name = match.group()
        yield name, [part.lower() for part in re.findall(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+", name)], match.start()


def retired_in_text(text):
    """(place, word, what to write instead)."""
    for word, place in words_of(text):
        if word.lower() in IN_TEXT:
            yield place, word, IN_TEXT[word.lower()]


def retired_in_names(text):
    for name, parts, place in parts_of(text):
        if name in RETIRED_IDENTIFIERS:
            yield place, name, RETIRED_IDENTIFIERS[name]
        for part in parts:
            if part in IN_NAMES:
                yield place, part, IN_NAMES[part]


def split(text, code, keep):
    """The text with everything but `code` blanked if `keep`, otherwise with `code` blanked."""
    parts, end = [], 0
    for match in code.finditer(text):
        between, inside = text[end:match.start()], match.group()
        parts += [blank(between), inside] if keep else [between, blank(inside)]
        end = match.end()
    parts.append(blank(text[end:]) if keep else text[end:])
    return "".join(parts)


def source_parts(text):
    """(comments, code) of a C++ source, each with all else blanked."""
    comments, code, end = [], [], 0
    for match in TOKEN.finditer(text):
        between, inside = text[end:match.start()], match.group()
        comments += [blank(between), inside if match.group("comment") else blank(inside)]
        code += [between, blank(inside)]
        end = match.end()
    return "".join(comments) + blank(text[end:]), "".join(code) + text[end:]


def docstrings(text):
    """The docstrings of a Python source, with all other lines blanked."""
    lines = text.split("\n")
    kept = [blank(line) for line in lines]
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef)) and ast.get_docstring(node):
            first, last = node.body[0].lineno - 1, node.body[0].end_lineno
            kept[first:last] = lines[first:last]
    return "\n".join(kept)


def retired(file, text):
    """(place, word, what to write instead) for all retired words of a file."""
    text = KEPT.sub(lambda match: blank(match.group()), text)
    if file.endswith(SOURCE_SUFFIXES):
        comments, code = source_parts(text)
        return [*retired_in_text(comments), *retired_in_names(code)]
    if file.endswith(".md"):
        return [*retired_in_text(split(text, MARKDOWN_CODE, False)), *retired_in_names(split(text, MARKDOWN_CODE, True))]
    if file.endswith(".py"):
        return list(retired_in_text(docstrings(text)))
    return []


def is_excepted(file, word):
    return any(re.fullmatch(files, file) and (words is None or word.lower() in words.split())
               for files, words, _ in EXCEPTIONS)


def retired_words(file, text):
    for _, word, instead in retired_in_names(file):
        if not is_excepted(file, word):
            yield f'{file}:1: the file is named "{word}": write {instead}'
    for place, word, instead in sorted(retired(file, text)):
        if not is_excepted(file, word):
            yield f'{file}:{text.count(chr(10), 0, place) + 1}: "{word}" is retired: write {instead}'


def second_definitions(file, text):
    """Words in the first column of a table that stand there twice."""
    first, lines = {}, text.splitlines() + [""]
    for number, (line, following) in enumerate(zip(lines, lines[1:]), 1):
        is_rule, is_head = re.match(r"\|[-:| ]+$", line), re.match(r"\|[-:| ]+$", following)
        if not line.startswith("|") or is_rule or is_head:
            continue
        for word in re.split(r",\s*", line.split("|")[1].replace("`", "").strip().lower()):
            if word in first:
                yield f'{file}:{number}: "{word}" is defined in line {first[word]} already'
            first.setdefault(word, number)


def unsorted_sources(file, text):
    code = re.sub(r"#[^\n]*", lambda match: blank(match.group()), text)
    for match in re.finditer(r"\bSOURCES((?:\s+[^\s()]+\.cpp)+)", code):
        names = match.group(1).split()
        for before, after in zip(names, names[1:]):
            if after < before:
                place = match.start(1) + re.search(rf"(?<=\s){re.escape(after)}(?!\S)", match.group(1)).start()
                yield f"{file}:{text.count(chr(10), 0, place) + 1}: {after} belongs before {before}"
                break


def columns(line):
    """The width of a line: combining marks, as in n\u0302, have none."""
    return sum(not unicodedata.combining(character) for character in line.rstrip())


def wide_lines(file, text):
    """Lines over the width, except in code blocks, tables and link definitions of Markdown, in raw strings, and where
    clang-format is off."""
    free = MARKDOWN_BLOCK if file.endswith(".md") else SOURCE_BLOCK
    text = free.sub(lambda match: "\n" * match.group().count("\n"), text)
    for number, line in enumerate(text.splitlines(), 1):
        is_free = file.endswith(".md") and re.match(r"\s*(\||\[[^\]]+\]:)", line)
        if columns(line) > WIDTH and not is_free:
            yield f"{file}:{number}: {columns(line)} columns, at most {WIDTH}"


def complaints(file, text):
    """What is wrong with one file, as FILE:LINE: sentences."""
    yield from retired_words(file, text)
    if file == "docs/glossary.md":
        yield from second_definitions(file, text)
    if file.endswith("CMakeLists.txt"):
        yield from unsorted_sources(file, text)
    if file.endswith((*SOURCE_SUFFIXES, ".md")) and not any(re.fullmatch(files, file) for files, _ in ANY_WIDTH):
        yield from wide_lines(file, text)


def test_the_test():
    """Each rule reports a violation at its line, and accepts what is right."""
    wide = "x" * (WIDTH + 1)
    for file, text, fault in [
        ("fast/a.h", "// fine\n// The body whom no contact holds.\n", 'fast/a.h:2: "whom"'),
        ("fast/a.h", "/* a\n   foot */\n", 'fast/a.h:2: "foot"'),
        ("fast/a.h", "struct HullStation {};\n", 'fast/a.h:1: "station"'),
        ("fast/a.h", "int tell_all();\n", 'fast/a.h:1: "tell"'),
        ("fast/a.h", "struct Push {};\n", 'fast/a.h:1: "Push"'),
        ("fast/slab.h", "", 'fast/slab.h:1: the file is named "slab"'),
        ("docs/a.md", "One\nfilm.\n", 'docs/a.md:2: "film"'),
        ("docs/a.md", "The option `--stems`.\n", 'docs/a.md:1: "stems"'),
        ("tests/a.py", 'x = 1\ndef f():\n    """Two\n    riders."""\n', 'tests/a.py:4: "riders"'),
        ("oracle/subjects/bullet/a.h", "int joint;\n", 'oracle/subjects/bullet/a.h:1: "joint"'),
        ("docs/glossary.md", "| word | meaning |\n|---|---|\n| core | a |\n| row, core | b |\n",
         'docs/glossary.md:4: "core"'),
        ("fast/CMakeLists.txt", "f(x SOURCES\n  a.cpp\n  c.cpp\n  b.cpp\n  USES y)\n", "fast/CMakeLists.txt:4: b.cpp"),
        ("fast/CMakeLists.txt", "f(x SOURCES b.cpp a.cpp)\n", "fast/CMakeLists.txt:1: a.cpp"),
        ("fast/a.h", f"// fine\n// {wide}\n", "fast/a.h:2: 124 columns"),
        ("docs/a.md", f"{wide}\n", "docs/a.md:1: 121 columns"),
        ("docs/spec/a.md", f"{wide}\n", "docs/spec/a.md:1: 121 columns"),
    ]:
        found = list(complaints(file, text))
        assert len(found) == 1 and found[0].startswith(fault), (file, text, found)
    for file, text in [
        ("fast/a.h", '// Files, whose names differ.\nauto s = f("who", R"(foot)") + path.stem().string();\n'),
        ("fast/a.h", "// Of course we look at it and tell.\nint pushed, lookup, steam;\n"),
        ("docs/a.md", "A body pushes. The file stem.\n"),
        ("docs/a.md", f"| {wide} |\n[x]: {wide}\n```\n{wide}\n```\n"),
        ("fast/a.h", f'auto s = R"(\n{wide})";\n// clang-format off\n{wide}\n// clang-format on\n'),
        ("fast/a.h", "x" * (WIDTH - 2) + "n\u0302" + "n\u0302\n"),
        ("docs/reports/a.md", f"A film of flights.\n{wide}\n"),
        ("docs/spec/clauses.md", f"{wide}\n"),
        ("docs/a.md", "Authors who prove it: `broad_phase.film.events`, `canary.look_missing`.\n"),
        ("oracle/subjects/ode/a.cpp", "dJointID joint;\n"),
        ("tests/a.py", 'x = """who"""\n'),
        ("docs/glossary.md", "| word | meaning |\n|---|---|\n| core | a |\n\n| word | meaning |\n|---|---|\n| row | b |\n"),
        ("fast/CMakeLists.txt", "f(x SOURCES a.cpp a/b.cpp a_c.cpp USES b)\nf(y SOURCES a.cpp)\n"),
    ]:
        assert not list(complaints(file, text)), (file, text, list(complaints(file, text)))


def files_of(root):
    """All files of the repository that this test reads, without builds, hidden folders and installed packages."""
    for top in sorted(root.iterdir()):
        if top.name.startswith((".", "build")):
            continue
        for path in [top] if top.is_file() else sorted(top.rglob("*")):
            if "node_modules" in path.parts:
                continue
            if path.name == "CMakeLists.txt" or path.name.endswith((*SOURCE_SUFFIXES, ".md", ".py")):
                yield path


def main(root):
    test_the_test()
    wrong, seen = [], 0
    if not (root / "docs/glossary.md").exists():
        wrong.append("docs/glossary.md:1: there is no glossary")
    for path in files_of(root):
        seen += 1
        wrong += complaints(path.relative_to(root).as_posix(), path.read_text())
    print(f"{seen} files read")
    assert seen > 500, "the tree was not found"
    sys.exit("\n".join(wrong) or 0)


main(pathlib.Path(sys.argv[1]).resolve())
