"""Usage: package_test.py BUILD CPACK. Makes the tarball of BUILD and unpacks it elsewhere. The program there must find
its subjects, and the client for Python the program, whatever the current folder is."""

import os
import pathlib
import re
import shlex
import subprocess
import sys
import tarfile
import tempfile

BUILD, CPACK = sys.argv[1:]


def run(*command, **options):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=300, **options)
    assert done.returncode == 0, f"{command}\n{done.stdout}{done.stderr}"
    return done.stdout


with tempfile.TemporaryDirectory(prefix="touchstone_") as folder:
    folder = pathlib.Path(folder)
    run(CPACK, "--config", f"{BUILD}/CPackConfig.cmake", "-G", "TGZ", "-B", folder / "made")
    (packed,) = (folder / "made").glob("*.tar.gz")
    place = folder / "another place"
    with tarfile.open(packed) as tar:
        tar.extractall(place)
    (root,) = place.iterdir()
    assert root.name == packed.name.removesuffix(".tar.gz"), root
    assert sorted(path.name for path in root.iterdir()) == ["bin", "libexec", "share"], "only what runs, and its documents"
    for document in ["copyright", "scene.schema.json", "how_to/add_a_subject.md"]:
        assert (root / "share/doc/touchstone" / document).is_file(), document

    (folder / "link").symlink_to(root / "bin/touchstone")
    listed = run(folder / "link", "list", "subjects", cwd=folder)
    for subject in ["fast", "reference"]:
        assert f"\n{subject} " in "\n" + listed, listed
    asked = run(folder / "link", "check", "--subjects", "fast,reference", "--queries", "distance", "--cases", 5, cwd=folder)
    for subject in ["fast", "reference"]:
        assert re.search(rf"^{subject} +[1-9]\d* properties hold,   0 fail", asked, re.MULTILINE), asked

    line = "from touchstone_exact import *; print(exact.distance(sphere(1), sphere(2, p=(5, 0, 0))).distance)"
    environment = {**os.environ, "TOUCHSTONE": shlex.quote(str(root / "bin/touchstone")),
                   "PYTHONPATH": str(root / "share/touchstone/python"), "PYTHONDONTWRITEBYTECODE": "1"}
    assert run(sys.executable, "-c", line, cwd=folder, env=environment) == "2.0\n"
