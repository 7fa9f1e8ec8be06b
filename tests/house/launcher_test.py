"""Usage: launcher_test.py ROOT CMAKE. Tests the launcher and its output, with stand-ins for the slow tools."""

import fcntl
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT, CMAKE = pathlib.Path(sys.argv[1]), sys.argv[2]
STAND_INS = {
    "dpkg-query": "echo installed",
    "apt-get": "exit 1",
    # Configures the folder after -B, and keeps its words.
    "cmake": 'echo "$*" >"${0%/*}/../configured"; while [ "$1" != -B ]; do shift; done; touch "$2/build.ninja"; echo "-- Not on trial: ode (not found)"',
    # Says that it has written a file with the name of its words.
    "cpack": 'shift; echo "CPack: - package: $1 $3 generated."',
    # Builds a program that prints its own path.
    "ninja": 'mkdir -p "$2/bin"; printf "#!/bin/sh\\necho \\$0 \\$*\\n" >"$2/bin/touchstone"; chmod +x "$2/bin/touchstone"',
}
TOOLS = ["awk", "basename", "bash", "cat", "cp", "dirname", "dpkg-deb", "env", "flock", "id", "mkdir", "mktemp", "mv", "nproc", "readlink",
         "realpath", "rm", "sed", "sh", "touch", "chmod"]


