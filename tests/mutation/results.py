"""The results of a run: a file to which each mutant adds a line, and the tables that are made from it."""

import collections
import json
import pathlib
import statistics
import tomllib

import draws
import reach

DROPPED = ("does not compile", "same code")  # no kills and no survivors: others are drawn instead


def read_results(file):
    """By id. The last line may be cut off, if the run was killed while it wrote."""
    found = {}
    if file.exists():
        for line in file.read_text().splitlines():
            try:
                result = json.loads(line)
            except json.JSONDecodeError:
                continue
            found[result["id"]] = result
    return found


def add_result(file, result):
    file.parent.mkdir(parents=True, exist_ok=True)
    with file.open("a") as out:
        out.write(json.dumps(result) + "\n")


def read_equivalent(file):
    """id -> why no answer can differ, from a file of [[equivalent]] tables with `id`, `mutant` and `why`."""
    argued = {}
    for entry in tomllib.loads(pathlib.Path(file).read_text()).get("equivalent", []):
        for key in ("id", "mutant", "why"):
            if not entry.get(key, "").strip():
                raise ValueError(f"an entry has no {key}: {entry}")
        if entry["id"] in argued:
            raise ValueError(f"{entry['id']} is argued twice")
        argued[entry["id"]] = entry["why"].strip()
    return argued


def share(part, whole):
    return f"{100 * part / whole:.0f} %" if whole else "-"


def counts(results, argued):
    survived = [r for r in results if r["outcome"] == "survived"]
    equivalent = [r for r in survived if r["id"] in argued]
    killed = [r for r in results if r["outcome"] == "killed"]
    stages = collections.Counter(r["stage"] for r in killed)
    judged = len(killed) + len(survived) - len(equivalent)
    return {"judged": judged, "quick": stages["quick"], "standard": stages["standard"], "tests": stages["tests"],
            "survived": len(survived) - len(equivalent), "equivalent": len(equivalent)}


def rate_table(title, groups, argued):
    lines = [f"| {title} | judged | killed at quick | at standard | by unit tests | survived | equivalent | "
             "rate at quick | rate |", "|---|---|---|---|---|---|---|---|---|"]
    for name, results in groups:
        n = counts(results, argued)
        killed = n["quick"] + n["standard"] + n["tests"]
        lines.append(f"| {name} | {n['judged']} | {n['quick']} | {n['standard']} | {n['tests']} | {n['survived']} | "
                     f"{n['equivalent']} | {share(n['quick'], n['judged'])} | {share(killed, n['judged'])} |")
    return lines


def grouped(results, key, order=()):
    names = collections.defaultdict(list)
    for result in results:
        names[key(result)].append(result)
    first = [name for name in order if name in names]
    return [(name, names[name]) for name in [*first, *sorted(set(names) - set(first))]]


def quantiles(values, unit):
    values = sorted(values)
    if not values:
        return "-"
    last = values[min(len(values) - 1, int(0.9 * len(values)))]
    return f"{statistics.median(values):.4g}{unit} (nine of ten: at most {last:.4g}{unit})"


def code(text):
    return "`" + text.replace("|", "\\|").replace("`", "'") + "`"


def tables(results, argued, seed):
    """The page, as lines of Markdown; `results`: in the order of the draws."""
    judged = [r for r in results if r["outcome"] not in DROPPED]
    dropped = collections.Counter(r["outcome"] for r in results)
    killed = [r for r in judged if r["outcome"] == "killed"]
    lines = [f"{len(judged)} mutants, seed {seed}. Not counted, and others drawn instead: "
             f"{dropped['does not compile']} that do not compile, {dropped['same code']} with the machine code of the "
             "original.", ""]
    lines += rate_table("group", [*grouped(judged, lambda r: r["group"], draws.GROUPS), ("all", judged)], argued)
    lines += ["", *rate_table("folder", grouped(judged, lambda r: reach.folder_of(r["path"])), argued)]
    lines += ["", *rate_table("query of the file", grouped(judged, lambda r: r["query"], reach.QUERIES), argued)]
    lines += ["", *rate_table("fault", grouped(judged, lambda r: r["kind"]), argued)]
    at_scene = [r["scenes"] for r in killed if r["scenes"]]
    lines += ["", "| what | median |", "|---|---|",
              f"| scenes of the query until the kill | {quantiles(at_scene, '')} |",
              f"| CPU time until the kill, build not counted | {quantiles([r['cpu_seconds'] for r in killed], ' s')} |",
              f"| CPU time of a survivor | "
              f"{quantiles([r['cpu_seconds'] for r in judged if r['outcome'] == 'survived'], ' s')} |",
              f"| time of a mutant, build and all | {quantiles([r['seconds'] for r in judged], ' s')} |"]
    if killed:
        lines += ["", "| killed by | mutants |", "|---|---|"]
        by = collections.Counter(r["by"] for r in killed)
        lines += [f"| {code(name)} | {count} |" for name, count in sorted(by.items(), key=lambda item: (-item[1], item[0]))]
    survivors = [r for r in judged if r["outcome"] == "survived"]
    if survivors:
        lines += ["", "| survivor | place | fault | the line | equivalent, since |", "|---|---|---|---|---|"]
        lines += [f"| {r['id']} | `{r['path']}:{r['line']}` {code(r['function'])} | {r['kind']} | "
                  f"{code(r['before'])} becomes {code(r['after'])} | {argued.get(r['id'], '')} |" for r in survivors]
    return lines
