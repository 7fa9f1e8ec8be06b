// The main loop of the lecture notes: frames, bounding boxes, an event queue of pairs, impacts.
#pragma once

#include <map>
#include <unordered_map>
#include <vector>

#include "fast/simulation.h"
#include "fast/simulation/body_motion.h"
#include "fast/simulation/event_queue.h"
#include "fast/simulation/hash_grid.h"
#include "fast/simulation/impact.h"
#include "fast/simulation/island.h"
#include "fast/simulation/pair_time_of_impact.h"
#include "fast/simulation/resting_contact.h"

namespace touchstone::fast::world {

/// The key of a pair, a < b.
inline std::uint64_t key(BodyId a, BodyId b) { return std::uint64_t{a} << 32 | b; }

/// One simulation of a scene. Each body has its own trajectory, which starts at its own last event; there are no common
/// time steps.
class Loop {
 public:
  /// The scene must outlive the loop.
  Loop(const Scene& scene, const SimulationOptions& options);

  Simulated run();

 private:
  /// A body that may start to rest on another one.
  struct RestCandidate {
    BodyId id, on;
    Vec3 nhat_W;  ///< towards the body
    State state;  ///< at rest relative to the support along n̂
  };

  void begin_frame();
  bool process_next_event();
  void apply_force(const AppliedForce& force);
  void process_pair_event(const PairEvent& pair_event);
  void stop_if_endless(const PairEvent& pair_event);
  bool makes_progress(const PairEvent& pair_event);
  void respond(const PairEvent& pair_event, const Touch& touch);
  std::optional<Touch> fastest_approach(const PairEvent& pair_event);

  bool collides_endlessly(const PairEvent& pair_event, double u_n);
  void schedule_later(const PairEvent& pair_event);
  void apply_impulse(Event::Kind kind, const PairEvent& pair_event, const Touch& touch, ImpactResult result);
  bool try_rest(const PairEvent& pair_event, const Touch& touch, const MicroBounces& bounces, double until);
  bool can_rest(const PairEvent& pair_event, const Touch& touch) const;
  std::optional<RestCandidate> rest_candidate(const PairEvent& pair_event, const Touch& touch) const;
  std::optional<RestingContact> closed_form_rest(const RestCandidate& candidate, double load) const;
  bool start_rest(const RestCandidate& candidate, const MicroBounces& bounces, double bounces_end);
  void end_rest_phase(BodyId id);
  void release(BodyId id, const State& state);
  void sample_until(double time, bool over);

  Island* island_of(BodyId id);
  const Island* island_of(BodyId id) const;
  bool is_in_contact(BodyId id) const { return island_of_[id] || rest_[id]; }
  bool follows_steps(BodyId id) const { return bodies_[id].fixed() || island_of_[id]; }
  State state(BodyId id) const;
  double rebound_speed(BodyId a, BodyId b) const;
  double least_rebound_speed(const Island& island) const;  ///< over its contact pairs
  double centripetal_bound(BodyId a, BodyId b) const;
  IslandBody island_body(BodyId id);
  void cut_step(BodyId id);
  void process_island_event(const PairEvent& pair_event);
  void recheck(const PairEvent& pair_event);
  void defer_separating_pair(const PairEvent& pair_event);
  bool merge_islands(const PairEvent& pair_event);
  void add_island(Island island);
  std::optional<BodyId> next_waiting() const;
  std::optional<BodyId> first_to_finish() const;
  void finish_step(BodyId key);
  void begin_step(BodyId key);
  void resolve_island(BodyId key);
  void impact_in_island(const ImpactCandidate& found);
  void release_from_island(const IslandBody& island_body, const std::vector<ContactPair>& released);
  bool try_closed_form(Island& island);
  void take_step(Island& island);
  void set_trajectories(Island& island);
  void emit(Event::Kind kind, const ContactPair& contact_pair);

  /// Whether the body's box is renewed and its neighbours are queried in each frame; in the first frame this includes
  /// bodies at rest that are not fixed.
  bool moves(BodyId id) const {
    return !bodies_[id].is_stationary() || (done_.statistics.frames == 1 && !bodies_[id].fixed());
  }
  double start_time(BodyId id) const;
  void restart(BodyId id);
  void update_proxy(BodyId id);
  std::span<const BodyId> neighbours(BodyId id);
  void schedule(BodyId a, BodyId b, double from);
  void schedule_all(BodyId id, BodyId but);
  void set_trajectory(BodyId id, const State& state);
  PairMemory& memory(BodyId a, BodyId b);
  void refuse_overlap(BodyId a, BodyId b, const Touch& touch) const;
  /// A resting contact is large, and its support is always fixed, so that most pairs skip the look-up.
  bool rests_on(BodyId id, BodyId on) const { return bodies_[on].fixed() && rest_[id] && rest_[id]->on == on; }
  void record(const Event& event);
  void record_contact(Event::Kind kind, BodyId id, const Vec3& v_before, double since);
  void stop(const PairEvent& pair_event, const std::string& why);
  void set_up_exact_momentum();
  void apply_exact_momentum(const PairEvent& pair_event, ImpactResult& result);

  const Scene* scene_;
  SimulationOptions options_;
  double envelope_;
  double reach_;  ///< m; bodies in contact that are this near to each other take their steps together
  double now_ = 0, frame_end_ = 0, end_ = 0;
  double stall_window_end_ = 0;  ///< s
  std::int64_t iterations_ = 0;  ///< since the stall window began
  std::int64_t events_ = 0;
  std::vector<BodyMotion> bodies_;
  EventQueue queue_;
  std::vector<std::optional<RestingContact>> rest_;  ///< indexed by body
  std::map<BodyId, Island> islands_;                 ///< keyed by the first of its bodies that move
  std::vector<std::optional<BodyId>> island_of_;     ///< indexed by body: the key of its island
  std::vector<double> last_impact_;                  ///< s, indexed by body: its last impact, if it moves
  std::vector<std::uint64_t> impacts_;               ///< indexed by body: its impacts so far, if it moves
  std::vector<Vec3> acceleration_;  ///< m/s², indexed by body: due to gravity and the applied force, if it moves
  std::size_t applied_forces_ = 0;
  HashGrid grid_of_boxes_;
  std::unordered_map<std::uint64_t, PairMemory> memory_;  ///< only looked up: iteration order is unspecified
  PairMemory no_memory_;
  std::vector<Vec3> momentum_;  ///< indexed by body, in multiples of grid_, with exact_momentum
  double grid_ = 0;             ///< N s; 0: momentum is not kept exact
  std::size_t sampled_ = 0;
  Simulated done_;
};

}  // namespace touchstone::fast::world
