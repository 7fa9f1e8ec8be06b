// Finds the contact points of a step, and keeps what the next step can use of each pair.
#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "fast/broad_phase/sweep_and_prune.h"
#include "fast/constraint/pair_events.h"
#include "fast/constraint/stepper_body.h"
#include "fast/contact/gap_manifold.h"
#include "fast/contact/row.h"
#include "fast/lin_canny/nearest_parts.h"

namespace touchstone::fast::constraint {

/// What is kept about a pair whose boxes overlap.
struct TrackedPair {
  /// A contact point of the last step and its impulse.
  struct Loaded {
    Vec3 p_WC, P;
  };
  std::optional<Vec3> nhat_BA_W;
  std::vector<lin_canny::FeaturePair> walk = {{}};  ///< features at which the last closest-feature walk ended
  Pose X_WA, X_WB;                                  ///< at the last query
  std::optional<lin_canny::Proximity> proximity;    ///< its result
  std::vector<Loaded> loaded;                       ///< of the last step
  PairEvents pair_events;
  bool seen = false;  ///< in this step the pair was close enough to touch
};

struct ContactPair {
  TrackedPair* tracked = nullptr;
  std::size_t first = 0, count = 0;  ///< its range in StepContacts::rows
  int a = 0, b = 0;
};

/// The contacts of a step. Each row has one point.
struct StepContacts {
  std::vector<ContactPair> pairs;
  std::vector<contact::ContactRow> rows;
  std::vector<contact::GapPoint> points;
};

class ContactSearch {
 public:
  /// `skin`: the distance at which bodies rest (m). The scene must outlive this object.
  ContactSearch(const Scene& scene, const std::vector<StepperBody>& bodies, double skin, double longest_step);

  /// The contacts of a step of h. The rows are not prepared, and have the impulses of the last step as a guess. Throws
  /// InputError if two bodies overlap in the first step.
  StepContacts find(const std::vector<StepperBody>& bodies, double h);

  /// The normal of a pair once one of its bodies has moved by `way`.
  static Vec3 normal(const ContactPair& pair, const std::vector<StepperBody>& bodies, std::size_t moved,
                     const Vec3& way);

  void move(std::size_t body, const StepperBody& moved);

  std::map<std::pair<int, int>, TrackedPair>& tracked() { return tracked_; }

  /// Drops the pairs whose boxes did not overlap in the last search.
  void forget_distant();

 private:
  double greatest_speed(const std::vector<StepperBody>& bodies) const;
  double greatest_shift(const StepperBody& body, double h) const;
  Aabb around(const StepperBody& body) const;
  const lin_canny::Proximity& proximity(TrackedPair& tracked, const StepperBody& A, const StepperBody& B) const;
  void find(const std::vector<StepperBody>& bodies, int a, int b, double h, StepContacts& found);

  const Scene& scene_;
  double skin_;
  double margin_;  ///< m; added to the boxes, so that they overlap before the bodies can touch
  SweepAndPrune boxes_;
  bool first_step_ = true;
  std::vector<BodyPair> near_;  ///< sorted
  std::map<std::pair<int, int>, TrackedPair> tracked_;
};

}  // namespace touchstone::fast::constraint
