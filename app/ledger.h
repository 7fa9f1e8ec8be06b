// What came of a run: one row a property and subject, with the finding that shows the row best.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/error_histogram.h"
#include "app/meshes.h"
#include "model/scene.h"
#include "oracle/case.h"
#include "oracle/finding.h"
#include "oracle/grade.h"
#include "oracle/minimise.h"
#include "oracle/subject.h"

namespace touchstone::app {

/// One failing question.
struct Example {
  std::string family;
  std::uint64_t index = 0;
  Scene scene;
  oracle::Finding finding;
};

struct Row {
  std::string property;
  std::string subject;
  long holds = 0;
  long fails = 0;
  long abstains = 0;
  long breaks = 0;
  long outside = 0;
  long not_asked = 0;                         ///< given up after hangs
  std::array<long, 5> grades{};               ///< of the answered: A, B, C, D, F
  std::map<oracle::Defect, long> defects;     ///< of fails and breaks
  long impacts = 0;                           ///< of simulations: held against the reference, each by itself
  std::string why_abstains;                   ///< the first reason
  double largest_error = 0;                   ///< of what is wrong and has a size
  std::string unit;                           ///< of it; empty if nothing is
  ErrorHistogram errors;                      ///< of all that was answered
  std::optional<Example> closest;             ///< of the right: the largest error beside what is allowed
  std::optional<Example> worst;               ///< the worst grade, then the largest error, then the first
  std::optional<Example> smallest;            ///< in usual units, the worst grade, the smallest: what is cut down
  std::optional<oracle::Case> smallest_case;  ///< after cutting down
  oracle::Size size_found;                    ///< of `smallest` before
  std::string case_file;                      ///< relative to the report's folder
  std::string replay_command;                 ///< of the case where it was written; empty if it was not

  /// A finding of the next question.
  void count(const Example& example);
  void merge(Row later);
  bool failing() const { return fails + breaks > 0; }
  long answered() const { return holds + fails + breaks; }
  std::optional<oracle::Grade> grade() const;  ///< the worst; none if nothing was answered
};

struct Ledger {
  std::uint64_t seed = 0;
  std::string effort;
  int cases = 0;  ///< drawn scenes a stem
  bool interrupted = false;
  std::vector<std::string> connectables;  ///< how to reach the subjects, in their order
  std::vector<oracle::Card> subjects;
  std::vector<Row> rows;                                       ///< property by property; in each, the subjects in order
  std::map<std::string, std::map<std::string, long>> classes;  ///< stem -> class -> scenes
  std::map<std::string, long> scenes;                          ///< stem -> scenes asked about
  std::vector<std::string> empty_classes;                      ///< "distance: edge-edge"
  std::string mesh_folder;
  std::string meshes_absent;
  std::size_t mesh_count = 0;
  std::size_t meshes_left_out = 0;          ///< flat, or no meshes
  std::map<std::string, long> mesh_scenes;  ///< family -> scenes
};

/// The finding that is shown of a failing row: the cut-down scene's, else the worst.
const oracle::Finding& shown_finding(const Row& row);

/// "2 bodies, at most 4 vertices a body and 3 significant bits"
std::string text_of(const oracle::Size& size);

}  // namespace touchstone::app
