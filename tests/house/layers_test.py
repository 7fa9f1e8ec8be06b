"""Usage: layers_test.py ROOT. Holds every #include to the table of layers; cmake/layers.cmake must say the same."""

import pathlib
import re
import sys

# What a layer may include of the others. Two laws: reference and fast never see each other; the judge (oracle, properties)
# never knows who is on trial.
MAY_USE = {
    "model": set(),
    "reference": {"model"},
    "fast": {"model"},
    "oracle": {"model", "reference"},
    "subject": {"model", "oracle"},
    "properties": {"model", "oracle"},
    "app": {"model", "reference", "fast", "oracle", "subject", "properties"},
    "tests": {"model", "reference", "fast", "oracle", "subject", "properties", "app"},
}

# Foreign headers that belong to some files only: (header, files that may include it).
EXACT = r"CGAL/|gmp|mpfr|boost/multiprecision"
BEHIND = [
    (EXACT, r"reference/\w+\.cpp|reference/\w+_impl\.h|oracle/subjects/cgal\.cpp|tests/.*"),
    (r"rapidcheck", r"properties/(domain|rapidcheck)\w*\.(h|cpp)|tests/.*"),
    (r"catch2/", r"tests/catch\.h"),  # which knows versions 2 and 3
    (r"benchmark/", r"tests/bench/.*"),
    (r"bt[A-Z]\w*\.h|Bullet\w*/|LinearMath/", r"oracle/subjects/bullet\w*\.(h|cpp)|tests/bench/(broad_phase|distance)/bullet\.cpp"),
    (r"fcl/", r"oracle/subjects/fcl\w*\.(h|cpp)|tests/bench/(broad_phase|distance)/fcl\.cpp"),
    (r"ccd/", r"oracle/subjects/(libccd|ccd)\w*\.(h|cpp)|tests/bench/distance/libccd\.cpp"),
    (r"ode/", r"oracle/subjects/ode\w*\.(h|cpp)|tests/bench/broad_phase/ode\.cpp"),
    (r"Simbody\.h|simbody/|SimTK", r"oracle/subjects/simbody\w*\.(h|cpp)"),
    (r"CLI/", r"app/.*|oracle/subjects/\w*main\.cpp|tests/bench/command_line\.cpp"),
    (r"iostream", r".*\.cpp"),  # every file that includes it pays for its static initialisers
]

# What is seen of no engine's adapter but its own: the file that adapts our reference or our fast.
OWN_ADAPTER = re.compile(r"oracle/subjects/(?:touchstone_)?(reference|fast)\w*\.(h|cpp)$")


def layer_of(path):
    return "subject" if path.startswith("oracle/subjects/") else path.split("/")[0]


def complaint(file, header, is_quoted):
    """What is wrong with `file` including `header`, or None."""
    layer = layer_of(file)
    if is_quoted:
        if "/" not in header:
            return f'write the whole path of "{header}"'
        other = layer_of(header)
        if other == layer or other in MAY_USE[layer]:
            if other == "reference" and layer != "reference" and header.endswith("_impl.h"):
                return f"{header} is the reference's own: only exact value types pass its door"
            return None
        own = OWN_ADAPTER.match(file)
        if own and own.group(1) == other:
            return None
        return f"layer {layer} may not include layer {other} ({header})"
    for pattern, files in BEHIND:
        if re.match(pattern, header) and not re.fullmatch(files, file):
            return f"<{header}> belongs behind {files}"
    return None


def test_the_test():
    """The laws bite."""
    for file, header, is_quoted in [
        ("fast/a.cpp", "reference/distance.h", True),
        ("reference/a.cpp", "fast/distance.h", True),
        ("oracle/judge.cpp", "fast/distance.h", True),
        ("properties/distance.cpp", "fast/distance.h", True),
        ("properties/distance.cpp", "oracle/subjects/bullet.h", True),
        ("oracle/subjects/bullet.cpp", "reference/distance.h", True),
        ("oracle/subjects/reference.cpp", "fast/bounds.h", True),
        ("oracle/judge.cpp", "reference/rational_impl.h", True),
        ("model/scene.h", "oracle/subject.h", True),
        ("properties/distance.cpp", "fcl/fcl.h", False),
        ("reference/distance.h", "CGAL/Gmpq.h", False),
        ("oracle/judge.cpp", "gmpxx.h", False),
        ("properties/distance.cpp", "rapidcheck.h", False),
        ("oracle/subjects/fcl.cpp", "btBulletCollisionCommon.h", False),
    ]:
        assert complaint(file, header, is_quoted), (file, header)
    assert not complaint("oracle/subjects/reference.cpp", "reference/distance.h", True)
    assert not complaint("reference/distance.cpp", "CGAL/Gmpq.h", False)


def table_in_cmake(root):
    text = (root / "cmake/layers.cmake").read_text()
    rows = re.findall(r"^set\(TOUCHSTONE_MAY_USE_(\w+)([^)]*)\)", text, re.MULTILINE)
    return {layer: set(uses.split()) for layer, uses in rows}


def main(root):
    test_the_test()
    assert table_in_cmake(root) == MAY_USE, "cmake/layers.cmake and this test disagree"
    wrong, seen = [], 0
    for folder in ["model", "reference", "fast", "oracle", "properties", "app", "tests"]:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix not in {".h", ".cpp"} or "consumer" in path.parts:
                continue
            file = path.relative_to(root).as_posix()
            text = path.read_text()
            if path.suffix == ".h" and "#pragma once" not in text:
                wrong.append(f"{file}: no #pragma once")
            for header, is_quoted in re.findall(r'^\s*#\s*include\s+[<"]([^>"]+)([>"])', text, re.MULTILINE):
                seen += 1
                fault = complaint(file, header, is_quoted == '"')
                if fault:
                    wrong.append(f"{file}: {fault}")
    print(f"{seen} includes read")
    assert seen > 100, "the tree was not found"
    sys.exit("\n".join(wrong) or 0)


main(pathlib.Path(sys.argv[1]).resolve())
