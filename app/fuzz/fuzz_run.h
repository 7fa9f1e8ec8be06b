// Fuzzing: a subject is asked about mutated scenes, and scenes that show something new are mutated further.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/trial/row.h"
#include "fast/mark.h"
#include "oracle/case.h"
#include "oracle/subject.h"
#include "properties/property.h"

namespace touchstone::app {

struct FuzzPlan {
  std::string query;
  std::vector<const properties::Property*> properties;  ///< of the query
  std::uint64_t seed = 1;
  std::optional<long> executions;  ///< ends after so many scenes
  std::optional<double> seconds;   ///< ends after so much wall-clock time; then the scenes are made smaller
  int draws = 4;                   ///< scenes of each family to begin with; 0: a single scene
  bool first_failure = false;      ///< ends with the first finding, too, and does not make it smaller
  int minimise_budget = 0;         ///< queries per finding
  int enlarge_budget = 0;          ///< queries per finding whose error has a size, to make it larger
  int neighbours = 15;  ///< executions with the bodies of a mutated scene elsewhere, if there is a screen; a choice
  int share = 64;       ///< one of so many scenes that the screen passes is asked under all properties, too; a choice
};

/// The screen and the properties contradict each other about a scene: a fault of ours.
struct Contradiction {
  long execution = 0;
  std::string what;
  Scene scene;
};

/// All failing answers with one cause: a property and a defect; or a break with the same words, apart from numbers,
/// whatever the property.
struct FuzzFinding {
  long execution = 0;                   ///< in which it was first seen, counted from 1
  Row row;                              ///< of the property that met it first
  oracle::Case smallest;                ///< minimised; its subject is the card's name
  std::optional<Example> largest = {};  ///< one with a larger error than all that were drawn, if one was looked for
};

/// What was seen of the subject and the scenes.
struct FuzzCoverage {
  std::size_t kept = 0;      ///< scenes in the pool
  std::size_t signals = 0;   ///< different ones (app/fuzz/signals.h)
  fast::MarkCounts marks{};  ///< all 0 unless the subject is `fast` in this process
};

struct FuzzResult {
  oracle::Card card;
  long executions = 0;  ///< scenes
  long judged = 0;      ///< of these, asked under all properties
  long verdicts = 0;    ///< judged scenes times properties
  long beyond = 0;      ///< verdicts that do not count: the scene is outside the domain that the card declares
  double seconds = 0;   ///< of executions
  FuzzCoverage coverage;
  std::vector<Row> holding;                   ///< by property: the answers that hold
  std::vector<FuzzFinding> findings;          ///< in the order in which they were found
  std::vector<Contradiction> contradictions;  ///< at most one of a kind
  bool interrupted = false;
};

/// Execution n is a function of the plan's seed, n and the executions before it. So the same plan, if no time ends it,
/// has the same result, bit for bit, with a subject that repeats itself.
///
/// An execution takes one scene; the first ones take the starting scenes as they are. Where there is a screen, a
/// mutated scene is followed by `neighbours`: the same shapes, with one body displaced. If there is a screen for the
/// query (app/fuzz/screen.h), and all properties that it stands for are in the plan, the subject is asked once and the
/// answer screened. Under all properties it is asked about starting scenes; scenes on which the screen shows something
/// new or does not call the answer right; and a drawn share of all others. Without a screen, about every scene. An
/// exception of a subject in this process counts as a break, unless it says that the scene is bad input. A scene on
/// which the subject hangs is asked no further and not kept.
FuzzResult fuzz(const FuzzPlan& plan, oracle::Subject& subject);

}  // namespace touchstone::app
