#include "properties/transforms/name.h"

#include <array>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "oracle/judge/words.h"
#include "properties/transforms/body.h"
#include "properties/transforms/motion.h"
#include "properties/transforms/scene.h"

namespace touchstone::properties {
namespace {

using Change = std::pair<const char*, std::function<std::optional<Scene>(const Scene&)>>;

const std::vector<Change>& changes_without_a_number() {
  static const std::vector<Change> all = {
      {"the bodies in reverse order", [](const Scene& s) { return std::optional(swapped(s)); }},
      {"the vertices of each polytope in reverse order", [](const Scene& s) { return relabelled(s); }},
      {"the vertices of each polytope and the parts of each compound in reverse order",
       [](const Scene& s) { return relabelled_with_parts(s); }},
      {"the world turned by 120 degrees about (1, 1, 1)", [](const Scene& s) { return turned(s); }},
      {"the world turned by 180 degrees about x", [](const Scene& s) { return std::optional(half_turned(s)); }},
      {"the world mirrored in the plane x = 0", [](const Scene& s) { return mirrored(s); }},
      {"each body's shape turned in its frame", [](const Scene& s) { return turned_in_body(s); }},
      {"each body's shape shifted in its frame", [](const Scene& s) { return shifted_in_body(s); }},
      {"the same velocity added to all bodies", [](const Scene& s) { return boosted(s); }},
  };
  return all;
}

/// Those of a motion.
const std::vector<Change>& changes_of_motion() {
  static const std::vector<Change> all = {
      {"the same velocity added to all bodies", [](const Scene& s) { return carried(s); }},
      {"without gravity", [](const Scene& s) { return weightless(s); }},
      {"balls that turn otherwise", [](const Scene& s) { return spun_balls(s); }},
      {"time 2^5 times as fast", [](const Scene& s) { return hastened(s, 5); }},
      {"backwards in time", [](const Scene& s) { return backwards(s); }},
  };
  return all;
}

std::optional<std::string> found_in(const std::vector<Change>& changes, const Scene& before, const Scene& after) {
  for (const auto& [name, change] : changes) {
    if (change(before) == after) return name;
  }
  return std::nullopt;
}

/// The powers of two that laws scale by.
constexpr std::array powers = {24, 20, -20, 10, -10, 4, 3, -3};

std::optional<std::string> scaled_by(int k, const Scene& before, const Scene& after) {
  const std::string times = " times 2^" + std::to_string(k);
  if (scaled(before, k) == after) return "all lengths" + times;
  if (sped_up(before, k) == after) return "all velocities" + times;
  if (denser(before, k) == after) return "all densities" + times;
  if (before.motion && heavier(before, k) == after) return "all masses and forces" + times;
  return std::nullopt;
}

/// Without sample times no delay can be told.
std::optional<std::string> delayed(const Scene& before, const Scene& after) {
  if (!before.motion || !after.motion) return std::nullopt;
  const std::vector<double>&from = before.motion->sample_times, &to = after.motion->sample_times;
  if (from.empty() || from.size() != to.size()) return std::nullopt;
  const double delay = to.back() - from.back();
  if (later(before, delay) != after) return std::nullopt;
  return "everything later by " + oracle::words::text(delay) + " s";
}

}  // namespace

std::string name_of_change(const Scene& before, const Scene& after) {
  if (const auto name = found_in(changes_without_a_number(), before, after)) return *name;
  if (before.motion) {
    if (const auto name = found_in(changes_of_motion(), before, after)) return *name;
  }
  if (translated(before) == after) {
    return "the world translated by " + oracle::words::text(translation_between(before, after));
  }
  for (const int k : powers) {
    if (const auto name = scaled_by(k, before, after)) return *name;
  }
  if (const auto name = delayed(before, after)) return *name;
  return "changed as the law says";
}

}  // namespace touchstone::properties
