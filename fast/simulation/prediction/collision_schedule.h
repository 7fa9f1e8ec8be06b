// Which pairs of bodies may collide within the frame, and which of them first.
#pragma once

#include <unordered_map>

#include "fast/simulation/island/islands.h"
#include "fast/simulation/prediction/event_queue.h"
#include "fast/simulation/prediction/hash_grid.h"
#include "fast/simulation/rest/resting_bodies.h"
#include "fast/simulation/stall_guard.h"

namespace touchstone::fast::simulation {

/// The detection of the lecture notes: boxes that enclose the trajectories over a frame, their intersections, and for
/// each pair a lower bound of its time of impact in a heap.
class CollisionSchedule {
 public:
  /// Everything that is given must outlive the schedule. `frame`: the length of a frame (s). Counts frames and queries.
  CollisionSchedule(const World& world, const Islands& islands, const RestingBodies& rests, double frame,
                    Statistics& statistics, StallGuard& guard);

  void begin_frame();
  /// Updates the boxes of bodies that move, and predicts the contacts of all pairs whose boxes intersect. Throws
  /// InputError if two bodies overlap when the motion of the later one starts.
  void predict_frame();
  double frame_end() const { return frame_end_; }

  /// The pair that may be in contact first; null if there is none within the frame.
  const PairEvent* next() const { return queue_.empty() ? nullptr : &queue_.top(); }
  PairEvent pop();

  /// Drops the predicted contacts of a body with a new trajectory, and updates its box.
  void trajectory_changed(BodyId id);
  /// Predicts the contacts of a body with all whose boxes intersect its own, `but` excepted.
  void predict_all(BodyId id, BodyId but);
  void predict_all(BodyId id) { predict_all(id, id); }
  /// Predicts the first contact of a pair from a time on, if it may be within the frame. Requires a < b.
  void predict(BodyId a, BodyId b, double from);

  /// The bodies whose boxes intersect that of the body, in an unspecified order. Valid until the next call. Prefetches
  /// their trajectories.
  std::span<const BodyId> neighbours(BodyId id);

  /// The nearest points of a pair at time t, which must not be before the start of both trajectories. Requires a < b.
  Touch nearest_points(BodyId a, BodyId b, double t);
  /// Whether the last search of the pair ended by its limit of queries, before it found a contact. Requires a < b.
  bool was_cut_off(BodyId a, BodyId b) { return search_memory(a, b).is_cut_off; }
  /// What is remembered of a pair, for the search and for the response. Requires a < b.
  PairMemory& memory(BodyId a, BodyId b);

 private:
  struct Search;

  /// Whether the body's box is renewed and its neighbours are queried in each frame. This includes bodies at rest that
  /// are not fixed in the first frame, and those whose resting contact ends, since that event is in one frame's queue.
  bool is_queried(BodyId id) const {
    const BodyMotion& body = world_->body(id);
    const RestingContact* rest = rests_->of(id);
    return !is_stationary(body) || (rest && rest->until < never) || (statistics_->frames == 1 && !body.fixed());
  }
  void update_proxy(BodyId id);
  std::optional<Search> search_of(BodyId a, BodyId b, double from);
  PairMemory& search_memory(BodyId a, BodyId b);
  void refuse_overlap(BodyId a, BodyId b, double t);
  const RestingContact* rest_of(BodyId a, BodyId b) const;

  const World* world_;
  const Islands* islands_;
  const RestingBodies* rests_;
  Statistics* statistics_;
  StallGuard* guard_;
  double frame_, frame_end_ = 0;
  EventQueue queue_;
  HashGrid grid_;
  std::unordered_map<std::uint64_t, PairMemory> memory_;  ///< only looked up: iteration order is unspecified
  PairMemory no_memory_;                                  ///< of pairs with a closed form, whose search needs none
};

}  // namespace touchstone::fast::simulation
