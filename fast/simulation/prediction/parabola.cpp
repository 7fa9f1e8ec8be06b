#include "fast/simulation/prediction/parabola.h"

#include "fast/simulation/prediction/length.h"

namespace touchstone::fast::simulation {
namespace {

/// Relative to b²: while |b² − 2ac| is at least this, it has lost at most 12 of its 53 bits, and the time at most 6.
constexpr double well_conditioned = 0x1p-12;

/// ab − cd with a relative error of 1.5u, even if it is far less than its terms. Source: Jeannerod, Louvet, Muller
/// 2013, on Kahan's algorithm.
double difference_of_products(double a, double b, double c, double d) {
  const double cd = c * d;
  return std::fma(a, b, -cd) + std::fma(-c, d, cd);
}

Vec3 cross_product(const Vec3& s, const Vec3& v) {
  return {difference_of_products(s.y(), v.z(), s.z(), v.y()), difference_of_products(s.z(), v.x(), s.x(), v.z()),
          difference_of_products(s.x(), v.y(), s.y(), v.x())};
}

}  // namespace

/// With a = v², b = s·v and c = (s² − reach²)/2 the discriminant is b² − 2ac = v² reach² − |s × v|². The left form
/// loses reach entirely if s² is 2^53 times reach²; the right form loses accuracy only if the point grazes the sphere.
/// The left form is cheaper and is used while it is not small compared with b².
double sphere_closing_time(const Vec3& s, const Vec3& v, double reach) {
  const double far = length(s), b = s.dot(v), a = v.dot(v);
  if (a < 0x1p-500) return 0x1p500 * sphere_closing_time(s, 0x1p500 * v, reach);
  const double c = (far - reach) * (far + reach) / 2;
  double discriminant = b * b - 2 * a * c;
  if (std::abs(discriminant) < well_conditioned * (b * b)) {
    const double speed = std::sqrt(a), passing = length(cross_product(s, v)) / speed;
    discriminant = a * ((reach - passing) * (reach + passing));
  }
  return closing_time(c, b, a, discriminant);
}

}  // namespace touchstone::fast::simulation
