#include "fast/simulation/parabola.h"

#include "fast/simulation/length.h"

namespace touchstone::fast::world {
namespace {

/// Of b²: from here on b² − 2ac has lost no more than 12 of its 53 bits, and the time no more than 6.
constexpr double well_conditioned = 0x1p-12;

/// ab − cd to 1.5u of itself, though it be far less than its terms. Source: Jeannerod, Louvet, Muller 2013, on Kahan's
/// algorithm.
double difference_of_products(double a, double b, double c, double d) {
  const double cd = c * d;
  return std::fma(a, b, -cd) + std::fma(-c, d, cd);
}

Vec3 cross_product(const Vec3& s, const Vec3& v) {
  return {difference_of_products(s.y(), v.z(), s.z(), v.y()), difference_of_products(s.z(), v.x(), s.x(), v.z()),
          difference_of_products(s.x(), v.y(), s.y(), v.x())};
}

}  // namespace

/// With a = v², b = s·v and c = (s² − reach²)/2 the discriminant is b² − 2ac = v² reach² − |s × v|². The form on the
/// left loses reach where s² is 2^53 times its square; that on the right loses nothing but where the two graze. The
/// left one, which is cheaper, does while it is not small against b².
double sphere_closes(const Vec3& s, const Vec3& v, double reach) {
  const double far = length(s), b = s.dot(v), a = v.dot(v);
  if (a < 0x1p-500) return 0x1p500 * sphere_closes(s, 0x1p500 * v, reach);
  const double c = (far - reach) * (far + reach) / 2;
  double discriminant = b * b - 2 * a * c;
  if (std::abs(discriminant) < well_conditioned * (b * b)) {
    const double speed = std::sqrt(a), passing = length(cross_product(s, v)) / speed;
    discriminant = a * ((reach - passing) * (reach + passing));
  }
  return closes(c, b, a, discriminant);
}

}  // namespace touchstone::fast::world
