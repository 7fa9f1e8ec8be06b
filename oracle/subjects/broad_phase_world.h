// How an engine's broad phase is asked, about a film and about a scene: it is told of the bodies, frame by frame.
#pragma once

#include <functional>
#include <memory>
#include <stdexcept>

#include "oracle/subject.h"

namespace touchstone::oracle::subjects {

/// An engine's structure, for the bodies of one scene. Pairs come sorted; nothing else is done to them.
class World {
 public:
  virtual ~World() = default;

  virtual void put(int body, const Pose& X_WB) = 0;   ///< it was not there
  virtual void move(int body, const Pose& X_WB) = 0;  ///< it was
  virtual void take(int body) = 0;
  virtual PairFrame end_frame() = 0;
};

/// The engine does not take this scene; what it says becomes the abstention.
struct Declined : std::runtime_error {
  using std::runtime_error::runtime_error;
};

using MakeWorld = std::function<std::unique_ptr<World>(const Scene&)>;

/// Answers broad_phase and pair_history, each question in a world of its own. The scene outlives the world.
std::unique_ptr<Subject> broad_phase_subject(Card card, MakeWorld make_world);

/// The two answers, for adapters that have more.
Answer<PairSet> broad_phase_in(const MakeWorld& make_world, const Scene& scene);
Answer<PairHistory> pair_history_in(const MakeWorld& make_world, const Scene& film);

}  // namespace touchstone::oracle::subjects
