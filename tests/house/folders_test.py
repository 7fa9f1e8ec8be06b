"""Usage: folders_test.py ROOT. No folder has more than 30 files, so that a listing fits on a page."""

import collections
import pathlib
import sys
import tempfile

LIMIT = 30


def full_folders(root):
    """The folders with too many files, without builds, reports, hidden folders and compiled Python."""
    paths = (path.relative_to(root) for path in root.rglob("*") if path.is_file())
    made = (".", "build", "report")  # what the launcher and the program write, as in .gitignore
    count = collections.Counter(path.parent.as_posix() for path in paths if not path.parts[0].startswith(made))
    for folder, files in sorted(count.items()):
        if files > LIMIT and not folder.endswith("__pycache__"):
            yield f"{folder}: {files} files, at most {LIMIT}: cut it into sub-folders"


def test_the_test():
    with tempfile.TemporaryDirectory() as name:
        root = pathlib.Path(name)
        for folder, files in [("few", LIMIT), ("many/deep", LIMIT + 1), ("build-dev", LIMIT + 1),
                              ("report/cases", LIMIT + 1)]:
            (root / folder).mkdir(parents=True)
            for number in range(files):
                (root / folder / f"{number}.h").touch()
        assert list(full_folders(root)) == [f"many/deep: {LIMIT + 1} files, at most {LIMIT}: cut it into sub-folders"]


def main(root):
    test_the_test()
    assert (root / "model").is_dir(), "the tree was not found"
    sys.exit("\n".join(full_folders(root)) or 0)


main(pathlib.Path(sys.argv[1]).resolve())
