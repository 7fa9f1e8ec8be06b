"""Usage: unity_test.py ROOT. No two sources of fast give one name to two constants or types in the anonymous namespaces
of one namespace: fast is compiled several sources at a time, and which of them come together changes with the list."""

import collections
import pathlib
import re
import sys

NAMESPACE = re.compile(r"^namespace (touchstone[\w:]*) \{", re.MULTILINE)
ANONYMOUS = re.compile(r"^namespace \{\n(.*?)^\}  // namespace$", re.MULTILINE | re.DOTALL)
NAMED = re.compile(r"^(?:constexpr|const) [\w:<>, ]+? (\w+)(?:\[\w*\])? ?[={]|^(?:struct|class|enum class) (\w+)", re.MULTILINE)


def names(text):
    """namespace::name of each constant and type in the anonymous namespaces of a source."""
    outer = NAMESPACE.search(text)
    for inner in ANONYMOUS.findall(text):
        for constant, kind in NAMED.findall(inner):
            yield f"{outer.group(1) if outer else ''}::{constant or kind}"


def shared_names(sources):
    """sources: file -> text."""
    files = collections.defaultdict(set)
    for file, text in sources.items():
        for name in names(text):
            files[name].add(file)
    return [f"{name} is defined in {', '.join(sorted(where))}" for name, where in sorted(files.items()) if len(where) > 1]


def test_the_test():
    source = "namespace touchstone::fast {\nnamespace {\n\n%s\n\n}  // namespace\n}\n"
    one, other = source % "constexpr double most = 1;", source % "struct most {\n};"
    assert shared_names({"a.cpp": one, "b.cpp": other}) == ["touchstone::fast::most is defined in a.cpp, b.cpp"]
    assert not shared_names({"a.cpp": one, "b.cpp": other.replace("::fast", "::fast::pixel")})
    assert not shared_names({"a.cpp": one, "b.cpp": source % "  constexpr int most = 1;"})


def main(root):
    test_the_test()
    sources = {path.relative_to(root).as_posix(): path.read_text() for path in sorted((root / "fast").rglob("*.cpp"))}
    assert len(sources) > 50, "the tree was not found"
    sys.exit("\n".join(shared_names(sources)) or 0)


main(pathlib.Path(sys.argv[1]).resolve())
