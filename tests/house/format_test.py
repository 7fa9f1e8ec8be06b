"""Usage: format_test.py ROOT. Checks that clang-format would leave every C++ source as it is.

Asks clang-format 14, Debian 12's: other versions lay out some lines otherwise. Without it, as on Debian 13, says so and
exits with code 77, which CTest reports as skipped."""

import pathlib
import re
import shutil
import subprocess
import sys

VERSION = 14
SKIPPED = 77


def version_of(program):
    said = subprocess.run([program, "--version"], capture_output=True, text=True).stdout
    return int(re.search(r"version (\d+)", said).group(1))


def formatter():
    """The first clang-format of the version above; otherwise reports what there is and skips the test."""
    present = {path: version_of(path) for path in map(shutil.which, [f"clang-format-{VERSION}", "clang-format"]) if path}
    for path, version in present.items():
        if version == VERSION:
            return path
    found = ", ".join(f"{path} is version {version}" for path, version in present.items())
    print(f"Skipped: the layout is that of clang-format {VERSION}; {found or 'no clang-format is installed'}")
    sys.exit(SKIPPED)


def faults(program, root, *files, text=None):
    """What clang-format would change, as FILE:LINE:COLUMN: messages; of the text, if one is given."""
    done = subprocess.run([program, "--dry-run", "-Werror", *files], cwd=root, input=text, capture_output=True, text=True)
    assert done.returncode == 0 or done.stderr, "clang-format failed without a message"
    return done.stderr


def test_the_test(program, root):
    """The project's style is found and obeyed."""
    name = "--assume-filename=model/a.cpp"
    assert "model/a.cpp:1:" in faults(program, root, name, text="int  a( );\n")
    assert "model/a.cpp:1:" in faults(program, root, name, text="int f(int " + "a" * 70 + ", int " + "b" * 70 + ");\n")
    assert not faults(program, root, name, text="int f(int " + "a" * 40 + ", int " + "b" * 40 + ");\n")


def main(root):
    program = formatter()
    test_the_test(program, root)
    folders = [top for top in sorted(root.iterdir()) if not top.name.startswith((".", "build"))]
    ours = [path for top in folders for path in sorted(top.rglob("*")) if path.suffix in {".h", ".cpp"}]
    print(f"{len(ours)} files read")
    assert len(ours) > 500, "the tree was not found"
    sys.exit(faults(program, root, *(path.relative_to(root) for path in ours)) or 0)


main(pathlib.Path(sys.argv[1]).resolve())
