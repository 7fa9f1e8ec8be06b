#include "reference/exact_pose.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "model/box_vertices.h"
#include "model/infinity.h"
#include "reference/exact/exact_pose.h"
#include "reference/exact/rational.h"

namespace touchstone::reference {
namespace {

constexpr long no_exponent = std::numeric_limits<long>::max();

/// |x| = mantissa · 2^exponent, as stored in the double.
struct Binary {
  std::uint64_t mantissa;
  long exponent;
};

Binary binary(double x) {
  const auto stored = std::bit_cast<std::uint64_t>(x);
  const std::uint64_t fraction_bits = stored & ((std::uint64_t{1} << 52U) - 1);
  const auto field = static_cast<long>(stored >> 52U & 0x7ffU);
  if (field == 0) return {fraction_bits, -1074};
  return {fraction_bits | std::uint64_t{1} << 52U, field - 1075};
}

/// The exponent of the lowest bit of x: x is an odd integer times 2^that.
long lowest_bit(double x) {
  if (x == 0) return no_exponent;
  const Binary b = binary(x);
  return b.exponent + std::countr_zero(b.mantissa);
}

long lowest_bit(const Vec3& v) { return std::min({lowest_bit(v.x()), lowest_bit(v.y()), lowest_bit(v.z())}); }

/// x / 2^unit. Requires a unit not above x's lowest bit.
Integer in_units(double x, long unit) {
  if (x == 0) return 0;
  const Binary b = binary(x);
  Integer value = b.mantissa;
  const long shift = b.exponent - unit;
  if (shift >= 0) {
    value <<= static_cast<mp_bitcnt_t>(shift);
  } else {
    value >>= static_cast<mp_bitcnt_t>(-shift);  // shifts out only zeros
  }
  return x < 0 ? Integer(-value) : value;
}

IntegerVec in_units(const Vec3& v, long unit) {
  return {in_units(v.x(), unit), in_units(v.y(), unit), in_units(v.z(), unit)};
}

/// M(q) and |q|², with q scaled by a power of two to integers.
struct Rotation {
  std::array<Integer, 9> matrix;
  Integer norm_squared;
};

Rotation rotation(const Quaternion& q) {
  const long unit = std::min({lowest_bit(q.w), lowest_bit(q.x), lowest_bit(q.y), lowest_bit(q.z)});
  const Integer w = in_units(q.w, unit);
  const Integer x = in_units(q.x, unit);
  const Integer y = in_units(q.y, unit);
  const Integer z = in_units(q.z, unit);
  return {{w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y),  //
           2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x),  //
           2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z},
          w * w + x * x + y * y + z * z};
}

IntegerVec operator*(const std::array<Integer, 9>& m, const IntegerVec& v) {
  return {Integer(m[0] * v.x + m[1] * v.y + m[2] * v.z), Integer(m[3] * v.x + m[4] * v.y + m[5] * v.z),
          Integer(m[6] * v.x + m[7] * v.y + m[8] * v.z)};
}

std::array<Integer, 9> operator*(const std::array<Integer, 9>& a, const std::array<Integer, 9>& b) {
  std::array<Integer, 9> product;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      product[3 * i + j] = a[3 * i] * b[j] + a[3 * i + 1] * b[3 + j] + a[3 * i + 2] * b[6 + j];
    }
  }
  return product;
}

double greatest(const Vec3& v) { return v.cwiseAbs().maxCoeff(); }

/// The top 53 bits of v, truncated: v ≈ mantissa · 2^exponent.
std::pair<double, long> leading(const Integer& v) {
  long exponent = 0;
  const double mantissa = mpz_get_d_2exp(&exponent, v.get_mpz_t());
  return {mantissa, exponent};
}

bool fits_a_double(const Integer& v) {
  return v == 0 || mpz_sizeinbase(v.get_mpz_t(), 2) - mpz_scan1(v.get_mpz_t(), 0) <= 53;
}

