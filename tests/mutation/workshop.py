"""Builds mutants: compiles one file as the build folder would, and links it before the library that has the original.

The linker takes the first definition of a function, so the libraries stay as they are, also where one object of theirs
holds many sources: with -fPIC the compiler must let every external function be replaced, within its own object too.
Neither the source nor what the build folder made is changed; all files of a mutant are in a folder of its own."""

import functools
import json
import pathlib
import re
import shlex
import shutil
import subprocess
import threading

import limited

COMPILER = re.compile(r"(.*/)?(c\+\+|g\+\+|clang\+\+)(-\d+)?$")
INCLUDED = re.compile(r'^#include "(.+)"$', re.MULTILINE)
COMPILE_LIMIT = 300  # CPU seconds
REPLACE = "-Wl,--allow-multiple-definition"  # the first definition is taken
# A c++ that is ccache knows the headers of the original, and may not see one that comes before them in a mutant's folder.
WITHOUT_CACHE = ("env", "CCACHE_DISABLE=1")
TAKES_A_VALUE = ("-o", "-c", "-MT", "-MF")


class BuildFailed(Exception):
    """The original does not build."""


class DoesNotLink(Exception):
    """A mutant compiles, but needs what nothing defines."""


def compile_words(command):
    """The compiler and its options, without the input and the output."""
    words = shlex.split(command)
    first = next(n for n, word in enumerate(words) if COMPILER.match(word))  # a launcher such as ccache stands before it
    words, kept = words[first:], []
    while words:
        word = words.pop(0)
        if word in TAKES_A_VALUE:
            words.pop(0)
        elif word not in ("-MD", "-Werror"):
            kept.append(word)
    return [*kept, "-w"]


def without_precompiled(words):
    """Options that libclang understands: g++'s precompiled header says nothing to it, and the sources need none."""
    kept, words = [], list(words[1:])
    while words:
        word = words.pop(0)
        if word == "-include":
            words.pop(0)
        elif word != "-Winvalid-pch":
            kept.append(word)
    return kept


class Workshop:
    """`place`: the folder for all that is made; it must be another one when the source is another one."""

    def __init__(self, root, build, tree, place):
        self.root, self.build, self.tree = pathlib.Path(root), pathlib.Path(build), tree
        self.place, self.lock = pathlib.Path(place), threading.Lock()
        commands = json.loads((self.build / "compile_commands.json").read_text())
        self.commands = {}
        for entry in commands:
            path = pathlib.Path(entry["file"])
            compiled_together = INCLUDED.findall(path.read_text()) if path.suffix == ".cxx" and path.exists() else []
            for source in [path, *map(pathlib.Path, compiled_together)]:
                if source.is_relative_to(self.root):
                    self.commands.setdefault(source.relative_to(self.root).as_posix(), entry)

    def object_of(self, source):
        """The object file that the build folder made of a source, perhaps of others with it."""
        entry = self.commands[source]
        words = shlex.split(entry["command"])
        return pathlib.Path(entry["directory"]) / words[words.index("-o") + 1]

    def options_for_clang(self, source):
        return without_precompiled(compile_words(self.commands[source]["command"]))

    def compile(self, folder, source):
        """Compiles a source of the folder, which comes before the root in the search for headers. (The object or None,
        what the compiler said.)

        The name of the source is relative to the folder, so equal sources give equal objects."""
        out = folder / (source + ".o")
        words = compile_words(self.commands[source]["command"])
        run = limited.run([*WITHOUT_CACHE, words[0], "-I.", *words[1:], "-o", str(out), "-c", source], COMPILE_LIMIT, folder)
        return (out if run.code == 0 and run.in_time else None), run.output

    def write(self, folder, source, content):
        (folder / source).parent.mkdir(parents=True, exist_ok=True)
        (folder / source).write_bytes(content)

    def original(self, source):
        """The object of the original, compiled as that of a mutant is."""
        out = self.place / "originals" / (source + ".o")
        with self.lock:
            if not out.exists():
                folder = self.place / "originals" / (source + ".made")
                self.write(folder, source, (self.root / source).read_bytes())
                made, said = self.compile(folder, source)
                if not made:
                    raise BuildFailed(f"the original of {source} does not compile: {said[-500:].strip()}")
                made.replace(out)
                shutil.rmtree(folder)
        return out

    def objects(self, mutant, folder):
        """The objects of a mutant: those of its file or, for a header, of all sources that include it. None: it does
        not compile. []: the machine code is that of the original."""
        made, differs = [], False
        sources = self.tree.sources_of(mutant.path)
        for source in sources:
            self.write(folder, source, (self.root / source).read_bytes())
        self.write(folder, mutant.path, mutant.apply((self.root / mutant.path).read_bytes()))
        for source in sources:
            original = self.original(source)  # first: where it does not compile, no mutant would
            compiled, _ = self.compile(folder, source)
            if not compiled:
                return None
            made.append(compiled)
            differs = differs or compiled.read_bytes() != original.read_bytes()
        return made if differs else []

    @functools.lru_cache(maxsize=None)
    def link_command(self, target):
        """(words before the output's name, words after it)."""
        listed = subprocess.run(["ninja", "-C", str(self.build), "-t", "commands", target], capture_output=True,
                                text=True, check=True).stdout
        for part in listed.strip().splitlines()[-1].split(" && "):
            words = shlex.split(part)
            if "-o" in words and COMPILER.match(words[0]):
                place = words.index("-o") + 1
                return tuple(words[:place]), tuple(words[place + 1:])
        raise BuildFailed(f"ninja knows no command that links {target}")

    def link(self, target, objects, folder):
        """A program with these objects instead of those of its libraries."""
        before, after = self.link_command(target)
        out = folder / target
        run = limited.run([*before, str(out), REPLACE, *map(str, objects), *after], COMPILE_LIMIT, self.build)
        if run.code != 0:
            raise DoesNotLink(f"{target} does not link: {run.output[-500:]}")
        return out

    def program(self, target):
        """The program without a fault."""
        for place in ("bin", "subjects", "canaries", "tests/fast", "tests/reference", "tests/oracle", "tests/properties"):
            if (self.build / place / target).exists():
                return self.build / place / target
        raise BuildFailed(f"{target} was not built in {self.build}")
