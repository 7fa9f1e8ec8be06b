// An impact's course while the direction of slip turns, enclosed: every number is an interval that holds the exact one.
//
// Here the direction itself is what everything depends on, t = tan(δ/2), δ the turn since a direction σ. With q = 1 +
// t² and the quartics G = q² g and H = q² h (g, h: impact_slide_impl.h), the equations are linear:
//   ds/dt = 2 G s/(q H)   dp/dt = 2 q s/H   dD/dt = 2 q s²/H
// so the power series in t have recurrences of fixed length, errors only add up from step to step, and what a cut
// series leaves out is bounded by the recurrence itself: if its terms c_n ρⁿ cannot grow, they stay below the last few
// of them. docs/design/impulse.md has the proofs.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "reference/enclosed_impl.h"
#include "reference/impact_law_impl.h"

namespace touchstone::reference {

/// K, μ and the normal in axes (e1, e2, n), |n| = 1; u before.
struct EnclosedContact {
  explicit EnclosedContact(const Blow<Enclosed>& blow);

  EnclosedVec e1, e2, n;
  Enclosed m11, m12, m22, k1, k2, b, mu;
  Enclosed w1, w2, U0;
  bool painleve;

  /// What has happened once slip is (u1, u2) and the normal impulse p.
  Moment<Enclosed> moment(const Enclosed& u1, const Enclosed& u2, const Enclosed& p, const Enclosed& D) const;
};

/// The tangential direction, of length μ, in which slip leaves 0 if it does not stick. Throws Undecided.
EnclosedVec diverging(const Blow<Enclosed>& blow, const EnclosedVec& sticking);

/// G and H of a turn from a direction, and q H.
struct Field {
  std::array<Enclosed, 5> G, H;
  std::array<Enclosed, 7> qH;
};

/// A direction, and the state there.
struct Heading {
  Enclosed x, y, s, p, D;
};

/// Throws Undecided, from any of its calls, where an order of two numbers does not show, or the way is too long.
class Sweep {
 public:
  explicit Sweep(const Blow<Enclosed>& blow);

  const std::optional<Enclosed>& stopped() const { return stopped_; }
  std::unique_ptr<Stretch<Enclosed>> next(const Walk<Enclosed>& walk);

 private:
  const Blow<Enclosed>& blow_;
  EnclosedContact contact_;
  Heading now_;
  int steps_ = 0;
  std::optional<Enclosed> stopped_;

  std::unique_ptr<Stretch<Enclosed>> to_the_stop(const Walk<Enclosed>& walk);
  std::unique_ptr<Stretch<Enclosed>> arc(const Walk<Enclosed>& walk, const Field& f, const Enclosed& rho);
};

}  // namespace touchstone::reference
