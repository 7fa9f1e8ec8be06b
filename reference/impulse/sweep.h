// The phases of an impact while the direction of slip turns, enclosed: every number is an interval that holds the exact
// one.
//
// The independent variable is the direction itself: t = tan(δ/2), with δ the turn since a direction σ. With q = 1 + t²
// and the quartics G = q² g and H = q² h (g, h: reference/impulse/slide.h), the equations are linear:
//   ds/dt = 2 G s/(q H)   dp/dt = 2 q s/H   dD/dt = 2 q s²/H
// So the power series in t have recurrences of fixed length, and errors only add up from step to step. The recurrence
// itself bounds the remainder of a cut series: if its terms c_n ρⁿ cannot grow, they stay below the last few of them.
// docs/design/impulse.md has the proofs.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "reference/exact/enclosed.h"
#include "reference/impulse/law.h"

namespace touchstone::reference {

/// K and μ in axes (e1, e2, n), |n| = 1, and u before the impact.
struct EnclosedContact {
  explicit EnclosedContact(const ImpactProblem<Enclosed>& problem);

  EnclosedVec e1, e2, n;
  Enclosed m11, m12, m22, k1, k2, b, mu;
  EnclosedVec u0;  ///< in these axes
  bool painleve;

  /// The state at slip (u1, u2) and normal impulse p.
  ImpactState<Enclosed> impact_state(const Enclosed& u1, const Enclosed& u2, const Enclosed& p,
                                     const Enclosed& D) const;
};

/// The tangential direction, of length μ, in which slip leaves 0 if the contact does not stick. Throws Undecided.
EnclosedVec diverging(const ImpactProblem<Enclosed>& problem, const EnclosedVec& sticking);

/// G and H as functions of the turn from a direction, and q H.
struct Field {
  std::array<Enclosed, 5> G, H;
  std::array<Enclosed, 7> qH;
};

/// A direction of slip, and the state there.
struct Heading {
  Enclosed x, y, s, p, D;
};

/// Every member function throws Undecided where the enclosures do not decide the order of two numbers, or where too
/// many steps are needed.
class Sweep {
 public:
  explicit Sweep(const ImpactProblem<Enclosed>& problem);

  const std::optional<Enclosed>& stopped() const { return stopped_; }
  std::unique_ptr<Phase<Enclosed>> next(const ImpactProgress<Enclosed>& progress);

 private:
  const ImpactProblem<Enclosed>& problem_;
  EnclosedContact contact_;
  Heading now_;
  int steps_ = 0;
  std::optional<Enclosed> stopped_;

  std::unique_ptr<Phase<Enclosed>> to_the_stop(const ImpactProgress<Enclosed>& progress);
  std::unique_ptr<Phase<Enclosed>> arc(const ImpactProgress<Enclosed>& progress, const Field& f, const Enclosed& rho);
};

}  // namespace touchstone::reference
