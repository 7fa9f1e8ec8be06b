#include "app/fuzz/signals.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "model/input_error.h"
#include "oracle/tolerance/tolerance.h"
#include "oracle/truth/truth.h"
#include "properties/scenes/domain.h"

namespace touchstone::app {
namespace {

using oracle::Finding;

constexpr double most_bits = 60;  ///< a choice: errors that are larger are all alike

double bits_of(double ratio) {
  if (std::isnan(ratio)) return most_bits;
  return ratio > 0 ? std::clamp(std::log2(ratio), -most_bits, most_bits) : -most_bits;
}

std::string power_of_two(double ratio) { return fmt::format("2^{:.0f}", std::floor(bits_of(ratio))); }

}  // namespace

void Signals::add_marks(const fast::MarkCounts& before, const fast::MarkCounts& after) {
  for (std::size_t mark = 0; mark < after.size(); ++mark) {
    const std::uint64_t count = after[mark] - before[mark];
    if (count > 0) words_.insert(fmt::format("mark {} 2^{}", mark, std::bit_width(count) - 1));
  }
}

void Signals::add_scene(const Scene& scene, const std::string& query) {
  try {
    for (const std::string& name : properties::classes_of(scene, query)) words_.insert("class " + name);
  } catch (const InputError&) {
    words_.insert("class without a truth");  // bodies that overlap where their motion begins
  }
  if ((query != "distance" && query != "penetration") || scene.bodies.size() != 2) return;
  const reference::DistanceTruth& truth = oracle::truth::distance(scene);
  if (truth.verdict == Verdict::overlapping) return;
  const double margin = truth.distance.hi / oracle::tolerance::scale(scene);
  words_.insert("margin " + power_of_two(margin));
  if (margin > 0) nearness_ = std::max(nearness_, -bits_of(margin) - 53);
}

void Signals::add_finding(const properties::Property& property, const Finding& finding) {
  std::string words = property.id + ' ' + name_of(finding.outcome);
  const bool has_size = !finding.unit.empty() && finding.unit != oracle::without_size;
  if (failed(finding)) words += ' ' + name_of(finding.defect);
  if (has_size) words += ' ' + power_of_two(excess(finding));
  if (finding.relative) words_.insert(property.id + " relative " + power_of_two(*finding.relative));
  words_.insert(std::move(words));
  if (has_size) nearness_ = std::max(nearness_, bits_of(excess(finding)));
  if (failed(finding)) nearness_ = std::max(nearness_, 0.0);
}

}  // namespace touchstone::app
