"""The same bits from every build of fast: two compilers at -O0, -O2 and -O3, for any processor and for this one; and with
the C library's own fused routines masked. A build takes up to 50 s, so three of each compiler's six are made by default,
all with TOUCHSTONE_EVERY_BUILD=1. fingerprints.txt holds the bits of thirteen scenes; after a change that means to
alter them, run with TOUCHSTONE_UPDATE=1.

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
HERE = pathlib.Path(__file__).parent
PINNED = HERE / "fingerprints.txt"
EVERY_BUILD = [[optimised, *tuned] for optimised in ["-O0", "-O2", "-O3"] for tuned in [[], ["-march=native"]]]
BUILDS = EVERY_BUILD if os.environ.get("TOUCHSTONE_EVERY_BUILD") else [["-O0"], ["-O2"], ["-O3", "-march=native"]]
SCENES = ["bouncing_ball", "slide_to_roll", "ramp_sticks", "rough_ball", "newtons_cradle", "pool_break", "gas",
          "top_middle_axis", "polytopes", "needle", "arch", "turntable", "rocking_ball"]
FAST = ["bounds.cpp", "bounds/centre_of_mass.cpp", "bounds/displacement.cpp", "bounds/outward.cpp", "constraint/active_set.cpp",
        "constraint/solve.cpp", "contact/*.cpp", "exact/*.cpp", "impulse.cpp",
        "impulse/*.cpp", "lin_canny/*.cpp", "mass.cpp", "motion/*.cpp", "simulation.cpp", "simulation/*.cpp",
        "time_of_impact.cpp", "time_of_impact/*.cpp"]
READING = ["files", "json_answers", "json_motion", "json_node", "json_scene", "json_text", "limits"]


def compiled(files, options, folder):
    """Of all files one object."""
    together = folder / "together.cpp"
    together.write_text("".join(f'#include "{file}"\n' for file in files))
    built = folder / ("".join(options) + ".o")
    subprocess.run([COMPILER, "-std=c++20", "-ffp-contract=off", "-DEIGEN_DONT_VECTORIZE", "-w", *options, f"-I{SOURCE}",
                    f"-isystem{FOREIGN}", "-c", together, "-o", built], check=True)
    return built


class Fingerprints(unittest.TestCase):
    def said(self, program, **environment):
        return subprocess.run([program, *(SOURCE / f"docs/scenes/motion_{name}.json" for name in SCENES)], check=True,
                              capture_output=True, text=True, env={**os.environ, **environment}).stdout

    @unittest.skipUnless(shutil.which(COMPILER), f"{COMPILER} is not installed")
    def test_every_build_gives_the_pinned_bits(self):
        fast = sorted(file for pattern in FAST for file in (SOURCE / "fast").glob(pattern))
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            reading = compiled([SOURCE / f"model/{file}.cpp" for file in READING], [], folder)
            for build in BUILDS:
                with self.subTest(build=" ".join(build)):
                    program = folder / "program"
                    subprocess.run([COMPILER, compiled([*fast, HERE / "fingerprint.cpp"], build, folder), reading, "-o", program],
                                   check=True)
                    said = self.said(program)
                    if os.environ.get("TOUCHSTONE_UPDATE"):
                        PINNED.write_text(said)
                    self.assertEqual(said, PINNED.read_text())
            self.assertEqual(self.said(program, GLIBC_TUNABLES="glibc.cpu.hwcaps=-FMA,-AVX2"), PINNED.read_text())


unittest.main(argv=sys.argv[:1])
