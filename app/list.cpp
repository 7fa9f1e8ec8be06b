#include "app/list.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

#include "app/motion_scenes.h"
#include "app/roster.h"
#include "oracle/subjects/canaries.h"
#include "properties/clause.h"
#include "properties/domain.h"
#include "properties/extreme.h"
#include "properties/property.h"

namespace touchstone::app {
namespace {

void list_subjects() {
  for (const std::string& name : roster({})) {
    const auto subject = connect(name, {});
    const oracle::Card& card = subject->card();
    fmt::print("{:<14} {:<10} answers {}\n{:<14} {}\n", card.name, card.version, fmt::join(card.answers, ", "), "",
               card.about);
    for (const oracle::Deviation& known : card.deviations) {
      fmt::print("{:<14} known: {} {}{}\n", "", known.what, known.clause.empty() ? "" : "(" + known.clause + ") ",
                 known.link);
    }
  }
}

void list_properties() {
  for (const properties::Property& property : properties::all()) {
    fmt::print("{:<30} {} ({})\n", property.id, property.says, fmt::join(property.clauses, ", "));
  }
}

void list_clauses() {
  for (const properties::Clause& clause : properties::clauses()) {
    fmt::print("{} {}\n    {}\n    checked by {}\n", clause.id, clause.title, clause.says,
               fmt::join(clause.checked_by, ", "));
  }
}

void list_families() {
  for (const auto* families : {&properties::families(), &properties::extremes()}) {
    for (const properties::Family& family : *families) {
      fmt::print("{:<30} {} ({}{})\n", family.id, family.says, fmt::join(family.stems, ", "),
                 family.binary32_exact ? "; exact in floats" : "");
    }
  }
}

void list_canaries() {
  for (const oracle::subjects::Canary& canary : oracle::subjects::canaries()) {
    fmt::print("{:<34} {}\n", canary.id, canary.says);
  }
}

void list_motions() {
  for (const MotionScene& motion : motion_scenes()) {
    fmt::print("{:<26} {} ({} bodies, {} s)\n", motion.scene.name, motion.truth, motion.scene.bodies.size(),
               motion.scene.flight->times.back());
  }
}

const std::map<std::string, void (*)()>& lists() {
  static const std::map<std::string, void (*)()> all = {{"subjects", list_subjects}, {"properties", list_properties},
                                                        {"clauses", list_clauses},   {"families", list_families},
                                                        {"canaries", list_canaries}, {"motions", list_motions}};
  return all;
}

}  // namespace

const std::vector<std::string>& listable() {
  static const std::vector<std::string> all = {"subjects", "properties", "clauses", "families", "canaries", "motions"};
  return all;
}

void list(const std::string& what) { lists().at(what)(); }

}  // namespace touchstone::app
