#include "app/fuzz/screen.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <exception>
#include <optional>
#include <string_view>

namespace touchstone::app {
namespace {

using oracle::judge::DistanceScreening;
using oracle::judge::Screened;

constexpr std::array<std::string_view, 9> stood_for = {
    "distance.verdict",         "distance.value",      "distance.witnesses_on_bodies",
    "distance.witnesses_apart", "distance.features",   "distance.enclosure",
    "distance.enclosure_tight", "distance.consistent", "distance.survives"};

enum Kind { mark, verdict, features, margin, error, width };

/// As in app/fuzz/signals.h: numbers are rounded to powers of two. 0 and what is below 2^-60 are alike.
int power_of_two(double ratio) {
  constexpr double least = 0x1p-60;
  return std::isfinite(ratio) ? std::ilogb(std::max(ratio, least)) : 1000;
}

int corners(const std::optional<Feature>& feature) { return feature ? static_cast<int>(feature->vertices.size()) : 0; }

}  // namespace

bool Screen::applies(const std::string& query, const std::vector<const properties::Property*>& properties) {
  return query == "distance" && std::ranges::all_of(stood_for, [&](std::string_view id) {
           return std::ranges::any_of(properties, [&](const properties::Property* p) { return p->id == id; });
         });
}

bool Screen::stands_for(const properties::Property& property) {
  return std::ranges::find(stood_for, property.id) != stood_for.end();
}

bool Screen::note(int kind, int what, int value) { return known_.insert({kind, what, value}).second; }

bool Screen::note_marks(const fast::MarkCounts& before) {
  bool is_new = false;
  const fast::MarkCounts reached = fast::marks_since(before);
  for (std::size_t m = 0; m < reached.size(); ++m) {
    if (reached[m] > 0) is_new |= note(mark, static_cast<int>(m), static_cast<int>(std::bit_width(reached[m])));
  }
  return is_new;
}

Screen::Seen Screen::ask(const Scene& scene) try {
  const fast::MarkCounts marks_before = fast::mark_counts;
  const Answer<Distance> answer = subject_.distance(scene);
  Seen seen;
  seen.is_new = note_marks(marks_before);
  const DistanceScreening screening = oracle::judge::screen(scene, answer, subject_.card());
  seen.result = screening.result;
  const auto* said = std::get_if<Distance>(&answer);
  if (said == nullptr) return seen;
  const int v = static_cast<int>(screening.verdict);
  seen.is_new |= note(verdict, v, 0);
  seen.is_new |= note(features, corners(said->feature_A), corners(said->feature_B));
  seen.is_new |= note(margin, v, power_of_two(screening.margin));
  seen.is_new |= note(error, v, power_of_two(screening.error));
  seen.is_new |= note(width, v, power_of_two(screening.width));
  return seen;
} catch (const std::exception&) {
  return {Screened::open, true};
}

}  // namespace touchstone::app
