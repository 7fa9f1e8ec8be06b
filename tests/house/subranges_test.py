"""Usage: subranges_test.py ROOT. Checks that no source calls an algorithm of std::ranges that returns a subrange, nor
uses a view.

clang 14 and 15 cannot compile them with the standard library of g++ 12 (`no matching function for call to '__begin'`).
The algorithms of std and a loop do the same."""

import pathlib
import re
import sys

ALGORITHMS = ["equal_range", "find_end", "partition", "remove", "remove_if", "rotate", "search", "search_n",
              "stable_partition", "unique"]
CALL = re.compile(rf"\branges::(?:{'|'.join(ALGORITHMS)})\b|\bviews::")


def calls(text):
    """Those of a source, as (line, call)."""
    return [(number, match[0]) for number, line in enumerate(text.splitlines(), 1) for match in CALL.finditer(line)]


def test_the_test():
    assert calls("int a;\nstd::ranges::unique(v);") == [(2, "ranges::unique")]
    assert calls("for (int i : std::views::iota(0, 3))") == [(1, "views::")]
    assert not calls("std::ranges::sort(v); std::unique(a, b); std::ranges::partition_point(v, p);")


def main(root):
    test_the_test()
    folders = [top for top in sorted(root.iterdir()) if not top.name.startswith((".", "build"))]
    ours = [path for top in folders for path in sorted(top.rglob("*")) if path.suffix in {".h", ".cpp"}]
    print(f"{len(ours)} files read")
    assert len(ours) > 500, "the tree was not found"
    found = [f"{path.relative_to(root)}:{line}: {call}" for path in ours for line, call in calls(path.read_text())]
    sys.exit("\n".join(found) or 0)


main(pathlib.Path(sys.argv[1]).resolve())
