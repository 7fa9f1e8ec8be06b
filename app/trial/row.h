// What a run found for one property and one subject: counts, and the findings that show it best.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/report/error_histogram.h"
#include "model/scene.h"
#include "oracle/case.h"
#include "oracle/finding.h"
#include "oracle/judge/grade.h"
#include "oracle/minimise/minimise.h"
#include "oracle/subject.h"
#include "properties/property.h"

namespace touchstone::app {

/// A subject of a run.
struct TestedSubject {
  std::size_t index = 0;    ///< among the run's subjects
  oracle::Card card;        ///< no two subjects of a run have the same name
  std::string connectable;  ///< how to connect to it
  std::string file_name;    ///< stands for it in the names of files
};

/// One failing or notable answer.
struct Example {
  std::string family;
  std::uint64_t index = 0;
  Scene scene;
  oracle::Finding finding;
  std::string beyond = {};  ///< how a question exceeds the domain that the subject's card declares; empty: none does
};

/// How many scenes had which outcome.
struct Counts {
  long holds = 0;
  long fails = 0;
  long abstains = 0;
  long breaks = 0;   ///< without the refusals
  long refused = 0;  ///< the engine said that it does not take the scene
  long outside = 0;
  long not_asked = 0;   ///< skipped: the subject hung too often, or would take too long
  long unanswered = 0;  ///< the subject gave no answer about the scene, which `.survives` counts as its failure
  long beyond = 0;      ///< a question was outside the subject's declared domain: counted apart (app/trial/ledger.h)
  long impacts = 0;     ///< of simulations: each one compared with the reference by itself

  long failures() const { return fails + breaks + refused; }
  long answered() const { return holds + failures(); }
  long all() const { return answered() + abstains + outside + not_asked + unanswered + beyond; }

  Counts& operator+=(const Counts& more);
};

/// Among the wrong answers whose error has a size.
struct LargestError {
  double size = 0;
  std::string unit;  ///< empty if there is none
};

/// The answers that are kept to be shown.
struct Examples {
  std::optional<Example> closest;   ///< the correct answer with the largest error / allowed error
  std::optional<Example> worst;     ///< by the worst grade, then the largest error, then the first
  std::optional<Example> smallest;  ///< by usual units, then the worst grade, then size: start of minimising
};

/// What minimising made of `Examples::smallest`.
struct Minimised {
  std::optional<oracle::Case> result;
  oracle::Size size_before;
  std::string case_file;       ///< relative to the report's folder
  std::string replay_command;  ///< for the case as written; empty if it was not written
};

/// What a baseline (app/baseline) says of the row.
struct BaselineVerdict {
  std::string known;                    ///< why check accepts a failing row; empty: it does not
  std::vector<std::string> departures;  ///< what differs from the baseline, and has to be looked at
};

struct Row {
  const properties::Property* property = nullptr;
  const TestedSubject* subject = nullptr;
  Counts counts;
  std::array<long, oracle::grade_count> grades{};        ///< of the answers
  std::map<oracle::Defect, long> defects;                ///< of the answers that fail or break
  std::map<oracle::Defect, oracle::Grade> worst_grades;  ///< likewise: the worst of each defect
  std::string why_abstains;                              ///< the first reason
  LargestError largest_error;
  ErrorHistogram errors;  ///< of all answers
  Examples examples;
  Minimised minimised;
  BaselineVerdict baseline;

  /// Counts the finding of one more query.
  void count(const Example& example);

  /// Adds what later queries of the same property and subject found.
  void merge(const Row& later);

  /// Counts every query as not asked.
  void forget();

  bool failing() const { return failures() > 0; }
  long failures() const { return counts.failures(); }
  long answered() const { return counts.answered(); }
  /// The worst of all answers and of the case that is shown; none if there is no answer.
  std::optional<oracle::Grade> grade() const;
};

/// The finding shown for a failing row: that of the minimised scene, else the worst one.
const oracle::Finding& shown_finding(const Row& row);

/// "0.36 %", "43 %"; "100 %" only of all. Requires a positive `all`.
std::string percent(long some, long all);

/// "1 of 281 fail (0.36 %)", "7 of 7 fail (100 %), 3 of them refused". Requires a failing row.
std::string share_of(const Row& row);

/// "2 bodies, at most 4 vertices a body and 3 significant bits"
std::string text_of(const oracle::Size& size);

}  // namespace touchstone::app
