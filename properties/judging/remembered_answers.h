// A subject's answers, so that the properties of a query judge one answer about a scene.
#pragma once

#include <algorithm>
#include <tuple>
#include <vector>

#include "oracle/passing_on.h"
#include "properties/property.h"

namespace touchstone::properties {

/// Does the property compare two answers to one question? It must ask the subject itself.
inline bool asks_twice(const Property& property) { return property.id.ends_with(".repeats"); }

/// Passes a question on, unless it was asked before. It is made anew for each drawn scene. Most properties of a query
/// ask about the drawn scene itself, and without it an engine would follow a motion up to 31 times. `subject` must
/// outlive this object.
class RememberedAnswers final : public oracle::PassingOn<RememberedAnswers> {
 public:
  using PassingOn::PassingOn;

  /// The subject that the property is to ask: this one, or the one that remembers nothing.
  oracle::Subject& asked_by(const Property& property) {
    return asks_twice(property) ? subject_ : static_cast<oracle::Subject&>(*this);
  }

 private:
  friend PassingOn;

  template <class T>
  using Query = Answer<T> (Subject::*)(const Scene&);

  template <class T>
  struct Asked {
    Query<T> query;
    Scene scene;
    Answer<T> answer;
  };

  template <class T>
  Answer<T> pass(Query<T> query, const Scene& scene) {
    auto& asked_before = std::get<std::vector<Asked<T>>>(memory_);
    const auto known = std::ranges::find_if(
        asked_before, [&](const Asked<T>& asked) { return asked.query == query && asked.scene == scene; });
    if (known != asked_before.end()) return known->answer;
    asked_before.push_back({query, scene, (subject_.*query)(scene)});
    return asked_before.back().answer;
  }

  std::tuple<std::vector<Asked<Masses>>, std::vector<Asked<Bounds>>, std::vector<Asked<PairSet>>,
             std::vector<Asked<PairHistory>>, std::vector<Asked<Distance>>, std::vector<Asked<Penetration>>,
             std::vector<Asked<Impulse>>, std::vector<Asked<Pixels>>, std::vector<Asked<TimeOfImpact>>,
             std::vector<Asked<Trajectory>>>
      memory_;
};

}  // namespace touchstone::properties