/// An enclosure of v · 2^-exponent. Requires |v| < 2^exponent.
Enclosure enclosure_below(const Integer& v, long exponent) {
  const auto [mantissa, own] = leading(v);
  constexpr double tiny = 0x1p-1000;
  if (own - exponent < -1000) return v > 0 ? Enclosure(0, tiny) : v < 0 ? Enclosure(-tiny, 0) : Enclosure(0);
  const double scale = std::ldexp(1.0, static_cast<int>(own - exponent));
  if (fits_a_double(v)) return Enclosure(mantissa * scale);
  const double away = std::nextafter(mantissa, mantissa * 2);
  return mantissa > 0 ? Enclosure(mantissa * scale, away * scale) : Enclosure(away * scale, mantissa * scale);
}

long bits(const Integer& v) { return v == 0 ? 0 : static_cast<long>(mpz_sizeinbase(v.get_mpz_t(), 2)); }

double plain_ratio(const Integer& num, const Integer& den, long shift) {
  const auto [n, n_exponent] = leading(num);
  const auto [d, d_exponent] = leading(den);
  return std::ldexp(n / d, static_cast<int>(std::clamp(n_exponent - d_exponent + shift, -5000L, 5000L)));
}

/// Scaling by a power of two is exact unless the result is below the normal range.
Enclosure enclosure_of_scaled(double scaled, double original) {
  const double least = std::numeric_limits<double>::min();
  if (original == 0 || std::abs(scaled) >= least) return Enclosure(scaled);
  return Enclosure(-least, least);
}

using Faces = std::vector<std::vector<int>>;

Core core(const Sphere& sphere) {
  static const Faces none;
  return {{Vec3::Zero()}, &none, sphere.radius};
}

Core core(const Box& box) {
  static const Faces six = as_polytope(box).faces;
  return {vertices_of(box), &six, 0};
}

Core core(const Polytope& polytope) { return {polytope.vertices, &polytope.faces, 0}; }

}  // namespace

Pose part_pose(const Body& body, int part) {
  const auto* compound = std::get_if<Compound>(&body.shape);
  return compound ? compound->parts.at(static_cast<std::size_t>(part)).X_BP : Pose{};
}

Core core_of(const Body& body, int part) {
  const auto convex = [](const auto& shape) { return core(shape); };
  if (const auto* compound = std::get_if<Compound>(&body.shape)) {
    return std::visit(convex, compound->parts.at(static_cast<std::size_t>(part)).shape);
  }
  if (const auto* sphere = std::get_if<Sphere>(&body.shape)) return core(*sphere);
  if (const auto* box = std::get_if<Box>(&body.shape)) return core(*box);
  return core(std::get<Polytope>(body.shape));
}

RationalVec3 in_world(const Pose& X_WB, const Vec3& p_BA) {
  Body body;
  body.shape = Polytope{{p_BA}, {}};
  body.X_WB = X_WB;
  const PosedPair posed(body, 0, body, 0);
  return posed.point(posed.A.exact(0), 1);
}

Enclosure enclosure(const Integer& num, const Integer& den, long shift) {
  if (num == 0) return Enclosure(0);
  const long num_bits = bits(num);
  const long den_bits = bits(den);
  const Enclosure ratio = enclosure_below(num, num_bits) / enclosure_below(den, den_bits);
  const long exponent = num_bits - den_bits + shift;
  constexpr double huge = infinity;
  if (exponent > 1000) return Enclosure(-huge, huge);
  if (exponent < -1000) return Enclosure(-0x1p-990, 0x1p-990);
  return ratio * Enclosure(std::ldexp(1.0, static_cast<int>(exponent)));
}

EnclosureVec enclosure(const IntegerVec& v) {
  const long exponent = std::max({bits(v.x), bits(v.y), bits(v.z)});
  return {enclosure_below(v.x, exponent), enclosure_below(v.y, exponent), enclosure_below(v.z, exponent)};
}

