// A plane that turns at a constant rate and is proved to stay between two moving cores for some time.
//
// n points from B to A, N(h) = n + h m. For vertices a and b let d = a − b at h = 0 and d' its rate there, c the
// difference of the reference points' accelerations, and K a bound of all other acceleration of a − b. By Taylor's
// theorem
//   N(h)·(a − b)(h) ≥ n·d + h (n·d' + m·d) + h² (m·d' + ½ n·c) + ½ h³ m·c − ½ K h² (|n| + h |m|).
// Positive quadratic and cubic terms are left out, so the bound is concave in h, and so is its least value over all
// vertices: if it is positive at 0 and at h, it is positive between. Swollen cores are apart while it is greater than r
// |N(h)| ≤ r (|n| + h n·m/|n| + ½ h² |m|²/|n|).
#pragma once

#include <algorithm>
#include <optional>
#include <tuple>
#include <vector>

#include "reference/time_of_impact/moving_core.h"

namespace touchstone::reference {

template <class T>
struct MovingPlane {
  Coordinates<T> n, m;
};

/// Two cores at the same time, their radius r (the radii, and the distance that counts as contact), and the constants
/// of the bound above.
template <class Tier>
struct Pairing {
  using E = typename Tier::E;
  Snapshot<Tier> A, B;
  Coordinates<typename Tier::P> from;
  Coordinates<E> c;
  E r;
  E K;
};

/// For two cores in contact: n·a ≥ n·x and n·y ≥ n·b for all vertices, with equality where on_A or on_B say so. x − y
/// has length r and points along n.
template <class Tier>
struct Support {
  Coordinates<typename Tier::E> x, y;  ///< relative to the same point as the vertices
  std::vector<bool> on_A, on_B;
};

/// The bound as a function of h.
template <class Tier>
class Clearance {
 public:
  using E = typename Tier::E;
  using P = typename Tier::P;

  /// With `support` the two are in contact at h = 0, and apart after it while the bound is positive. Opens the tier's
  /// scope itself.
  Clearance(const Pairing<Tier>& pair, const MovingPlane<E>& plane,
            const std::optional<Support<Tier>>& support = std::nullopt)
      : in_contact_(support) {
    const typename Tier::Scope scope;
    const auto& [n, m] = plane;
    std::optional<P> slowest, fastest;  // along m: slowest of A, fastest of B
    for (std::size_t i = 0; i < pair.A.places.size(); ++i) {
      const Coordinates<E>& at = pair.A.places[i];
      const E above = !support ? dot(n, at) : support->on_A[i] ? E(0) : dot(n, at - support->x);
      A_.push_back({above, dot(n, pair.A.rates[i]) + dot(m, at)});
      const P rate = lower(dot(m, pair.A.rates[i]));
      slowest = slowest ? lesser(*slowest, rate) : rate;
    }
    for (std::size_t i = 0; i < pair.B.places.size(); ++i) {
      const Coordinates<E>& at = pair.B.places[i];
      const E above = !support ? dot(n, at) : support->on_B[i] ? E(0) : dot(n, at - support->y);
      B_.push_back({above, dot(n, pair.B.rates[i]) + dot(m, at)});
      const P rate = upper(dot(m, pair.B.rates[i]));
      fastest = fastest ? greater(*fastest, rate) : rate;
    }
    set_terms(pair, plane, thin(*slowest) - thin(*fastest));
    for (const Height& a : A_) low_A_.push_back({lower(a.at), lower(a.rate)});
    for (const Height& b : B_) high_B_.push_back({upper(b.at), upper(b.rate)});
  }

  /// Are they certainly apart from `then` to `next`? Opens the tier's scope itself.
  bool positive(const P& then, const P& next) const {
    const typename Tier::Scope scope;
    return (in_contact_ || positive_at(E(0))) && positive_at(thin(next) - thin(then));
  }

  /// Estimate in plain numbers of the greatest h ≤ limit at which the bound is not negative. Newton's method from the
  /// right cannot pass the root of a concave function. None if the bound is not positive at 0. Call outside the scope.
  [[gnu::noinline]] std::optional<P> about(const P& limit) const {
    if (!in_contact_ && !(value(P(0)).at > 0)) return std::nullopt;
    P h = limit;
    for (int i = 0; i < 100; ++i) {
      const Line now = value(h);
      if (!(now.at < 0)) return h;
      const P next = h - now.at / now.rate;
      if (!(next > 0)) return std::nullopt;
      const bool settled = !(h - next > next * P(0x1p-30));
      h = std::min(h, next);
      if (settled) break;
    }
    return h;
  }

 private:
  struct Height {
    E at, rate;
  };
  struct Line {
    P at, rate;
  };

  /// `slide` is the least value of m·d'.
  void set_terms(const Pairing<Tier>& pair, const MovingPlane<E>& plane, const E& slide) {
    const auto& [n, m] = plane;
    const E n_length = length(n), m_length = length(m);
    const E half = E(1) / E(2);
    start_ = in_contact_ ? E(0) : E(pair.r * n_length);
    linear_ = pair.r * at_least_0(dot(n, m) / n_length);
    square_ = at_least_0(half * (pair.K * n_length - dot(n, pair.c) + pair.r * m_length * m_length / n_length) - slide);
    cube_ = at_least_0(half * (pair.K * m_length - dot(m, pair.c)));
  }

  bool positive_at(const E& h) const {
    const P room = upper(E(start_ + h * (linear_ + h * (square_ + h * cube_))));
    std::optional<P> low, high;
    for (const Height& a : A_) {
      const P x = lower(E(a.at + h * a.rate));
      low = low ? lesser(*low, x) : x;
    }
    for (const Height& b : B_) {
      const P x = upper(E(b.at + h * b.rate));
      high = high ? greater(*high, x) : x;
    }
    return lower(E(thin(*low) - thin(*high) - thin(room))) > 0;
  }

  static E at_least_0(const E& x) { return thin(greater(P(0), upper(x))); }

  Line value(const P& h) const {
    const auto at = [&](const Line& line) { return P(line.at + h * line.rate); };
    const auto lower_at = [&](const Line& a, const Line& b) { return at(a) < at(b); };
    const Line& a = *std::min_element(low_A_.begin(), low_A_.end(), lower_at);
    const Line& b = *std::max_element(high_B_.begin(), high_B_.end(), lower_at);
    const P s = upper(start_), l = upper(linear_), q = upper(square_), c = upper(cube_);
    return {P(at(a) - at(b) - s - h * (l + h * (q + h * c))), P(a.rate - b.rate - l - h * (2 * q + 3 * h * c))};
  }

  bool in_contact_;
  std::vector<Height> A_, B_;
  std::vector<Line> low_A_, high_B_;
  E start_, linear_, square_, cube_;
};

}  // namespace touchstone::reference
