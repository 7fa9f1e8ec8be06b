"""Usage: embed_test.py ROOT BUILD CMAKE COMPILER. Installs BUILD to a new folder and builds docs/examples against that
copy alone. The three programs must print what docs/how_to/embed.md shows."""

import pathlib
import re
import subprocess
import sys
import tempfile


def run(*command):
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stdout}")
    return done.stdout


def decoys(headers, folder):
    """For each installed header a file that must not be found: one at the header's path without touchstone/."""
    for header in headers.rglob("*.h"):
        decoy = folder / header.relative_to(headers)
        decoy.parent.mkdir(parents=True, exist_ok=True)
        decoy.write_text(f"#error {decoy.relative_to(folder)} of the user's own is included\n")
    return folder


def main(root, build, cmake, compiler):
    page = (root / "docs/how_to/embed.md").read_text()
    shown = re.findall(r"^\$ build/examples/(\w+)\n(.*?)^```", page, re.DOTALL | re.MULTILINE)
    examples = root / "docs/examples"
    assert sorted(name for name, _ in shown) == sorted(path.stem for path in examples.glob("*.cpp")), "a program is missing"
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        run(cmake, "--install", build, "--prefix", folder / "installed")
        flags = f"-Wall -Wextra -Werror -I{decoys(folder / 'installed/include/touchstone', folder / 'decoys')}"
        if "TOUCHSTONE_SANITIZE:BOOL=ON" in (build / "CMakeCache.txt").read_text():
            flags += " -fsanitize=address,undefined"
        run(cmake, "-G", "Ninja", "-S", examples, "-B", folder / "examples", f"-DCMAKE_PREFIX_PATH={folder / 'installed'}",
            f"-DCMAKE_CXX_COMPILER={compiler}", f"-DCMAKE_CXX_FLAGS={flags}")
        run(cmake, "--build", folder / "examples")
        wrong = []
        for name, expected in shown:
            printed = run(folder / "examples" / name)
            if printed != expected:
                wrong.append(f"{name} prints\n{printed}and docs/how_to/embed.md shows\n{expected}")
    sys.exit("\n".join(wrong) or 0)


main(*map(pathlib.Path, sys.argv[1:]))
