#include "app/benchmarks/simulation_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "app/benchmarks/work_precision.h"
#include "app/motion/motion_scenes.h"

namespace touchstone::app {
namespace {

using Rows = std::vector<const WorkPrecision*>;

constexpr const char* head = R"(# Simulations: error and time

`./touchstone bench simulation --out docs/reports` makes this page again. [Figures](simulation.csv), [tables](simulation.txt).

![error against time, log-log, a panel a scene, a point for each step](simulation.svg)

A scene is simulated to its end, each run in a process of its own; CPU time, short runs repeated, on a machine that others were using too. The error is that of the
scene's own truth, the greatest over all samples: a share of a length or an energy. *impacts*: those that were resolved one by one; *changes*: contacts that began,
changed between stick and slip, or ended. Engines that step were run with each number of steps a second that the figures list for the scene, from 16 to 4096 (256 is
their own), but for motions of milliseconds or hours, which have so many in a unit of their own; where one did not end, finer ones were not run. Here stands the run with
the least error of these. An empty cell: it was not run.
)";

constexpr const char* saving_head = R"(
## What asking only near pairs saves
Pairs are asked when they may meet only if their boxes over a frame of 1/30 s intersect; beside it, boxes over the whole motion, so that all pairs that could ever
meet are asked. The trajectories are the same, bit for bit, where they have closed forms. Below 1x the frames cost more than they save: bodies are few, or their paths do not cross.

| scene | near pairs, ms | all, ms | saved |
|---|---:|---:|---:|
)";

const MotionScene* motion_of(const std::string& name) {
  const auto found =
      std::ranges::find_if(motion_scenes(), [&](const MotionScene& motion) { return motion.scene.name == name; });
  return found == motion_scenes().end() ? nullptr : &*found;
}

/// Escapes bars, which would end a cell of the table.
std::string in_cell(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) text.insert(at, 1, '\\');
  return text;
}

std::string figure(const WorkPrecision& row) {
  if (!row.ns) return row.left_out;
  return fmt::format("{:.1e} in {:.3g} ms", row.worst_error.value_or(0), *row.ns / 1e6);
}

std::string steps_of(const WorkPrecision& row) { return row.size == "0" ? "" : " at " + row.size + "/s"; }

/// The run with the least error; the first one if no run has an error.
const WorkPrecision& best(const Rows& rows) {
  return **std::ranges::min_element(rows, {},
                                    [](const WorkPrecision* row) { return row->worst_error.value_or(1e300); });
}

Rows named(const Rows& rows, const std::string& name) {
  Rows some;
  std::ranges::copy_if(rows, std::back_inserter(some), [&](const WorkPrecision* row) { return row->name == name; });
  return some;
}

std::vector<std::string> peers_of(const std::vector<WorkPrecision>& rows) {
  std::vector<std::string> names;
  for (const WorkPrecision& row : rows) {
    if (row.whose == "peer" && std::ranges::count(names, row.name) == 0) names.push_back(row.name);
  }
  return names;
}

/// Impacts and changes, the last two fields of one of our rows, as two cells.
std::string counts_of(const std::string& csv, const std::string& scene, const std::string& name) {
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(scene + ",0," + name + ",")) continue;
    const std::size_t last = line.rfind(','), before = line.rfind(',', last - 1);
    return line.substr(before + 1, last - before - 1) + " | " + line.substr(last + 1);
  }
  return " | ";
}

/// One row per scene.
std::string scene_line(const Rows& rows, const std::string& csv, const std::vector<std::string>& peers) {
  const std::string& scene = rows.front()->workload;
  const MotionScene* motion = motion_of(scene);
  std::string line = fmt::format("| `{}`: {} ", scene, motion != nullptr ? in_cell(motion->truth) : "");
  for (const std::string name : {"fast", "fast.constraint"}) {
    const Rows some = named(rows, name);
    line += "| " + (some.empty() ? "" : figure(best(some))) + " | " + counts_of(csv, scene, name) + " ";
  }
  for (const std::string& peer : peers) {
    const Rows some = named(rows, peer);
    line += "| " + (some.empty() ? "" : figure(best(some)) + steps_of(best(some))) + " ";
  }
  return line + "|\n";
}

/// Lists the runs of other engines that are faster or more accurate than ours.
std::string losses(const Rows& rows) {
  const Rows ours = named(rows, "fast");
  if (ours.empty()) return "";
  const WorkPrecision& fast = *ours.front();
  std::string text;
  for (const WorkPrecision* row : rows) {
    if (row->whose != "peer" || !row->ns) continue;
    const bool behind = fast.ns && *fast.ns <= *row->ns && fast.worst_error.value_or(0) <= row->worst_error.value_or(0);
    if (!behind) text += fmt::format("{}{}{}: {}", text.empty() ? "" : "; ", row->name, steps_of(*row), figure(*row));
  }
  return text.empty() ? "" : fmt::format("- `{}`: `fast` {}. {}.\n", fast.workload, figure(fast), text);
}

/// How much faster it is to query only the pairs whose boxes over a frame overlap.
std::string saving(const Rows& rows) {
  const Rows few = named(rows, "fast"), all = named(rows, "fast.one_frame");
  if (few.empty() || all.empty() || !few.front()->ns || !all.front()->ns) return "";
  const double with = *few.front()->ns / 1e6, without = *all.front()->ns / 1e6;
  return fmt::format("| `{}` | {:.3g} | {:.3g} | {:.2g}x |\n", few.front()->workload, with, without, without / with);
}

}  // namespace

std::string simulation_page(const std::string& csv) {
  const std::vector<WorkPrecision> rows = work_precision_rows(csv);
  const std::vector<std::string> peers = peers_of(rows);
  std::string table = "| scene: what is known | `fast` | impacts | changes | `constraint` | impacts | changes ";
  for (const std::string& peer : peers) table += "| " + peer + " ";
  table += "|\n|" + std::string("---|---|---:|---:|---|---:|---:|");
  for (std::size_t k = 0; k < peers.size(); ++k) table += "---|";
  table += "\n";
  std::string lost, saved;
  for (std::size_t k = 0; k < rows.size();) {
    Rows of_scene;
    const std::string scene = rows[k].workload;
    for (; k < rows.size() && rows[k].workload == scene; ++k) of_scene.push_back(&rows[k]);
    table += scene_line(of_scene, csv, peers);
    lost += losses(of_scene);
    saved += saving(of_scene);
  }
  return head + ("\n" + table) + "\n## Where `fast` is not ahead in both, error and time\n" +
         (lost.empty() ? "Nowhere.\n" : lost) + (saved.empty() ? "" : saving_head + saved);
}

}  // namespace touchstone::app
