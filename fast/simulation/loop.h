// The loop of the lecture notes: frames, boxes, a heap of pairs, impacts.
#pragma once

#include <map>
#include <unordered_map>
#include <vector>

#include "fast/simulation.h"
#include "fast/simulation/body.h"
#include "fast/simulation/group.h"
#include "fast/simulation/impact.h"
#include "fast/simulation/meeting.h"
#include "fast/simulation/pair_heap.h"
#include "fast/simulation/resting.h"
#include "fast/simulation/tiling.h"

namespace touchstone::fast::world {

/// Of a pair, a < b.
inline std::uint64_t key(BodyId a, BodyId b) { return std::uint64_t{a} << 32 | b; }

/// One run of a scene. Each body has a path of its own, from its own last event on; nothing is stepped.
class Loop {
 public:
  /// The scene must outlive the loop.
  Loop(const Scene& scene, const SimulationOptions& options);

  Simulated run();

 private:
  /// A body that is about to rest on another.
  struct Laid {
    BodyId id, on;
    Vec3 nhat_W;  ///< towards it
    State state;  ///< without velocity along n̂
  };

  void begin_frame();
  bool turn();
  void push(const Push& push);
  void attend(const Due& due);
  void stop_if_endless(const Due& due);
  bool goes_on(const Due& due);
  void meet(const Due& due, const Touch& touch);
  std::optional<Touch> foremost(const Due& due);

  bool strikes_endlessly(const Due& due, double u_n);
  void watch_later(const Due& due);
  void strike(Event::Kind kind, const Due& due, const Touch& touch, Hit hit);
  bool hold(const Due& due, const Touch& touch, const Hops& hops, double until);
  bool can_rest(const Due& due, const Touch& touch) const;
  std::optional<Laid> laid(const Due& due, const Touch& touch) const;
  std::optional<Rest> rest_of(const Laid& laid, double load) const;
  bool lay(const Laid& laid, const Hops& hops, double hops_end);
  void change(BodyId id);
  void release(BodyId id, const State& state);
  void look_until(double time, bool over);

  Group* group_of(BodyId id);
  const Group* group_of(BodyId id) const;
  bool is_held(BodyId id) const { return group_of_[id] || rest_[id]; }
  bool follows_steps(BodyId id) const { return bodies_[id].fixed() || group_of_[id]; }
  State state(BodyId id) const;
  double hop_of(BodyId a, BodyId b) const;
  double least_hop(const Group& group) const;  ///< of its pairs
  double swing(BodyId a, BodyId b) const;
  Rider rider(BodyId id);
  void cut(BodyId id);
  void attend_held(const Due& due);
  void not_yet(const Due& due);
  void part_held(const Due& due);
  bool join(const Due& due);
  void enter(Group group);
  std::optional<BodyId> waiting() const;
  std::optional<BodyId> first_to_arrive() const;
  void arrive(BodyId key);
  void begin(BodyId key);
  void settle(BodyId key);
  void strike_in(const Strike& found);
  void fly_off(const Rider& rider, const std::vector<Joint>& parted);
  bool rests_alone(Group& group);
  void take_step(Group& group);
  void set_on_course(Group& group);
  void tell(Event::Kind kind, const Joint& joint);

  /// Whose box is made anew in each frame, and who asks whom it meets; in the first frame also who only could move.
  bool moves(BodyId id) const { return !bodies_[id].still() || (done_.books.frames == 1 && !bodies_[id].fixed()); }
  double start(BodyId id) const;
  void begin_anew(BodyId id);
  void file(BodyId id);
  std::span<const BodyId> near(BodyId id);
  void watch(BodyId a, BodyId b, double from);
  void watch_all(BodyId id, BodyId but);
  void set_out(BodyId id, const State& state);
  Memory& memory(BodyId a, BodyId b);
  void refuse_overlap(BodyId a, BodyId b, const Touch& touch) const;
  /// Rests are long, and only on what is fixed: for most pairs they are not looked up.
  bool rests_on(BodyId id, BodyId on) const { return bodies_[on].fixed() && rest_[id] && rest_[id]->on == on; }
  void record(const Event& event);
  void record_contact(Event::Kind kind, BodyId id, const Vec3& v_before, double since);
  void stop(const Due& due, const std::string& why);
  void keep_momentum();
  void move_exactly(const Due& due, Hit& hit);

  const Scene* scene_;
  SimulationOptions options_;
  double envelope_;
  double reach_;  ///< m; bodies that are held and as near as this to each other are followed together
  double now_ = 0, frame_end_ = 0, end_ = 0;
  double sliver_end_ = 0;   ///< s
  std::int64_t turns_ = 0;  ///< since time came into this sliver of a frame
  std::int64_t events_ = 0;
  std::vector<Mover> bodies_;
  PairHeap heap_;
  std::vector<std::optional<Rest>> rest_;        ///< by body
  std::map<BodyId, Group> groups_;               ///< by the first body of each that moves
  std::vector<std::optional<BodyId>> group_of_;  ///< by body
  std::vector<double> struck_;                   ///< s, by body that moves: its last impact
  std::vector<std::uint64_t> strikes_;           ///< likewise: how many
  std::vector<Vec3> pull_;  ///< by body: what gravity and its push accelerate it by (m/s²), if it moves
  std::size_t pushed_ = 0;
  Tiling tiling_;
  std::unordered_map<std::uint64_t, Memory> memory_;  ///< looked up only, never walked
  Memory no_memory_;
  std::vector<Vec3> momentum_;  ///< by body, in multiples of the grid, if it is kept exact
  double grid_ = 0;             ///< N s; 0: velocities are what is kept
  std::size_t looked_ = 0;
  Simulated done_;
};

}  // namespace touchstone::fast::world
