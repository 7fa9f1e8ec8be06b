// The families as a RapidCheck generator: a counterexample shrinks by the steps of our own minimiser.
//
// (RapidCheck's own integers shrink towards the ends of their range, and its doubles only to 0, −x and trunc(x).)
#pragma once

#include <rapidcheck.h>

#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "model/json.h"
#include "oracle/minimise/shrink.h"
#include "properties/scenes/domain.h"

namespace touchstone {

/// How RapidCheck prints a scene (found by its type).
inline void showValue(const Scene& scene, std::ostream& out) { out << text_of(json_of(scene)); }

}  // namespace touchstone

namespace touchstone::properties {

/// The moves of one stage after the other; each is tried only when RapidCheck asks for the next candidate.
class SmallerScenes {
 public:
  explicit SmallerScenes(Scene scene) : scene_(std::make_shared<Scene>(std::move(scene))) {}

  rc::Maybe<Scene> operator()() {
    const std::vector<oracle::shrink::Stage>& stages = oracle::shrink::stages();
    while (true) {
      for (; move_ < moves_.size(); ++move_) {
        if (std::optional<Scene> candidate = oracle::shrink::step(*scene_, moves_[move_])) {
          ++move_;
          return std::move(*candidate);
        }
      }
      if (stage_ == stages.size()) return rc::Nothing;
      moves_ = stages[stage_++](*scene_);
      move_ = 0;
    }
  }

 private:
  std::shared_ptr<const Scene> scene_;
  std::vector<oracle::shrink::Move> moves_;
  std::size_t stage_ = 0;
  std::size_t move_ = 0;
};

/// A scene of one of the families for `query`.
inline rc::Gen<Scene> scene_for(const std::string& query) {
  std::vector<Family> fitting;
  for (const Family& family : families()) {
    for (const std::string& its : family.queries) {
      if (its == query) fitting.push_back(family);
    }
  }
  const auto drawn = rc::gen::map(rc::gen::pair(rc::gen::noShrink(rc::gen::inRange<std::size_t>(0, fitting.size())),
                                                rc::gen::noShrink(rc::gen::arbitrary<std::uint64_t>())),
                                  [fitting](const std::pair<std::size_t, std::uint64_t>& which) {
                                    return draw(fitting[which.first], which.second, 0);
                                  });
  return rc::gen::shrink(drawn, [](Scene scene) { return rc::makeSeq<SmallerScenes>(std::move(scene)); });
}

}  // namespace touchstone::properties
