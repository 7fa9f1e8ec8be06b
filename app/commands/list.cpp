#include "app/commands/list.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

#include "app/motion/motion_scenes.h"
#include "app/system/terminal.h"
#include "app/trial/subject_list.h"
#include "oracle/subjects/canaries/canaries.h"
#include "properties/clause.h"
#include "properties/property.h"
#include "properties/scenes/domain.h"
#include "properties/scenes/extreme.h"

namespace touchstone::app {
namespace {

std::string listed(const std::vector<std::string>& words) { return fmt::format("{}", fmt::join(words, ", ")); }

void list_subjects() {
  for (const std::string& name : subject_list({})) {
    const auto subject = connect(name, {});
    const oracle::Card& card = subject->card();
    print("{:<14} {:<10} answers {}\n{:<14} {}\n", card.name, card.version, listed(card.answers), "", card.about);
    for (const oracle::Deviation& known : card.deviations) {
      print("{:<14} known: {} {}{}\n", "", known.what, known.clause.empty() ? "" : "(" + known.clause + ") ",
            known.link);
    }
  }
}

void list_properties() {
  for (const properties::Property& property : properties::all()) {
    print("{:<30} {} ({})\n", property.id, property.says, listed(property.clauses));
  }
}

void list_clauses() {
  for (const properties::Clause& clause : properties::clauses()) {
    print("{} {}\n    {}\n    checked by {}\n", clause.id, clause.title, clause.says, listed(clause.checked_by));
  }
}

void list_families() {
  for (const auto* families : {&properties::families(), &properties::extremes()}) {
    for (const properties::Family& family : *families) {
      print("{:<30} {} ({}{})\n", family.id, family.says, listed(family.queries),
            family.binary32_exact ? "; exact in floats" : "");
    }
  }
}

void list_canaries() {
  for (const oracle::subjects::Canary& canary : oracle::subjects::canaries()) {
    print("{:<34} {}\n", canary.id, canary.says);
  }
}

void list_motions() {
  for (const MotionScene& motion : motion_scenes()) {
    print("{:<26} {} ({} bodies, {} s)\n", motion.scene.name, motion.truth, motion.scene.bodies.size(),
          motion.scene.motion->sample_times.back());
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
