"""The same bits from every build of fast: two compilers at -O0, -O2 and -O3, and at -O3 for this processor alone; and
with the C library's own fused routines masked, in one build. fingerprints.txt holds the bits of fifteen scenes; after a
change that means to alter them, run with TOUCHSTONE_UPDATE=1.

Each build compiles for up to a hundred seconds of CPU time. So the compiler of the release build is asked for that, -O3,
and the other one for -O3 for this processor. TOUCHSTONE_EVERY_BUILD=1 asks both for all.

fast's sources are compiled as one, since headers are then read once a build: no two of its files may give the same name
to different things.
"""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

COMPILER, SOURCE, FOREIGN = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3]
MODEL = sys.argv[4]  # the library that reads scenes, of whatever build: it computes nothing
BUILT = sys.argv[5]  # if not empty: the program of a release build by this compiler, -O3
HERE = pathlib.Path(__file__).parent
PINNED = HERE / "fingerprints.txt"
EVERY_BUILD = [["-O2"], ["-O3"], ["-O3", "-march=native"], ["-O0"]]
USUAL_BUILD = ["-O3", "-march=native"]  # of the compiler that has not made the program
SCENES = ["bouncing_ball", "slide_to_roll", "ramp_sticks", "rough_ball", "newtons_cradle", "pool_break", "gas",
          "top_middle_axis", "needle", "arch", "turntable", "rocking_ball", "polytopes"]
LONG_SCENES = ["coin", "rattleback"]  # 51 s and 25 s at -O0: not asked there
FAST = ["bounds.cpp", "contact/*.cpp", "contact/sparse/*.cpp", "exact/*.cpp", "impulse.cpp", "impulse/*.cpp",
        "lin_canny/*.cpp", "lin_canny/*/*.cpp", "mass.cpp", "motion/*.cpp", "outward/*.cpp", "simulation.cpp",
        "simulation/*.cpp", "simulation/*/*.cpp", "simultaneous/*.cpp", "time_of_impact.cpp", "time_of_impact/*.cpp"]
PROJECT = ["-std=c++20", "-ffp-contract=off", "-DEIGEN_DONT_VECTORIZE",  # cmake/flags.cmake says why
           *(["-fno-tree-slp-vectorize"] if COMPILER == "g++" else [])]


def compiled(files, options, folder):
    """Of all files one object."""
    together = folder / "together.cpp"
    together.write_text("".join(f'#include "{file}"\n' for file in files))
    built = folder / ("".join(options) + ".o")
    subprocess.run([COMPILER, *PROJECT, "-w", *options, f"-I{SOURCE}",
                    f"-isystem{FOREIGN}", "-c", together, "-o", built], check=True)
    return built


class Fingerprints(unittest.TestCase):
    def said(self, program, scenes, **environment):
        files = {path.stem: path for path in (SOURCE / "docs/scenes/motion").rglob("*.json")}
        return subprocess.run([program, *(files[name] for name in scenes)], check=True, capture_output=True, text=True,
                              env={**os.environ, **environment}).stdout.splitlines()

    @unittest.skipUnless(shutil.which(COMPILER), f"{COMPILER} is not installed")
    def test_every_build_gives_the_pinned_bits(self):
        fast = sorted(file for pattern in FAST for file in (SOURCE / "fast").glob(pattern))
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            builds = EVERY_BUILD if os.environ.get("TOUCHSTONE_EVERY_BUILD") else [["-O3"] if BUILT else USUAL_BUILD]
            for build in builds:
                with self.subTest(build=" ".join(build)):
                    program = folder / "program"
                    if build == ["-O3"] and BUILT:
                        program = BUILT
                    else:
                        everything = compiled([*fast, HERE / "fingerprint.cpp"], build, folder)
                        subprocess.run([COMPILER, everything, MODEL, "-o", program], check=True)
                    scenes = SCENES if build[0] == "-O0" else SCENES + LONG_SCENES
                    said = self.said(program, scenes)
                    if os.environ.get("TOUCHSTONE_UPDATE") and build == builds[0]:
                        PINNED.write_text("\n".join(said) + "\n")
                    self.assertEqual(said, PINNED.read_text().splitlines()[:len(scenes)])
                    if program == BUILT:  # the library's routines are the same whatever build calls them
                        self.assertEqual(self.said(program, scenes, GLIBC_TUNABLES="glibc.cpu.hwcaps=-FMA,-AVX2"), said)


unittest.main(argv=sys.argv[:1])
