// The steps themselves: who is near, what pushes, where all go.
#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "fast/broad_phase/sweep_and_prune.h"
#include "fast/constraint.h"
#include "fast/constraint/manifold.h"
#include "fast/constraint/pair_watch.h"
#include "fast/constraint/solve.h"
#include "fast/lin_canny/nearest_parts.h"

namespace touchstone::fast::constraint {

class Stepper {
 public:
  Stepper(const Scene& scene, double longest_step, int sweeps);

  /// From `time` by h; events are told at the end of the step, `until`, pushes at its beginning.
  void step(double time, double h, double until);

  std::vector<State> states() const;
  std::vector<Event>& events() { return events_; }

 private:
  /// A point of the last step, and what pushed there.
  struct Pushed {
    Vec3 p_WC, P;
  };
  /// What is kept of a pair that is near.
  struct Pair {
    std::optional<Vec3> nhat_BA_W;
    std::vector<lin_canny::FeaturePair> walk = {{}};  ///< where the last walk to the closest features ended
    std::vector<Pushed> pushed;                       ///< in the last step
    PairWatch watch;
    bool seen = false;  ///< in this step: near enough to touch
  };
  struct Met {
    Pair* pair = nullptr;
    std::size_t first = 0, count = 0;  ///< its touches
    int a = 0, b = 0;
  };

  double greatest_speed(double duration) const;
  double span(const Mover& body, double h) const;
  void meet(double h);
  void meet(int a, int b, double h);
  void guess(const Met& met);
  Aabb around(const Mover& body) const;
  void tell_pushes(double time);
  std::vector<Twist> free_twists(double time, double h) const;
  void push(std::vector<Twist>& twists, double weight);  ///< weight: what gravity adds in a step, m/s
  std::vector<Twist> apart(double h);
  void tell(double weight, double until);
  PairStep told(const Met& met, double slow) const;

  const Scene& scene_;
  int sweeps_;
  double skin_;  ///< bodies rest this far apart
  std::vector<Mover> movers_;
  std::vector<Mobility> mobilities_;  ///< of the movers, at the beginning of the step
  double margin_;                     ///< boxes meet before their bodies can
  SweepAndPrune boxes_;
  bool first_step_ = true;
  std::vector<BodyPair> near_;  ///< sorted
  std::map<std::pair<int, int>, Pair> pairs_;
  std::vector<Met> met_;
  std::vector<Touch> touches_;
  std::vector<ContactPoint> points_;  ///< of the touches
  std::vector<double> u_n_;           ///< of the touches, before the step
  std::vector<double> slip_;          ///< of the touches, after it
  std::size_t begun_ = 0;             ///< pushes
  std::vector<Event> events_;
};

}  // namespace touchstone::fast::constraint
