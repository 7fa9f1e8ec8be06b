// The preconditions of a property (its scenes, in the subject's precision), and the laws that hold for every query.
#pragma once

#include <concepts>
#include <optional>
#include <string>
#include <utility>

#include "model/answers.h"
#include "oracle/judge/judge.h"
#include "oracle/query.h"
#include "oracle/tolerance/precision.h"

namespace touchstone::properties {

/// Asks only if every number of the scene is exact in the subject's precision.
template <std::invocable Ask>
oracle::Finding of_scene(const Scene& scene, const oracle::Subject& subject, Ask&& ask) {
  if (!oracle::exact_in(scene, subject.card().precision)) {
    return oracle::judge::outside("the scene is not exact in the subject's precision");
  }
  return ask();
}

/// The same, for two bodies.
template <std::invocable Ask>
oracle::Finding of_pair(const Scene& scene, const oracle::Subject& subject, Ask&& ask) {
  if (scene.bodies.size() != 2) return oracle::judge::outside("not exactly two bodies");
  return of_scene(scene, subject, std::forward<Ask>(ask));
}

/// The same, for a scene from an exact motion (properties/transforms/scene.h), if that was possible.
template <std::invocable<const Scene&> Ask>
oracle::Finding of_moved(const std::optional<Scene>& moved, const oracle::Subject& subject, Ask&& ask) {
  if (!moved) return oracle::judge::outside("the motion is not exact in doubles for this scene");
  return of_scene(*moved, subject, [&] { return ask(*moved); });
}

/// The query returns, with finite numbers. `sane(const T&)` then says what is wrong with them; "" if nothing.
template <class T, class Sane>
oracle::Finding survives(oracle::QueryFunction<T> query, const Scene& scene, oracle::Subject& subject, Sane&& sane) {
  return oracle::judge::given((subject.*query)(scene), [&](const T& said) {
    const std::string fault = sane(said);
    return fault.empty() ? oracle::judge::holds()
                         : oracle::judge::wrong(oracle::Defect::garbage, fault, "a consistent answer");
  });
}

/// Asks the same question three times, with another one before the last: all three answers must be equal, bit for bit.
/// A subject that answers once may need more than the time limit the next time, on a busy machine: a hang is no other
/// answer.
template <class T>
oracle::Finding repeats(oracle::QueryFunction<T> query, const Scene& scene, const Scene& another,
                        oracle::Subject& subject) {
  return oracle::judge::given((subject.*query)(scene), [&](const T& first) {
    const Answer<T> second = (subject.*query)(scene);
    (subject.*query)(another);
    const Answer<T> third = (subject.*query)(scene);
    const Answer<T> expected = first;
    if (hung(second) || hung(third)) return oracle::judge::outside("answered once, and once not within the time limit");
    if (second == expected && third == expected) return oracle::judge::holds();
    return oracle::judge::wrong(
        oracle::Defect::nondeterministic,
        second == expected ? "another answer after a different query" : "another answer when repeated at once",
        "the same answer to the same query");
  });
}

}  // namespace touchstone::properties
