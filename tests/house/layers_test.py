"""Usage: layers_test.py ROOT. Checks every #include against the table of layers, which cmake/layers.cmake must repeat,
and every namespace against its folder."""

import pathlib
import re
import sys

# The other layers that a layer may include. Two rules matter most: reference and fast do not depend on each other;
# oracle and properties, which judge, do not depend on any subject.
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

# External headers that only some files may include: (header, files that may include it).
EXACT = r"CGAL/|gmp|mpfr|boost/multiprecision"
BEHIND = [
    (EXACT, r"reference/\w+\.cpp|reference/\w+/.*|oracle/subjects/cgal/.*|tests/.*"),
    (r"rapidcheck", r"properties/scenes/(domain|rapidcheck)\w*\.(h|cpp)|tests/.*"),
    (r"catch2/", r"tests/catch\.h"),  # which supports versions 2 and 3
    (r"benchmark/", r"tests/bench/.*"),
    (r"bt[A-Z]\w*\.h|Bullet\w*/|LinearMath/",
     r"oracle/subjects/bullet/.*|tests/bench/(bullet_shape\.h|(broad_phase|distance|time_of_impact)/bullet\.cpp)"),
    (r"fcl/", r"oracle/subjects/fcl/.*|tests/bench/(fcl_shape\.h|(broad_phase|distance|time_of_impact)/fcl\.cpp)"),
    (r"ccd/", r"oracle/subjects/libccd/.*|tests/bench/distance/libccd\.cpp"),
    (r"ode/", r"oracle/subjects/ode/.*|tests/bench/broad_phase/ode\.cpp"),
    (r"Simbody\.h|simbody/|SimTK", r"oracle/subjects/simbody/.*"),
    (r"CLI/", r"app/.*|oracle/subjects/\w+/\w*main\.cpp|tests/bench/command_line\.cpp"),
    (r"iostream", r".*\.cpp"),  # each file that includes it pays for its static initialisers
]

# Only the adapters of our reference and of our fast may include their layer; other engines' adapters may not.
OWN_ADAPTER = re.compile(r"oracle/subjects/touchstone/(reference|fast)\w*\.(h|cpp)$")

# A namespace is the folder's path: touchstone::fast::motion in fast/motion. The exceptions are (files, namespaces that
# are allowed besides).
NAMESPACES = [
    (r"model/.*", {""}),  # what all layers share needs no prefix
    (r"reference/\w+/.*", {"reference"}),  # sub-folders are private, so they need no names of their own
    (r"properties/\w+/.*", {"properties"}),
    (r"app/.*", {"app"}),
    (r"app/report/.*", {"app::page"}),
    (r"app/commands/help_texts\.h", {"app::help"}),
    (r"oracle/(judge|minimise|process|truth)/.*|oracle/tolerance/precision\.(h|cpp)", {"oracle"}),
    (r"oracle/judge/words\.(h|cpp)", {"oracle::words"}),
    (r"oracle/minimise/.*", {"oracle::shrink"}),
    (r"oracle/process/protocol\.(h|cpp)", {"oracle::protocol"}),
    (r"oracle/subjects/.*", {"oracle::subjects"}),
    (r"oracle/subjects/bullet/.*", {"oracle::subjects::in_bullet"}),  # `fcl` and `ode` are the engines' own names
    (r"oracle/subjects/fcl/.*", {"oracle::subjects::in_fcl"}),
    (r"oracle/subjects/ode/.*", {"oracle::subjects::in_ode"}),
    (r"oracle/subjects/simbody/.*", {"oracle::subjects::in_simbody"}),
    (r"fast/(bounds|broad_phase)/.*|fast/time_of_impact/(first_contact|inflation)\.h", {"fast"}),
    (r"fast/simulation/\w+/.*", {"fast::simulation"}),  # private sub-folders, without names of their own
    (r"fast/contact/\w+/.*", {"fast::contact"}),
    (r"fast/lin_canny/\w+/.*", {"fast::lin_canny"}),
    (r"properties/scenes/rapidcheck_domain\.h", {""}),  # RapidCheck finds showValue by its argument's type
    (r"tests/.*", {"", "tests"}),
    (r"tests/bench/.*", {"bench", "oracle"}),
]


# The private headers that public ones include. They are installed too (cmake/public_headers.cmake).
NEEDED_BY_PUBLIC = {
    "fast/broad_phase/strategy.h",  # collider.h: bodies' ids, and the interface of a broad phase of the user's own
    "fast/impulse/solve.h",  # impulse.h: how an impact went
    "fast/lin_canny/nearest_parts.h",  # collider.h: the result for a pair
    "fast/simulation/statistics.h",  # simulation.h: counts and energies
}


def layer_of(path):
    return "subject" if path.startswith("oracle/subjects/") else path.split("/")[0]


def complaint(file, header, is_quoted):
    """Returns what is wrong with `file` including `header`, or None."""
    layer = layer_of(file)
    if is_quoted:
        if "/" not in header:
            return f'write the whole path of "{header}"'
        other = layer_of(header)
        if other == layer or other in MAY_USE[layer]:
            is_private = header.startswith("reference/") and header.count("/") > 1
            if is_private and (layer != "reference" or re.fullmatch(r"reference/\w+\.h", file)):
                return f"{header} is private: other layers and the public headers of reference may not include it"
            if layer not in {"app", "tests"} and re.fullmatch(r"\w+/\w+\.h", file) and header.count("/") > 1:
                if header not in NEEDED_BY_PUBLIC:
                    return f"{header} is private: a public header that includes it makes it public"
            return None
        own = OWN_ADAPTER.match(file)
        if own and own.group(1) == other:
            return None
        return f"layer {layer} may not include layer {other} ({header})"
    for pattern, files in BEHIND:
        if re.match(pattern, header) and not re.fullmatch(files, file):
            return f"<{header}> belongs behind {files}"
    return None