const IntegerVec& PosedCore::exact(int vertex) const {
  const auto i = static_cast<std::size_t>(vertex);
  if (!known_[i]) {
    exact_[i] = linear_ * in_units(core_.vertices[i], unit_) + offset_;
    known_[i] = true;
  }
  return exact_[i];
}

void PosedCore::enclose() {
  if (!enclosed_.empty()) return;
  std::array<Enclosure, 9> m;
  for (std::size_t i = 0; i < 9; ++i) m[i] = enclosure(linear_[i], denominator_, 0);
  const long shift = unit_ - scale_;
  const EnclosureVec t = {enclosure(offset_.x, denominator_, shift), enclosure(offset_.y, denominator_, shift),
                          enclosure(offset_.z, denominator_, shift)};
  enclosed_.reserve(scaled_.size());
  for (std::size_t i = 0; i < scaled_.size(); ++i) {
    const PlainVec& p = scaled_[i];
    const Vec3& original = core_.vertices[i];
    const EnclosureVec v = {enclosure_of_scaled(p.x, original.x()), enclosure_of_scaled(p.y, original.y()),
                            enclosure_of_scaled(p.z, original.z())};
    enclosed_.push_back({m[0] * v.x + m[1] * v.y + m[2] * v.z + t.x, m[3] * v.x + m[4] * v.y + m[5] * v.z + t.y,
                         m[6] * v.x + m[7] * v.y + m[8] * v.z + t.z});
  }
}

PosedPair::PosedPair(const Body& body_A, int part_A, const Body& body_B, int part_B, const Vec3& shift_A) {
  const Vec3& origin = body_B.X_WB.p_WB;
  struct Source {
    PosedCore& posed;
    const Body& body;
    Pose X_BP;
  };
  std::array<Source, 2> sources = {{{A, body_A, part_pose(body_A, part_A)}, {B, body_B, part_pose(body_B, part_B)}}};
  A.core_ = core_of(body_A, part_A);
  B.core_ = core_of(body_B, part_B);

  long unit = std::min(lowest_bit(shift_A), lowest_bit(origin));
  double size = greatest(body_A.X_WB.p_WB + shift_A - origin);
  for (const Source& s : sources) {
    unit = std::min({unit, lowest_bit(s.body.X_WB.p_WB), lowest_bit(s.X_BP.p_WB)});
    size = std::max(size, greatest(s.X_BP.p_WB));
    for (const Vec3& v : s.posed.core_.vertices) {
      unit = std::min(unit, lowest_bit(v));
      size = std::max(size, greatest(v));
    }
  }
  if (unit == no_exponent) unit = 0;
  const long scale = size > 0 ? std::ilogb(std::min(size, std::numeric_limits<double>::max())) + 1 : 0;

  origin_ = in_units(origin, unit);
  const std::array<IntegerVec, 2> moves = {in_units(body_A.X_WB.p_WB, unit) - origin_ + in_units(shift_A, unit),
                                           IntegerVec{0, 0, 0}};
  for (std::size_t k = 0; k < 2; ++k) {
    const auto& [posed, body, X_BP] = sources[k];
    const Rotation outer = rotation(body.X_WB.q_WB);
    const Rotation inner = rotation(X_BP.q_WB);
    posed.unit_ = unit;
    posed.scale_ = scale;
    posed.denominator_ = outer.norm_squared * inner.norm_squared;
    posed.linear_ = outer.matrix * inner.matrix;
    posed.offset_ = outer.matrix * (inner.norm_squared * in_units(X_BP.p_WB, unit)) + posed.denominator_ * moves[k];
  }
  denominator_ = lcm(A.denominator_, B.denominator_);
  exponent_ = unit;
  for (PosedCore* posed : {&A, &B}) {
    const Integer factor = denominator_ / posed->denominator_;
    if (factor != 1) {
      for (Integer& m : posed->linear_) m *= factor;
      posed->offset_ = factor * posed->offset_;
    }
    posed->denominator_ = denominator_;
    posed->exact_.resize(posed->core_.vertices.size());
    posed->known_.resize(posed->core_.vertices.size());

    std::array<double, 9> m;
    for (std::size_t i = 0; i < 9; ++i) m[i] = plain_ratio(posed->linear_[i], denominator_, 0);
    const PlainVec t = {plain_ratio(posed->offset_.x, denominator_, unit - scale),
                        plain_ratio(posed->offset_.y, denominator_, unit - scale),
                        plain_ratio(posed->offset_.z, denominator_, unit - scale)};
    const double half_scale = std::ldexp(1.0, static_cast<int>(-scale / 2));
    const double other_half = std::ldexp(1.0, static_cast<int>(-scale - -scale / 2));
    const auto shrink = [&](double x) { return x * half_scale * other_half; };
    posed->scaled_.reserve(posed->core_.vertices.size());
    posed->plain_.reserve(posed->core_.vertices.size());
    for (const Vec3& vertex : posed->core_.vertices) {
      const PlainVec v = {shrink(vertex.x()), shrink(vertex.y()), shrink(vertex.z())};
      posed->scaled_.push_back(v);
      posed->plain_.push_back({m[0] * v.x + m[1] * v.y + m[2] * v.z + t.x, m[3] * v.x + m[4] * v.y + m[5] * v.z + t.y,
                               m[6] * v.x + m[7] * v.y + m[8] * v.z + t.z});
    }
  }
}