class Launcher(unittest.TestCase):
    """A source folder that contains only the launcher; beside it the build folder and the tools."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="touchstone_")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.source, self.build, self.tools = (self.folder / name for name in ["source", "elsewhere", "tools"])
        self.source.mkdir()
        self.tools.mkdir()
        shutil.copy(ROOT / "touchstone", self.source)
        for tool in TOOLS:
            (self.tools / tool).symlink_to(shutil.which(tool))
        for tool, script in STAND_INS.items():
            (self.tools / tool).write_text(f"#!/bin/sh\n{script}\n")
            (self.tools / tool).chmod(0o755)

    def started(self, *words):
        return subprocess.Popen([self.source / "touchstone", *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                env={"PATH": str(self.tools), "TOUCHSTONE_BUILD": str(self.build)})

    def run_launcher(self, *words):
        process = self.started(*words)
        output, errors = process.communicate(timeout=60)
        return process.returncode, output, errors

    def test_another_build_folder_leaves_the_source_alone(self):
        code, output, errors = self.run_launcher("list", "subjects")
        self.assertEqual((code, output), (0, f"{self.build}/bin/touchstone list subjects\n"), errors)
        self.assertEqual([p.name for p in self.source.iterdir()], ["touchstone"])
        self.assertIn("Not on trial: ode", errors)

    def test_help_of_its_own_commands_is_the_programs(self):
        """The help needs no more than the program: neither the tests nor the comparisons are built for it."""
        for words in ["test", "--help"], ["test", "-h"], ["bench", "--help"]:
            code, output, errors = self.run_launcher(*words)
            self.assertEqual((code, output), (0, f"{self.build}/bin/touchstone {' '.join(words)}\n"), errors)
        self.assertEqual([p.name for p in self.build.iterdir() if p.name.startswith(".set-up-for")], [".set-up-for-program"])

    def test_mutants_have_a_build_folder_and_packages_of_their_own(self):
        """The tester builds what it needs after it has read its words; the program has no part in it."""
        tester = self.source / "tests/mutation/mutate.py"
        tester.parent.mkdir(parents=True)
        tester.write_text("import sys; print(*sys.argv[1:])")
        for words in ["--sample", "3"], ["--help"]:
            code, output, errors = self.run_launcher("mutate", *words)
            self.assertEqual((code, output), (0, f"--build {self.build}-mutate {' '.join(words)}\n"), errors)
        stamp = pathlib.Path(f"{self.build}-mutate/.set-up-for-mutation")
        self.assertIn("python3-clang", stamp.read_text())
        self.assertFalse(self.build.exists())

    def test_engines_become_subjects(self):
        """Parts of adapters do not; the source is left alone, and nothing is built."""
        for name in ["js/touchstone_adapter.mjs", "engines/some.mjs", "engines/some_bodies.mjs", "engines/package.json"]:
            file = self.source / "adapters" / name
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(name)
        for name, script in {"npm": 'echo "$*" >"${0%/*}/../asked"', "node": 'cat "$1"'}.items():
            (self.tools / name).write_text(f"#!/bin/sh\n{script}\n")
            (self.tools / name).chmod(0o755)
        code, output, errors = self.run_launcher("engines")
        self.assertEqual((code, output), (0, "some\n"), errors)
        engines = self.build / "adapters/engines"
        self.assertEqual((self.folder / "asked").read_text(), f"ci --prefix {self.build}/adapters.new/engines --no-audit --no-fund\n")
        subjects = self.build / "subjects"
        self.assertEqual([p.name for p in subjects.iterdir()], ["touchstone-subject-some"])
        said = subprocess.run([subjects / "touchstone-subject-some"], capture_output=True, text=True, env={"PATH": str(self.tools)})
        self.assertEqual(said.stdout, "engines/some.mjs")
        self.assertFalse((self.build / "build.ninja").exists())
        (self.tools / "npm").write_text("#!/bin/sh\necho no network >&2\nexit 1\n")
        code, output, errors = self.run_launcher("engines")
        self.assertEqual((code, output), (3, ""), errors)
        self.assertIn("no network", errors)
        self.assertTrue((engines / "some.mjs").exists(), "what was installed before is gone")
        code, output, errors = self.run_launcher("engines", "bullet")
        self.assertEqual((code, output), (2, ""), errors)

    def test_a_minimal_build_needs_no_engine_and_no_browser_library(self):
        """It has a build folder of its own, and fetches no meshes: apt-get, which fails here, is not asked."""
        code, output, errors = self.run_launcher("--minimal", "check", "--minimal")
        self.assertEqual((code, output), (0, f"{self.build}-minimal/bin/touchstone check --minimal\n"), errors)
        self.assertEqual((self.folder / "configured").read_text().split()[:2], ["--preset", "minimal"])
        needed = pathlib.Path(f"{self.build}-minimal/.set-up-for-program").read_text().split()
        self.assertIn("libcgal-dev", needed)
        for of_others in ["bullet", "fcl", "ccd", "ode", "simbody", "three", "pkg-config"]:
            self.assertEqual([package for package in needed if of_others in package], [])
        self.assertNotIn("meshes", errors)
        self.assertFalse(self.build.exists())

    def test_what_a_minimal_build_cannot_do_is_refused(self):
        for command in ["test", "bench", "mutate"]:
            code, output, errors = self.run_launcher("--minimal", command)
            self.assertEqual((code, output), (2, ""))
            self.assertIn(f"--minimal is a build of the program alone, without {command}", errors)
        self.assertFalse(pathlib.Path(f"{self.build}-minimal").exists())

    def test_packages(self):
        """Their paths are printed. Where Debian's tools are missing, no Debian package is asked for."""
        (self.tools / "dpkg-shlibdeps").symlink_to(shutil.which("true"))
        for words, folder in [["package"], self.build], [["--minimal", "package"], f"{self.build}-minimal"]:
            code, output, errors = self.run_launcher(*words)
            self.assertEqual((code, output), (0, f"{folder}/CPackConfig.cmake TGZ;DEB\n"), errors)
            self.assertIn("dpkg-dev file", pathlib.Path(f"{folder}/.set-up-for-package").read_text())
        (self.tools / "dpkg-shlibdeps").unlink()
        self.assertEqual(self.run_launcher("package")[:2], (0, f"{self.build}/CPackConfig.cmake TGZ\n"))
        code, output, errors = self.run_launcher("package", "everything")
        self.assertEqual((code, output), (2, ""))
        self.assertIn("no further words are expected, found everything", errors)

    def test_a_folder_that_cannot_be_made_is_named(self):
        (self.folder / "elsewhere").write_text("a file")
        code, output, errors = self.run_launcher("list")
        self.assertEqual((code, output), (3, ""))
        self.assertIn(f"{self.build}; name one that can be written: TOUCHSTONE_BUILD=FOLDER", errors)

    def test_it_says_which_process_it_waits_for(self):
        self.build.mkdir()
        with open(self.build / ".lock", "w") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            lock.write("4711\n")
            lock.flush()
            process = self.started("list")
            said = process.stderr.readline()
        output, errors = process.communicate(timeout=60)
        self.assertIn(f"waiting for process 4711, which sets up or builds in {self.build}", said)
        self.assertEqual((process.returncode, (self.build / ".lock").read_text()), (0, f"{process.pid}\n"), errors)

    def test_tools_that_are_missing_are_named(self):
        for tool in ["apt-get", "cmake", "ninja"]:
            (self.tools / tool).unlink()
        code, output, errors = self.run_launcher("list")
        self.assertEqual((code, output), (3, ""))
        for what in ["a C++20 compiler", "CMake 3.25", "Ninja", "pkg-config"]:
            self.assertIn(what, errors)

    def test_libraries_that_are_missing_are_named_all_at_once(self):
        done = subprocess.run([CMAKE, "-G", "Ninja", "-S", ROOT, "-B", self.build, "-DCMAKE_IGNORE_PREFIX_PATH=/usr;/usr/local",
                               "-DTOUCHSTONE_TESTS=ON"], capture_output=True, text=True)
        self.assertNotEqual(done.returncode, 0)
        for what in ["Eigen 3.4", "CGAL 5 or 6", "MPFI", "CLI11", "Catch2 2 or 3", "Debian's package libfmt-dev"]:
            self.assertIn(what, done.stderr)


unittest.main(argv=sys.argv[:1])