def allowed_namespaces(file):
    """The namespaces, without touchstone::, that a file may be in: its folder's and the exceptions. A test may also be
    in the namespaces of what it tests."""
    folder = file.rsplit("/", 1)[0]
    allowed = {folder.replace("/", "::")}.union(*(names for files, names in NAMESPACES if re.fullmatch(files, file)))
    if folder.startswith("tests/"):
        tested = file.removeprefix("tests/")
        while "/" in tested:
            allowed |= allowed_namespaces(tested)
            tested = tested.rsplit("/", 1)[0]
    return allowed


def namespace_complaints(file, text):
    """What is wrong with the namespaces that a file declares in."""
    for name in sorted(set(re.findall(r"^namespace touchstone((?:::\w+)*) \{", text, re.MULTILINE))):
        if name.removeprefix("::") not in allowed_namespaces(file):
            yield f"namespace touchstone{name} is not that of its folder"


def test_the_test():
    """Each rule reports a violation, and accepts what is right."""
    for file, header, is_quoted in [
        ("fast/a.cpp", "reference/distance.h", True),
        ("reference/a.cpp", "fast/distance.h", True),
        ("oracle/judge/judge.cpp", "fast/distance.h", True),
        ("properties/distance.cpp", "fast/distance.h", True),
        ("properties/distance.cpp", "oracle/subjects/bullet/bullet.h", True),
        ("oracle/subjects/bullet/bullet.cpp", "reference/distance.h", True),
        ("oracle/subjects/touchstone/reference.cpp", "fast/bounds.h", True),
        ("oracle/judge/judge.cpp", "reference/exact/rational.h", True),
        ("tests/reference/distance_test.cpp", "reference/exact/rational.h", True),
        ("reference/distance.h", "reference/exact/rational.h", True),
        ("fast/distance.h", "fast/lin_canny/hull.h", True),
        ("properties/property.h", "oracle/judge/judge.h", True),
        ("model/scene.h", "oracle/subject.h", True),
        ("properties/distance.cpp", "fcl/fcl.h", False),
        ("reference/distance.h", "CGAL/Gmpq.h", False),
        ("oracle/judge/judge.cpp", "gmpxx.h", False),
        ("properties/distance.cpp", "rapidcheck.h", False),
        ("oracle/subjects/fcl/fcl.cpp", "btBulletCollisionCommon.h", False),
        ("oracle/subjects/common/cast.cpp", "fcl/fcl.h", False),
        ("properties/cases/pair_sets.cpp", "rapidcheck.h", False),
    ]:
        assert complaint(file, header, is_quoted), (file, header)
    for file, header, is_quoted in [
        ("oracle/subjects/touchstone/reference.cpp", "reference/distance.h", True),
        ("reference/distance.cpp", "reference/exact/rational.h", True),
        ("reference/hull/half_space.h", "reference/exact/rational.h", True),
        ("fast/collider.h", "fast/broad_phase/strategy.h", True),
        ("reference/distance.cpp", "CGAL/Gmpq.h", False),
        ("reference/exact/rational.h", "gmpxx.h", False),
        ("oracle/subjects/cgal/cgal.cpp", "CGAL/version.h", False),
    ]:
        assert not complaint(file, header, is_quoted), (file, header)
    for file, name in [
        ("fast/motion/tumble.cpp", "::fast"),
        ("fast/contact/step.h", "::fast::motion"),
        ("reference/exact/rational.h", ""),
        ("properties/distance.cpp", "::oracle"),
        ("tests/fast/motion/sine_test.cpp", "::fast::lin_canny"),
    ]:
        assert list(namespace_complaints(file, f"namespace touchstone{name} {{\n")), (file, name)
    for file, name in [
        ("model/scene.h", ""),
        ("fast/motion/tumble.cpp", "::fast::motion"),
        ("reference/exact/rational.h", "::reference"),
        ("tests/fast/motion/sine_test.cpp", "::fast::motion"),
        ("tests/fast/motion/sine_test.cpp", "::tests"),
    ]:
        assert not list(namespace_complaints(file, f"namespace touchstone{name} {{\n")), (file, name)


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
            if path.suffix not in {".h", ".cpp"}:
                continue
            file = path.relative_to(root).as_posix()
            text = path.read_text()
            if path.suffix == ".h" and "#pragma once" not in text:
                wrong.append(f"{file}: no #pragma once")
            wrong += [f"{file}: {fault}" for fault in namespace_complaints(file, text)]
            for header, is_quoted in re.findall(r'^\s*#\s*include\s+[<"]([^>"]+)([>"])', text, re.MULTILINE):
                seen += 1
                fault = complaint(file, header, is_quoted == '"')
                if fault:
                    wrong.append(f"{file}: {fault}")
    print(f"{seen} includes read")
    assert seen > 100, "the tree was not found"
    sys.exit("\n".join(wrong) or 0)


main(pathlib.Path(sys.argv[1]).resolve())
