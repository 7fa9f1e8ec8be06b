"""Usage: unit_tests_test.py ROOT. Every source of the folders below has a unit test of its own: fast/contact/row.h and
row.cpp have tests/fast/contact/row_test.cpp, which includes the header, contains a test case, and is compiled."""

import pathlib
import sys
import tempfile

FOLDERS = ["fast/contact", "fast/simulation", "fast/simultaneous"]


def missing(root, folder):
    """What is without a unit test, and why."""
    layer = folder.split("/")[0]
    listed = (root / "tests" / layer / "CMakeLists.txt").read_text().replace(")", " ").split()
    sources = [path.relative_to(root) for path in (root / folder).rglob("*") if path.suffix in {".h", ".cpp"}]
    for source in sorted({source.with_suffix("") for source in sources}):
        test = root / "tests" / source.with_name(source.name + "_test.cpp")
        text = test.read_text() if test.exists() else ""
        if not test.exists():
            yield f"{source}: no {test.relative_to(root)}"
        elif f'#include "{source}.h"' not in text or "TEST_CASE(" not in text:
            yield f"{test.relative_to(root)}: tests nothing of {source}.h"
        elif test.relative_to(root / "tests" / layer).as_posix() not in listed:
            yield f"{test.relative_to(root)}: does not stand in tests/{layer}/CMakeLists.txt"


def test_the_test():
    with tempfile.TemporaryDirectory() as name:
        root = pathlib.Path(name)
        for file, text in [
            ("fast/a/good.h", ""), ("fast/a/good.cpp", ""), ("fast/a/in/good.h", ""), ("fast/a/bare.cpp", ""),
            ("fast/a/other.h", ""), ("fast/a/left_out.h", ""),
            ("tests/fast/CMakeLists.txt", "add_tests(\n  a/good_test.cpp\n  a/in/good_test.cpp\n  a/other_test.cpp)\n"),
            ("tests/fast/a/good_test.cpp", '#include "fast/a/good.h"\nTEST_CASE("good") {}\n'),
            ("tests/fast/a/in/good_test.cpp", '#include "fast/a/in/good.h"\nTEST_CASE("good") {}\n'),
            ("tests/fast/a/other_test.cpp", '#include "fast/a/good.h"\nTEST_CASE("good") {}\n'),
            ("tests/fast/a/left_out_test.cpp", '#include "fast/a/left_out.h"\nTEST_CASE("left out") {}\n'),
        ]:
            (root / file).parent.mkdir(parents=True, exist_ok=True)
            (root / file).write_text(text)
        assert list(missing(root, "fast/a")) == [
            "fast/a/bare: no tests/fast/a/bare_test.cpp",
            "tests/fast/a/left_out_test.cpp: does not stand in tests/fast/CMakeLists.txt",
            "tests/fast/a/other_test.cpp: tests nothing of fast/a/other.h",
        ]


def main(root):
    test_the_test()
    assert all((root / folder).is_dir() for folder in FOLDERS), "the tree was not found"
    sys.exit("\n".join(fault for folder in FOLDERS for fault in missing(root, folder)) or 0)


main(pathlib.Path(sys.argv[1]).resolve())
