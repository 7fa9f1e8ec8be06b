// A unit of work: a chunk of one query's scenes, asked of all subjects.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/profile/query_profile.h"
#include "app/trial/meshes.h"
#include "app/trial/questions.h"
#include "app/trial/result_matrix.h"
#include "app/trial/trial.h"
#include "oracle/subject.h"

namespace touchstone::app {

using Subjects = std::vector<std::unique_ptr<oracle::Subject>>;
using TestedSubjects = std::vector<TestedSubject>;

/// The scenes from `begin` to before `end` of a query.
struct Unit {
  std::size_t query = 0;  ///< among the plan's
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// The properties of one query, and its scenes.
struct QueryTrial {
  std::string name;
  std::size_t exact_questions = 0;  ///< subjects that compute exactly are asked those with a lower number only
  bool profiled = false;            ///< as in the plan
  std::vector<const properties::Property*> properties;
  Questions questions;
};

/// What one unit found about the properties of its query.
struct UnitResult {
  ResultMatrix results;
  ResultMatrix beyond;  ///< as in the ledger
  std::map<std::string, long> classes;
  std::map<std::string, long> mesh_scenes;
  long scenes = 0;
  std::vector<int> hangs;  ///< by subject
  QueryProfile profile;
};

/// The queries of the plan. `meshes` must outlive them.
std::vector<QueryTrial> trials(const TrialPlan& plan, const MeshSet& meshes);

/// Functions of the plan alone: neither the number of threads nor a subject changes them.
std::vector<Unit> units(const std::vector<QueryTrial>& trials);

UnitResult nothing_of(const QueryTrial& query, const TestedSubjects& tested);

bool any_failing(const UnitResult& result);

/// Starts the subjects afresh and asks them. `hangs`: by subject, how many count against it at the start of the unit.
/// An interrupted unit ends early.
UnitResult run_unit(const QueryTrial& query, const Unit& unit, const TestedSubjects& tested, const Subjects& subjects,
                    std::vector<int> hangs, bool first_failure);

}  // namespace touchstone::app
