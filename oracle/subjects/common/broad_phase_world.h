// Queries an engine's broad phase about a scene or a sequence: the bodies are passed to it frame by frame.
#pragma once

#include <functional>
#include <memory>
#include <stdexcept>

#include "oracle/subject.h"

namespace touchstone::oracle::subjects {

/// An engine's broad-phase structure for the bodies of one scene. Pairs are reported sorted; they are not changed
/// otherwise.
class World {
 public:
  virtual ~World() = default;

  virtual void put(int body, const Pose& X_WB) = 0;   ///< adds a body that was absent
  virtual void move(int body, const Pose& X_WB) = 0;  ///< moves a body that was present
  virtual void take(int body) = 0;
  virtual PairFrame end_frame() = 0;
};

/// Thrown if the engine does not take the scene; the message becomes the abstention's reason.
struct Declined : std::runtime_error {
  using std::runtime_error::runtime_error;
};

using MakeWorld = std::function<std::unique_ptr<World>(const Scene&)>;

/// Answers broad_phase and pair_history, each query with a new world. The scene must outlive the world.
std::unique_ptr<Subject> broad_phase_subject(Card card, MakeWorld make_world);

/// The two answers, for adapters that answer further queries.
Answer<PairSet> broad_phase_in(const MakeWorld& make_world, const Scene& scene);
Answer<PairHistory> pair_history_in(const MakeWorld& make_world, const Scene& sequence);

}  // namespace touchstone::oracle::subjects
