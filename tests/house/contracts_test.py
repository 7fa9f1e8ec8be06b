"""Usage: contracts_test.py ROOT. Every public header (on top of a layer) begins with a comment that says what it is
for, and every function, class, struct, enum and constant that it declares has a contract: a /// comment above it or
behind it. A comment covers the declarations below it up to the next blank line, and that of a class its members."""

import pathlib
import re
import sys

LAYERS = ["model", "reference", "fast", "oracle", "properties"]

# Says nothing that its own line does not: another name for a type, and a class whose definition comes later.
NEEDS_NONE = re.compile(r"using\b|(class|struct|enum class) \w+;")


def code_of(line):
    """The line without its comment and its strings, in which braces would mislead."""
    return re.sub(r'//.*|"(\\.|[^"\\])*"', "", line)


def without_contract(text):
    """(line, declaration) of each declaration at namespace scope that no comment covers."""
    depth = 0  # of braces and parentheses, not counting those of namespaces
    begins, is_covered = True, False  # may a declaration begin here, and does a comment cover it
    for number, line in enumerate(text.splitlines(), 1):
        code = code_of(line).strip()
        if depth == 0 and (not line.strip() or re.match(r"#|namespace\b|\}  //", line)):
            is_covered = False
            continue
        if begins and line.startswith("///"):
            is_covered = True
        if not code:
            continue
        is_covered = is_covered or (begins and "///<" in line)
        if begins and not is_covered and not NEEDS_NONE.match(code):
            yield number, code
        depth += sum(code.count(c) for c in "{(") - sum(code.count(c) for c in "})")
        begins = depth == 0 and code[-1] in ";}"


def faults(file, text):
    if not text.startswith("// "):
        yield f"{file}:1: begins without a comment that says what the header is for"
    for number, declaration in without_contract(text):
        yield f"{file}:{number}: without a contract: {declaration}"


def test_the_test():
    """Each rule reports a violation, and accepts what is right."""
    head = "// A header.\n#pragma once\n\nnamespace touchstone {\n\n"
    for declarations, wrong in [
        ("int f();\n", 1),
        ("/// Says what.\nint f();\n\nint g();\n", 1),
        ("// No contract.\nstruct A {\n  int x = 0;\n};\n", 1),
        ("template <class T>\nT f(int a,\n    int b);\n", 1),
        ("/// Says what.\nstruct A {\n  int x = 0;\n};\n\ninline int f() {\n  return 1;\n}\nint g();\n", 2),
        ("/// Says what.\nint f();\nint g();\n", 0),
        ("int f();  ///< says what\n", 0),
        ("/// Says what.\nstruct A {\n  int x = 0;\n\n  int y() const { return 1; }\n};\n", 0),
        ("/// Says what.\ntemplate <>\nint f(int a,\n      int b);\n", 0),
        ("struct A;\n\nusing B = int;\n", 0),
    ]:
        found = list(faults("a.h", head + declarations + "\n}  // namespace touchstone\n"))
        assert len(found) == wrong, (declarations, found)
    assert list(faults("a.h", "#pragma once\n"))


def main(root):
    test_the_test()
    headers = [path for layer in LAYERS for path in sorted((root / layer).glob("*.h"))]
    assert len(headers) > 40, "the tree was not found"
    wrong = [fault for path in headers for fault in faults(path.relative_to(root).as_posix(), path.read_text())]
    print(f"{len(headers)} public headers read")
    sys.exit("\n".join(wrong) or 0)


main(pathlib.Path(sys.argv[1]).resolve())
