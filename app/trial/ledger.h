// The results of a run: one row per property and subject, with the finding that shows the row best.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/report/error_histogram.h"
#include "app/trial/meshes.h"
#include "model/scene.h"
#include "oracle/case.h"
#include "oracle/finding.h"
#include "oracle/judge/grade.h"
#include "oracle/minimise/minimise.h"
#include "oracle/subject.h"

namespace touchstone::app {

/// One failing or notable answer.
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
  long not_asked = 0;                         ///< skipped because the subject hung too often
  std::array<long, 5> grades{};               ///< of the answers: A, B, C, D, F
  std::map<oracle::Defect, long> defects;     ///< of the answers that fail or break
  long impacts = 0;                           ///< of simulations: each one compared with the reference by itself
  std::string why_abstains;                   ///< the first reason
  double largest_error = 0;                   ///< among the wrong answers whose error has a size
  std::string unit;                           ///< of largest_error; empty if there is none
  ErrorHistogram errors;                      ///< of all answers
  std::optional<Example> closest;             ///< the correct answer with the largest error / allowed error
  std::optional<Example> worst;               ///< by the worst grade, then the largest error, then the first
  std::optional<Example> smallest;            ///< by usual units, then the worst grade, then size: start of minimising
  std::optional<oracle::Case> smallest_case;  ///< after minimising
  oracle::Size size_found;                    ///< of `smallest`, before minimising
  std::string case_file;                      ///< relative to the report's folder
  std::string replay_command;                 ///< for the case as written; empty if it was not written

  /// Counts the finding of one more query.
  void count(const Example& example);
  void merge(Row later);
  bool failing() const { return fails + breaks > 0; }
  long answered() const { return holds + fails + breaks; }
  std::optional<oracle::Grade> grade() const;  ///< the worst; none if there is no answer
};

struct Ledger {
  std::uint64_t seed = 0;
  std::string effort;
  int cases = 0;  ///< drawn scenes per query
  bool interrupted = false;
  std::vector<std::string> connectables;  ///< how to connect to the subjects, in their order
  std::vector<oracle::Card> subjects;
  std::vector<Row> rows;                                       ///< by property, then by subject
  std::map<std::string, std::map<std::string, long>> classes;  ///< query -> class -> scenes
  std::map<std::string, long> scenes;                          ///< query -> number of scenes
  std::vector<std::string> empty_classes;                      ///< "distance: edge-edge"
  std::string mesh_folder;
  std::string meshes_absent;
  std::size_t mesh_count = 0;
  std::size_t meshes_left_out = 0;          ///< flat, or not a mesh
  std::map<std::string, long> mesh_scenes;  ///< family -> scenes
};

/// The finding shown for a failing row: that of the minimised scene, else the worst one.
const oracle::Finding& shown_finding(const Row& row);

/// "2 bodies, at most 4 vertices a body and 3 significant bits"
std::string text_of(const oracle::Size& size);

}  // namespace touchstone::app
