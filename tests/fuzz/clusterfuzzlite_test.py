"""Usage: clusterfuzzlite_test.py ROOT. docs/examples/clusterfuzzlite/build.sh leaves what ClusterFuzzLite expects in $OUT.
A program of the test's own stands for CMake, and programs of the system for the fuzz targets."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import zipfile

BUILD = "docs/examples/clusterfuzzlite/build.sh"
CMAKE = """#!/bin/sh
echo "$@" >>"$WORK/asked"
[ "$1" = --build ] || exit 0
[ -z "$CXXFLAGS" ] || exit 9
mkdir -p "$WORK/build/fuzzers"
for name in distance parser_scene; do cp "$TARGET" "$WORK/build/fuzzers/touchstone_fuzz_$name"; done
"""


def main(root):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for each in ("bin", "work", "out"):
            (folder / each).mkdir()
        (folder / "bin/cmake").write_text(CMAKE)
        (folder / "bin/cmake").chmod(0o755)
        subprocess.run([root / BUILD], cwd=root, check=True, env={
            **os.environ, "PATH": f"{folder}/bin:{os.environ['PATH']}", "WORK": str(folder / "work"), "OUT": str(folder / "out"),
            "CXXFLAGS": "-stdlib=libc++", "TARGET": shutil.which("cmake")})
        assert "--preset fuzz" in (folder / "work/asked").read_text()
        out = folder / "out"
        assert {path.name for path in out.iterdir()} == {
            "lib", "touchstone_fuzz_distance", "touchstone_fuzz_distance.options", "touchstone_fuzz_parser_scene",
            "touchstone_fuzz_parser_scene_seed_corpus.zip"}
        libraries = {path.name.split(".so")[0] for path in (out / "lib").iterdir()}
        assert "libstdc++" in libraries and "libc" not in libraries, libraries
        seeds = zipfile.ZipFile(out / "touchstone_fuzz_parser_scene_seed_corpus.zip").namelist()
        assert len(seeds) >= 40 and len(set(seeds)) == len(seeds), len(seeds)


main(pathlib.Path(sys.argv[1]).resolve())
