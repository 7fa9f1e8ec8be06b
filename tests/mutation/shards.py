"""A sample in several runs, on as many machines: each tries some of the draws and writes what it found to a file."""

import dataclasses
import json
import os
import pathlib
import re

FORMAT = "mutants/1"


class BadShards(Exception):
    """A shard is missing, cut off, or of another run; the text says which, and how to make it."""


@dataclasses.dataclass(frozen=True)
class Shard:
    """Every `count`-th draw, from draw number `index` (from 1) on."""
    index: int
    count: int

    def __str__(self):
        return f"{self.index}/{self.count}"

    def of(self, draws):
        return draws[self.index - 1::self.count]

    def file(self, folder):
        return pathlib.Path(folder) / f"mutants-{self.index}-of-{self.count}.jsonl"


def shard_of(word):
    """"3/8"; else ValueError."""
    found = re.fullmatch(r"([0-9]{1,6})/([0-9]{1,6})", word)
    if not found or not 1 <= int(found[1]) <= int(found[2]):
        raise ValueError(f'expected a shard such as 3/8, found "{word}"')
    return Shard(int(found[1]), int(found[2]))


def write(folder, shard, run, found):
    """`run`: what the shards of a run have in common. The file appears when it is complete."""
    file = shard.file(folder)
    file.parent.mkdir(parents=True, exist_ok=True)
    lines = [{"format": FORMAT, "shard": str(shard), "mutants": len(found), **run}, *found]
    part = file.with_name(file.name + ".part")
    part.write_text("".join(json.dumps(line) + "\n" for line in lines))
    os.replace(part, file)


def read_one(file, run):
    """The results of a shard, after its first line is compared with `run`."""
    try:
        head, *found = [json.loads(line) for line in file.read_text().splitlines()]
        if head["format"] != FORMAT or head["mutants"] != len(found):
            raise ValueError
        known = {result["id"]: result for result in found}
    except (ValueError, KeyError, TypeError) as error:
        raise BadShards(f"{file} is no whole shard of mutants") from error
    for name, value in run.items():
        if head.get(name) != value:
            raise BadShards(f"{file} is of another run: its {name} is {head.get(name)}, here it is {value}")
    return known


def read(folder, run):
    """What all shards of a run found, by id."""
    files = sorted(pathlib.Path(folder).glob("mutants-*-of-*.jsonl"))
    counts = sorted({int(file.stem.split("-")[-1]) for file in files})
    if len(counts) != 1:
        raise BadShards(f"{folder} has the shards of {len(counts)} runs, where those of one are expected")
    every = [Shard(index, counts[0]) for index in range(1, counts[0] + 1)]
    lost = [str(shard) for shard in every if not shard.file(folder).exists()]
    if lost:
        raise BadShards(f"{folder} lacks {', '.join(lost)}; the same command with --shard {lost[0]} --out {folder} "
                        "instead of --merge makes it")
    known = {}
    for shard in every:
        known.update(read_one(shard.file(folder), run))
    return known
