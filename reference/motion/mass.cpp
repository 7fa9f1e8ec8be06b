// With the moments V = ∫ dV, m = ∫ x dV and C = ∫ x xᵀ dV of a solid,
//   centroid c = m/V,  inertia about the origin (tr C) 1 − C,  about the centroid the same with C − m mᵀ/V.
// Under p ↦ R p + t: V' = V, m' = R m + V t, C' = R C Rᵀ + (R m) tᵀ + t (R m)ᵀ + V t tᵀ. All are linear in the moments,
// so the multiple of π transforms like the rational part, separately from it.
#include "reference/mass.h"

#include <mpfr.h>

#include <algorithm>
#include <type_traits>
#include <utility>
#include <variant>

#include "reference/exact/rational.h"
#include "reference/motion/plain_pose.h"

namespace touchstone::reference {
namespace {

using Matrix = std::array<Triple, 3>;

struct Moments {
  mpq_class volume;
  Triple first;
  Matrix second;
};

void add(Moments& sum, const Moments& other) {
  sum.volume += other.volume;
  for (std::size_t i = 0; i < 3; ++i) {
    sum.first[i] += other.first[i];
    for (std::size_t j = 0; j < 3; ++j) sum.second[i][j] += other.second[i][j];
  }
}

Moments moved(const Moments& moments, const Motion& X) {
  Moments result;
  result.volume = moments.volume;
  const Triple Rm = {dot(X.rows[0], moments.first), dot(X.rows[1], moments.first), dot(X.rows[2], moments.first)};
  for (std::size_t i = 0; i < 3; ++i) {
    result.first[i] = Rm[i] + moments.volume * X.translation[i];
    for (std::size_t j = 0; j < 3; ++j) {
      mpq_class RCRt;
      for (std::size_t k = 0; k < 3; ++k) RCRt += X.rows[i][k] * dot(moments.second[k], X.rows[j]);
      result.second[i][j] = RCRt + Rm[i] * X.translation[j] + X.translation[i] * Rm[j] +
                            moments.volume * X.translation[i] * X.translation[j];
    }
  }
  return result;
}

/// rational + pi·π.
struct SolidMoments {
  Moments rational;
  Moments pi;
};

/// V = 4/3 π r³, ∫ x² dV = 4/15 π r⁵.
SolidMoments moments(const Sphere& sphere) {
  const mpq_class r(sphere.radius);
  SolidMoments result;
  result.pi.volume = mpq_class(4, 3) * r * r * r;
  for (std::size_t i = 0; i < 3; ++i) result.pi.second[i][i] = result.pi.volume * r * r / 5;
  return result;
}

/// V = 8 hx hy hz, ∫ x² dV = V hx²/3.
SolidMoments moments(const Box& box) {
  const Triple h = triple(box.half_extents);
  SolidMoments result;
  result.rational.volume = 8 * h[0] * h[1] * h[2];
  for (std::size_t i = 0; i < 3; ++i) result.rational.second[i][i] = result.rational.volume * h[i] * h[i] / 3;
  return result;
}

using Integers = std::array<mpz_class, 3>;

/// Every finite double is an integer over a power of two, so one common power makes all coordinates integers.
struct Lattice {
  std::vector<Integers> points;  ///< times 2^-bits
  mp_bitcnt_t bits = 0;
};

Lattice lattice(const std::vector<Vec3>& vertices) {
  Lattice result;
  for (const Vec3& v : vertices) {
    for (const mpq_class& x : triple(v)) {
      result.bits = std::max(result.bits, static_cast<mp_bitcnt_t>(mpz_sizeinbase(x.get_den_mpz_t(), 2) - 1));
    }
  }
  for (const Vec3& v : vertices) {
    Integers& point = result.points.emplace_back();
    const Triple p = triple(v);
    for (std::size_t i = 0; i < 3; ++i) {
      const mpq_class shifted = p[i] << result.bits;
      point[i] = shifted.get_num();
    }
  }
  return result;
}

/// Signed tetrahedra (0, a, b, c) over the triangles of each face, with D = det(a, b, c) and s = a + b + c:
/// V = D/6, ∫ x dV = D s/24, ∫ x xᵀ dV = D (s sᵀ + a aᵀ + b bᵀ + c cᵀ)/120. Summed in integers and divided once.
SolidMoments moments(const Polytope& polytope) {
  const auto [vertices, bits] = lattice(polytope.vertices);
  mpz_class volume;
  Integers first;
  std::array<Integers, 3> second;
  for (const std::vector<int>& face : polytope.faces) {
    const Integers& a = vertices[static_cast<std::size_t>(face[0])];
    for (std::size_t k = 2; k < face.size(); ++k) {
      const Integers& b = vertices[static_cast<std::size_t>(face[k - 1])];
      const Integers& c = vertices[static_cast<std::size_t>(face[k])];
      const mpz_class D =
          a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
      const Integers s = {mpz_class(a[0] + b[0] + c[0]), mpz_class(a[1] + b[1] + c[1]), mpz_class(a[2] + b[2] + c[2])};
      volume += D;
      for (std::size_t i = 0; i < 3; ++i) {
        first[i] += D * s[i];
        for (std::size_t j = i; j < 3; ++j) second[i][j] += D * (s[i] * s[j] + a[i] * a[j] + b[i] * b[j] + c[i] * c[j]);
      }
    }
  }
  SolidMoments result;
  Moments& sum = result.rational;
  sum.volume = mpq_class(mpq_class(volume) >> 3 * bits) / 6;
  for (std::size_t i = 0; i < 3; ++i) {
    sum.first[i] = mpq_class(mpq_class(first[i]) >> 4 * bits) / 24;
    for (std::size_t j = i; j < 3; ++j) {
      sum.second[i][j] = mpq_class(mpq_class(second[i][j]) >> 5 * bits) / 120;
      sum.second[j][i] = sum.second[i][j];
    }
  }
  return result;
}

SolidMoments moments(const Compound& compound) {
  SolidMoments sum;
  for (const Part& part : compound.parts) {
    const SolidMoments own = std::visit([](const auto& shape) { return moments(shape); }, part.shape);
    const Motion X_BP = motion(part.X_BP);
    add(sum.rational, moved(own.rational, X_BP));
    add(sum.pi, moved(own.pi, X_BP));
  }
  return sum;
}

/// A closed interval of rationals: not a point, but thin, as π is not rational.
struct Range {
  mpq_class lo;
  mpq_class hi;
};

Range operator+(const Range& a, const Range& b) { return {a.lo + b.lo, a.hi + b.hi}; }
Range operator-(const Range& a) { return {-a.hi, -a.lo}; }
Range operator-(const Range& a, const Range& b) { return a + -b; }
Range operator*(const Range& a, const Range& b) {
  if (a.lo == a.hi && b.lo == b.hi) return {a.lo * b.lo, a.lo * b.lo};
  const auto [lo, hi] =
      std::minmax({mpq_class(a.lo * b.lo), mpq_class(a.lo * b.hi), mpq_class(a.hi * b.lo), mpq_class(a.hi * b.hi)});
  return {lo, hi};
}
/// Requires b > 0.
Range operator/(const Range& a, const Range& b) { return a * Range{1 / b.hi, 1 / b.lo}; }

Interval enclosure(const Range& range) {
  return {rational_of(range.lo).enclosure().lo, rational_of(range.hi).enclosure().hi};
}

/// π between two neighbouring 320-bit numbers: far thinner than a double's ulp even after the few operations here.
const Range& pi() {
  static const Range value = [] {
    mpfr_t bound;
    mpfr_init2(bound, 320);
    Range range;
    mpfr_const_pi(bound, MPFR_RNDD);
    mpfr_get_q(range.lo.get_mpq_t(), bound);
    mpfr_const_pi(bound, MPFR_RNDU);
    mpfr_get_q(range.hi.get_mpq_t(), bound);
    mpfr_clear(bound);
    return range;
  }();
  return value;
}

Range range_of(const mpq_class& rational, const mpq_class& pi_multiple) {
  const Range exact = {rational, rational};
  return sgn(pi_multiple) == 0 ? exact : exact + Range{pi_multiple, pi_multiple} * pi();
}

constexpr std::array<std::pair<std::size_t, std::size_t>, 6> entries = {
    {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};

/// Entry (i, j) of (tr C) 1 − C.
template <class Number, class Entry>
Number inertia_entry(std::pair<std::size_t, std::size_t> ij, const Entry& C) {
  const auto [i, j] = ij;
  if (i != j) return Number(-C(i, j));
  return Number(C((i + 1) % 3, (i + 1) % 3) + C((i + 2) % 3, (i + 2) % 3));
}

/// Centroid, and inertia about it for density 1, as intervals of rationals.
struct Solid {
  Range volume;
  std::array<Range, 3> centroid;
  std::array<Range, 6> inertia;
};

Solid solid_of(const SolidMoments& m) {
  Solid result;
  result.volume = range_of(m.rational.volume, m.pi.volume);
  std::array<Range, 3> first;
  for (std::size_t i = 0; i < 3; ++i) {
    first[i] = range_of(m.rational.first[i], m.pi.first[i]);
    result.centroid[i] = first[i] / result.volume;
  }
  const auto central = [&](std::size_t i, std::size_t j) {
    return range_of(m.rational.second[i][j], m.pi.second[i][j]) - first[i] * result.centroid[j];
  };
  for (std::size_t k = 0; k < 6; ++k) result.inertia[k] = inertia_entry<Range>(entries[k], central);
  return result;
}

SolidTruth::Value value_of(const mpq_class& rational, const mpq_class& pi_multiple) {
  return {rational_of(rational), rational_of(pi_multiple), enclosure(range_of(rational, pi_multiple))};
}

SolidMoments moments_of(const Shape& shape) {
  return std::visit([](const auto& s) { return moments(s); }, shape);
}

Interval point(double value) { return {value, value}; }

MassTruth given(const MassProperties& properties) {
  MassTruth truth;
  truth.mass = point(properties.mass);
  for (std::size_t i = 0; i < 3; ++i) truth.p_BBcm[i] = point(properties.p_BBcm[static_cast<Eigen::Index>(i)]);
  for (std::size_t k = 0; k < 6; ++k) {
    const auto [i, j] = entries[k];
    truth.I_BBcm_B[k] = point(properties.I_BBcm_B(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
  }
  return truth;
}

MassTruth from_density(const Shape& shape, double density) {
  const Solid solid = solid_of(moments_of(shape));
  const Range rho = {mpq_class(density), mpq_class(density)};
  MassTruth truth;
  truth.mass = enclosure(rho * solid.volume);
  for (std::size_t i = 0; i < 3; ++i) truth.p_BBcm[i] = enclosure(solid.centroid[i]);
  for (std::size_t k = 0; k < 6; ++k) truth.I_BBcm_B[k] = enclosure(rho * solid.inertia[k]);
  return truth;
}

}  // namespace

SolidTruth solid(const Shape& shape) {
  const SolidMoments m = moments_of(shape);
  const Solid central = solid_of(m);
  SolidTruth truth;
  truth.volume = value_of(m.rational.volume, m.pi.volume);
  for (std::size_t i = 0; i < 3; ++i) {
    truth.first_moments[i] = value_of(m.rational.first[i], m.pi.first[i]);
    truth.centroid[i] = enclosure(central.centroid[i]);
  }
  for (std::size_t k = 0; k < 6; ++k) {
    const auto entry = [&](const Moments& part) {
      return inertia_entry<mpq_class>(
          entries[k], [&](std::size_t i, std::size_t j) -> const mpq_class& { return part.second[i][j]; });
    };
    truth.second_moments[k] = value_of(entry(m.rational), entry(m.pi));
    truth.inertia[k] = enclosure(central.inertia[k]);
  }
  return truth;
}

std::vector<std::optional<MassTruth>> mass(const Scene& scene) {
  std::vector<std::optional<MassTruth>> truths;
  for (const Body& body : scene.bodies) {
    if (const auto* properties = std::get_if<MassProperties>(&body.mass)) {
      truths.emplace_back(given(*properties));
    } else if (const auto* density = std::get_if<Density>(&body.mass)) {
      truths.emplace_back(from_density(body.shape, density->value));
    } else {
      truths.emplace_back(std::nullopt);
    }
  }
  return truths;
}

MassProperties nearest(const MassTruth& truth) {
  const auto& [xx, yy, zz, xy, xz, yz] = truth.I_BBcm_B;
  MassProperties m;
  m.mass = truth.mass.middle();
  m.p_BBcm = {truth.p_BBcm[0].middle(), truth.p_BBcm[1].middle(), truth.p_BBcm[2].middle()};
  m.I_BBcm_B << xx.middle(), xy.middle(), xz.middle(),  //
      xy.middle(), yy.middle(), yz.middle(),            //
      xz.middle(), yz.middle(), zz.middle();
  return m;
}

}  // namespace touchstone::reference
