// The time stepper: collision detection, contact solve, integration.
#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "fast/broad_phase/sweep_and_prune.h"
#include "fast/constraint.h"
#include "fast/constraint/pair_events.h"
#include "fast/constraint/stepper_body.h"
#include "fast/contact/gap_manifold.h"
#include "fast/contact/row.h"
#include "fast/lin_canny/nearest_parts.h"

namespace touchstone::fast::constraint {

class Stepper {
 public:
  Stepper(const Scene& scene, double longest_step, int sweeps);

  /// Steps from `time` by h. Contact events get the end of the step, `until`, as their time, force events its
  /// beginning.
  void step(double time, double h, double until);

  std::vector<State> states() const;
  std::vector<Event>& events() { return events_; }

 private:
  /// A contact point of the last step and its impulse.
  struct Pushed {
    Vec3 p_WC, P;
  };
  /// What is kept about a pair whose boxes overlap.
  struct Pair {
    std::optional<Vec3> nhat_BA_W;
    std::vector<lin_canny::FeaturePair> walk = {{}};  ///< features at which the last closest-feature walk ended
    std::vector<Pushed> pushed;                       ///< of the last step
    PairEvents pair_events;
    bool seen = false;  ///< in this step the pair was close enough to touch
  };
  struct ContactPair {
    Pair* pair = nullptr;
    std::size_t first = 0, count = 0;  ///< its range in rows_
    int a = 0, b = 0;
  };

  double greatest_speed(double duration) const;
  double span(const StepperBody& body, double h) const;
  void find_contacts(double h);
  void find_contacts(int a, int b, double h);
  void guess(const ContactPair& contact_pair);
  Aabb around(const StepperBody& body) const;
  void emit_forces(double time);
  std::vector<contact::Twist> free_twists(double time, double h) const;
  void push(std::vector<contact::Twist>& twists,
            double weight);  ///< weight: the velocity that gravity adds in a step, m/s
  std::vector<contact::Twist> apart(double h);
  void emit(double weight, double until);
  PairStep pair_step(const ContactPair& contact_pair, double slow) const;

  const Scene& scene_;
  int sweeps_;
  double skin_;  ///< m; the distance at which bodies rest
  std::vector<StepperBody> bodies_;
  std::vector<contact::Mobility> mobilities_;  ///< of bodies_, at the beginning of the step
  double margin_;  ///< m; added to the boxes, so that they overlap before the bodies can touch
  SweepAndPrune boxes_;
  bool first_step_ = true;
  std::vector<BodyPair> near_;  ///< sorted
  std::map<std::pair<int, int>, Pair> pairs_;
  std::vector<ContactPair> contact_pairs_;
  std::vector<contact::ContactRow> rows_;
  std::vector<contact::GapPoint> points_;  ///< of rows_
  std::vector<double> u_n_;                ///< of rows_, before the step
  std::vector<double> slip_;               ///< of rows_, after the step
  std::size_t begun_ = 0;                  ///< forces that have begun to act
  std::vector<Event> events_;
};

}  // namespace touchstone::fast::constraint
