// The time stepper: collision detection, contact solve, integration.
#pragma once

#include <optional>
#include <vector>

#include "fast/constraint.h"
#include "fast/constraint/contact_search.h"
#include "fast/constraint/step_length.h"
#include "fast/constraint/stepper_body.h"
#include "fast/contact/row.h"

namespace touchstone::fast::constraint {

/// The only body that moves, if it is a ball without applied forces.
struct LoneBall {
  std::size_t index;
  StepLength length;
  double last_h = 0;  ///< s; the last step
};

class Stepper {
 public:
  Stepper(const Scene& scene, double longest_step, int sweeps);

  /// Goes from `from` to `to` (s) in so many short steps of one length, or in fewer if some of them may be long.
  void advance(double from, double to, int steps);

  std::vector<State> states() const;
  std::vector<Event>& events() { return events_; }

 private:
  /// Steps from `time` by h. Contact events get the end of the step, `until`, as their time, force events its
  /// beginning.
  void short_step(double time, double h, double until);
  /// Returns false, and changes no state, if something changes within h.
  bool long_step(double time, double h, double short_h);
  bool changes_nothing(const std::vector<contact::Twist>& twists, double h, double short_h);
  void find_contacts(double h);
  void emit_forces(double time);
  std::vector<Vec3> applied_forces(double time) const;  ///< N; on each body
  std::vector<contact::Twist> free_twists(const std::vector<Vec3>& force_W, double h) const;
  /// The greatest velocity that gravity and applied forces add to a body in a step, m/s.
  double weight(const std::vector<Vec3>& force_W, double h) const;
  void solve_contacts(std::vector<contact::Twist>& twists, double weight);
  std::vector<contact::Twist> apart(double h);
  void keep_impulses(const ContactPair& contact_pair) const;
  void emit(double weight, double until);
  PairStep pair_step(const ContactPair& contact_pair, double slow) const;

  const Scene& scene_;
  int sweeps_;
  double skin_;  ///< m; the distance at which bodies rest
  std::vector<StepperBody> bodies_;
  std::vector<contact::Mobility> mobilities_;  ///< of bodies_, at the beginning of the step
  std::optional<LoneBall> lone_ball_;
  ContactSearch search_;
  StepContacts contacts_;
  std::vector<double> u_n_;   ///< of the contacts' rows, before the step
  std::vector<double> slip_;  ///< of the contacts' rows, after the step
  std::size_t begun_ = 0;     ///< forces that have begun to act
  std::vector<Event> events_;
};

}  // namespace touchstone::fast::constraint