PlainVec plain(const IntegerVec& v) {
  const long exponent = std::max({bits(v.x), bits(v.y), bits(v.z)});
  const auto shrink = [&](const Integer& x) {
    const auto [mantissa, own] = leading(x);
    return std::ldexp(mantissa, static_cast<int>(std::max(own - exponent, -5000L)));
  };
  return {shrink(v.x), shrink(v.y), shrink(v.z)};
}

int side(const PosedCore& core, const IntegerVec& n, const EnclosureVec& around, int vertex, int from) {
  if (vertex == from) return 0;
  const Enclosure height = dot(around, core.enclosed(vertex) - core.enclosed(from));
  if (height.inf() > 0) return 1;
  if (height.sup() < 0) return -1;
  return sgn(dot(n, core.exact(vertex) - core.exact(from)));
}

mpq_class unreduced(const Integer& num, const Integer& den, long shift) {
  mpq_class value(num, den);
  if (shift >= 0) {
    value.get_num() <<= static_cast<mp_bitcnt_t>(shift);
  } else {
    value.get_den() <<= static_cast<mp_bitcnt_t>(-shift);
  }
  return value;
}

mpq_class fraction(const Integer& num, const Integer& den, long shift) {
  mpq_class value = unreduced(num, den, shift);
  value.canonicalize();
  return value;
}

Rational rational(mpq_class value) {
  return Rational(std::make_unique<Rational::Impl>(Rational::Impl{std::move(value)}));
}

Rational rational(const Integer& value) { return rational(mpq_class(value)); }

Rational PosedPair::length(const Integer& num, const Integer& den) const {
  return rational(fraction(num, Integer(den * denominator_), exponent_));
}

Rational PosedPair::square(const Integer& num, const Integer& den) const {
  return rational(fraction(num, Integer(den * denominator_ * denominator_), 2 * exponent_));
}

RationalVec3 PosedPair::point(const IntegerVec& num, const Integer& den) const {
  const IntegerVec sum = num + Integer(den * denominator_) * origin_;
  return {length(sum.x, den), length(sum.y, den), length(sum.z, den)};
}

Vec3 PosedPair::nearest_point(const IntegerVec& num, const Integer& den) const {
  const Integer all = den * denominator_;
  const IntegerVec sum = num + all * origin_;
  const auto nearest_of = [&](const Integer& x) { return nearest(unreduced(x, all, exponent_)); };
  return {nearest_of(sum.x), nearest_of(sum.y), nearest_of(sum.z)};
}

}  // namespace touchstone::reference
