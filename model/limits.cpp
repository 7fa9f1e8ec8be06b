#include "model/limits.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numeric>
#include <set>

#include "model/infinity.h"
#include "model/input_error.h"

namespace touchstone {
namespace {

/// A place in the scene, such as "bodies[0].shape". It is written only for a message: nearly all scenes are valid. It
/// refers to the place that it is in, which must outlive it.
class Place {
 public:
  Place(const std::string& text) : member_(text.c_str()) {}  // NOLINT: a text is a place
  Place(const char* text) : member_(text) {}                 // NOLINT
  Place(const Place& in, const char* member) : in_(&in), member_(member) {}
  Place(const Place& in, std::size_t index) : in_(&in), index_(index) {}

  std::string text() const {
    const std::string before = in_ == nullptr ? std::string() : in_->text();
    return before + (member_ != nullptr ? member_ : '[' + std::to_string(index_) + ']');
  }
  operator std::string() const { return text(); }  // NOLINT: as errors take it

 private:
  const Place* in_ = nullptr;
  const char* member_ = nullptr;
  std::size_t index_ = 0;
};

Place operator+(const Place& in, const char* member) { return {in, member}; }
Place item(const Place& in, std::size_t index) { return {in, index}; }

/// The shortest decimal that reads back as this double.
std::string found(double number) {
  std::array<char, 32> digits{};
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), number);
  return ", found " + std::string(digits.data(), end);
}

void finite(double number, const Place& place) {
  if (std::isnan(number)) throw InputError(place, "NaN; expected a finite number");
  if (std::isinf(number)) throw InputError(place, "infinite; expected a finite number");
}

void finite(const Vec3& v, const Place& place) {
  for (int i = 0; i < 3; ++i) finite(v[i], item(place, static_cast<std::size_t>(i)));
}

void positive(double number, const Place& place) {
  finite(number, place);
  if (!(number > 0)) throw InputError(place, "expected a number above 0" + found(number));
}

void not_negative(double number, const Place& place) {
  if (number < 0) throw InputError(place, "expected a number that is not negative" + found(number));
}

void validate(const Pose& X, const Place& place) {
  finite(X.p_WB, place + ".p");
  const Quaternion& q = X.q_WB;
  finite(q.w, place + ".q.w");
  finite(q.x, place + ".q.x");
  finite(q.y, place + ".q.y");
  finite(q.z, place + ".q.z");
  if (q.w == 0 && q.x == 0 && q.y == 0 && q.z == 0) {
    throw InputError(place + ".q", "zero; expected a quaternion with a non-zero component");
  }
}

void validate(const Sphere& sphere, const Place& place) { positive(sphere.radius, place + ".radius"); }

void validate(const Box& box, const Place& place) {
  for (int i = 0; i < 3; ++i) positive(box.half_extents[i], item(place + ".half_extents", static_cast<std::size_t>(i)));
}

void all_different(const std::vector<Vec3>& vertices, const Place& place) {
  std::vector<std::size_t> order(vertices.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, [&](std::size_t i, std::size_t j) {
    const Vec3& a = vertices[i];
    const Vec3& b = vertices[j];
    if (a == b) return i < j;
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  });
  std::size_t first = vertices.size();  // the first vertex that is equal to an earlier one
  std::size_t same = 0;
  for (std::size_t k = 1; k < order.size(); ++k) {
    if (vertices[order[k - 1]] != vertices[order[k]] || order[k] >= first) continue;
    first = order[k];
    same = order[k - 1];
  }
  if (first == vertices.size()) return;
  throw InputError(item(place, first), "equal to vertex " + std::to_string(same) + "; expected each once");
}

void validate_face(const std::vector<int>& face, std::size_t vertex_count, const Place& place) {
  if (face.size() < 3) throw InputError(place, "expected at least 3 vertices, found " + std::to_string(face.size()));
  for (std::size_t i = 0; i < face.size(); ++i) {
    const int vertex = face[i];
    if (vertex < 0 || static_cast<std::size_t>(vertex) >= vertex_count) {
      throw InputError(item(place, i), "vertex " + std::to_string(vertex) + " does not exist; expected 0 to " +
                                           std::to_string(vertex_count - 1));
    }
    if (std::find(face.begin(), face.begin() + static_cast<std::ptrdiff_t>(i), vertex) !=
        face.begin() + static_cast<std::ptrdiff_t>(i)) {
      throw InputError(item(place, i), "vertex " + std::to_string(vertex) + " stands twice in the face; expected once");
    }
  }
}

void validate(const Polytope& polytope, const Place& place) {
  const std::vector<Vec3>& vertices = polytope.vertices;
  if (vertices.size() < 4) {
    throw InputError(place + ".vertices", "expected at least 4 vertices, found " + std::to_string(vertices.size()));
  }
  for (std::size_t i = 0; i < vertices.size(); ++i) finite(vertices[i], item(place + ".vertices", i));
  all_different(vertices, place + ".vertices");
  for (std::size_t i = 0; i < polytope.faces.size(); ++i) {
    validate_face(polytope.faces[i], vertices.size(), item(place + ".faces", i));
  }
}

void validate(const Compound& compound, const Place& place) {
  if (compound.parts.empty()) throw InputError(place + ".parts", "expected at least one part");
  for (std::size_t i = 0; i < compound.parts.size(); ++i) {
    const Part& part = compound.parts[i];
    const std::string part_place = item(place + ".parts", i);
    validate(part.X_BP, part_place + ".X_BP");
    std::visit([&](const auto& shape) { validate(shape, part_place + ".shape"); }, part.shape);
  }
}

/// The principal moments of a solid are positive, and none exceeds the sum of the other two (each is a sum of two of
/// the three second moments of mass, and those are ≥ 0).
///
/// The computed moments of a symmetric I scaled to max |I_ij| = 1 are those of I + E with ‖E‖ ≤ c·2⁻⁵³·‖I‖, ‖I‖ ≤ 3,
/// where c is a modest constant for 3×3 (Golub & Van Loan 2013, 8.1: Weyl's inequality). An inertia that was itself
/// rounded may violate the inequality by as much (a thin plate), so only a violation beyond 2⁻⁴⁶ is certainly an error.
void validate_inertia(const Mat3& I, const Place& place) {
  for (int i = 0; i < 3; ++i) finite(Vec3(I.row(i)), item(place, static_cast<std::size_t>(i)));
  if (I != I.transpose()) throw InputError(place, "not symmetric; expected I[i][j] = I[j][i]");
  const double scale = I.cwiseAbs().maxCoeff();
  if (scale == 0) throw InputError(place, "zero; expected a positive definite matrix");
  const Mat3 scaled = I / scale;
  const Vec3 moments = Eigen::SelfAdjointEigenSolver<Mat3>(scaled, Eigen::EigenvaluesOnly).eigenvalues();
  if (!(moments[0] > 0)) throw InputError(place, "expected a positive definite matrix");
  if (moments[2] - moments[1] - moments[0] > std::ldexp(1.0, -46)) {
    throw InputError(place, "no solid has it: the greatest principal moment exceeds the sum of the other two");
  }
}

void validate(const Density& density, const Place& place) { positive(density.value, place + ".density"); }
void validate(const Fixed&, const Place&) {}

void validate(const MassProperties& given, const Place& place) {
  positive(given.mass, place + ".mass");
  finite(given.p_BBcm, place + ".p_BBcm");
  validate_inertia(given.I_BBcm_B, place + ".I_BBcm_B");
}

void validate_restitution(double e, const Place& place) {
  finite(e, place);
  if (e < 0 || e > 1) throw InputError(place, "expected a number from 0 to 1" + found(e));
}

void validate(const Material& material, const Place& place) {
  validate_restitution(material.restitution, place + ".restitution");
  finite(material.friction, place + ".friction");
  not_negative(material.friction, place + ".friction");
}

void validate(const Body& body, const Place& place) {
  std::visit([&](const auto& shape) { validate(shape, place + ".shape"); }, body.shape);
  validate(body.X_WB, place + ".X_WB");
  finite(body.velocity.v_WBcm, place + ".velocity.v_WBcm");
  finite(body.velocity.w_WB, place + ".velocity.w_WB");
  validate(body.material, place + ".material");
  std::visit([&](const auto& mass) { validate(mass, place + ".mass"); }, body.mass);
}

/// `there` says for each body whether it is present; it is kept from frame to frame.
void validate(const SequenceFrame& frame, std::vector<bool>& there, const Place& place) {
  std::set<int> seen;
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const auto& [body, X_WB] = frame[i];
    const std::string placement = item(place, i);
    const std::string words = "body " + std::to_string(body);
    if (body < 0 || static_cast<std::size_t>(body) >= there.size()) {
      throw InputError(placement, words + " does not exist; there are " + std::to_string(there.size()));
    }
    if (!seen.insert(body).second) throw InputError(placement, words + " stands twice in the frame; expected once");
    if (X_WB) validate(*X_WB, placement + ".X_WB");
    if (!X_WB && !there[static_cast<std::size_t>(body)]) {
      throw InputError(placement, words + " is not there, so it cannot be taken away");
    }
    there[static_cast<std::size_t>(body)] = X_WB.has_value();
  }
}

/// A normal n/|n| rounded to doubles has | |n|² − 1 | < 2⁻⁵⁰ with room to spare: each of its 3 components has a
/// relative error of at most 2⁻⁵³ after a square root and a division.
void validate_normal(const Vec3& n, const Place& place) {
  finite(n, place);
  if (n == Vec3::Zero()) throw InputError(place, "zero; expected a direction of length 1");
  const double length = n.stableNorm();
  if (std::abs(length - 1) > std::ldexp(1.0, -50)) {
    throw InputError(place, "expected a direction of length 1 within rounding" + found(length));
  }
}

void validate(const Contact& contact, const Scene& scene, const Place& place) {
  if (scene.bodies.size() != 2) {
    throw InputError(place, "expected two bodies, found " + std::to_string(scene.bodies.size()));
  }
  finite(contact.p_WC, place + ".p_WC");
  validate_normal(contact.nhat_BA_W, place + ".nhat_BA_W");
  validate_restitution(contact.restitution, place + ".restitution");
  const double mu = contact.friction;
  if (std::isnan(mu)) throw InputError(place + ".friction", "NaN; expected a number");
  not_negative(mu, place + ".friction");
  if (is_fixed(scene.bodies[0]) && is_fixed(scene.bodies[1])) {
    throw InputError(place, "both bodies are fixed; expected one that an impulse moves");
  }
}

void validate(const Raster& raster, const Place& place) {
  finite(raster.x, place + ".x");
  finite(raster.y, place + ".y");
  positive(raster.pixel, place + ".pixel");
  if (raster.columns < 1) throw InputError(place + ".columns", "expected at least 1" + found(raster.columns));
  if (raster.rows < 1) throw InputError(place + ".rows", "expected at least 1" + found(raster.rows));
  for (const int shift : {raster.shift_x, raster.shift_y}) {
    if (std::abs(static_cast<double>(shift)) > 1e9) throw InputError(place + ".shift", "expected at most 1e9 pixels");
  }
  constexpr int most = 1 << 24;  // pixels; an answer then has about 100 MB
  if (raster.columns > most / raster.rows) {
    throw InputError(place, "expected at most " + std::to_string(most) + " pixels, found " +
                                std::to_string(raster.columns) + " x " + std::to_string(raster.rows));
  }
}

double size_of(const Sphere& sphere) { return sphere.radius; }
double size_of(const Box& box) { return box.half_extents.minCoeff(); }

double size_of(const Polytope& polytope) {
  Vec3 lo = polytope.vertices.at(0), hi = lo;
  for (const Vec3& vertex : polytope.vertices) {
    lo = lo.cwiseMin(vertex);
    hi = hi.cwiseMax(vertex);
  }
  return (hi / 2 - lo / 2).minCoeff();
}

double size_of(const Compound& compound) {
  double least = infinity;
  for (const Part& part : compound.parts) {
    least = std::min(least, std::visit([](const auto& shape) { return size_of(shape); }, part.shape));
  }
  return least;
}

double least_moving_size(const Scene& scene) {
  double least = infinity;
  for (const Body& body : scene.bodies) {
    if (!is_fixed(body)) least = std::min(least, size(body.shape));
  }
  return least;
}

void validate_times(const std::vector<double>& times, const Place& place) {
  if (times.empty()) throw InputError(place, "expected at least one");
  for (std::size_t i = 0; i < times.size(); ++i) {
    positive(times[i], item(place, i));
    if (i > 0 && times[i] <= times[i - 1])
      throw InputError(item(place, i), "expected more than the time before it" + found(times[i]));
  }
}

void validate_start_times(const std::vector<double>& starts, std::size_t bodies, double first, const Place& place) {
  if (starts.empty()) return;
  if (starts.size() != bodies) {
    throw InputError(place, "expected " + std::to_string(bodies) + " items, found " + std::to_string(starts.size()));
  }
  for (std::size_t i = 0; i < starts.size(); ++i) {
    finite(starts[i], item(place, i));
    not_negative(starts[i], item(place, i));
    if (starts[i] > first)
      throw InputError(item(place, i), "expected no more than the motion's first sample time" + found(starts[i]));
  }
}

void validate_forces(const Motion& motion, const std::vector<Body>& bodies, const Place& place) {
  finite(motion.force_bound, place + ".force_bound");
  not_negative(motion.force_bound, place + ".force_bound");
  for (std::size_t i = 0; i < motion.forces.size(); ++i) {
    const AppliedForce& force = motion.forces[i];
    const std::string here = item(place + ".forces", i);
    finite(force.time, here + ".time");
    not_negative(force.time, here + ".time");
    if (i > 0 && force.time < motion.forces[i - 1].time) {
      throw InputError(here + ".time", "expected no less than the time of the force before it" + found(force.time));
    }
    if (force.body < 0 || static_cast<std::size_t>(force.body) >= bodies.size()) {
      throw InputError(here + ".body", "body " + std::to_string(force.body) + " does not exist; there are " +
                                           std::to_string(bodies.size()));
    }
    if (is_fixed(bodies[static_cast<std::size_t>(force.body)])) {
      throw InputError(here + ".body", "a fixed body; no force moves it");
    }
    finite(force.force_W, here + ".force_W");
    if (force.force_W.stableNorm() > motion.force_bound) {
      throw InputError(here + ".force_W",
                       "stronger than the motion's force_bound" + found(force.force_W.stableNorm()) + " N");
    }
  }
}

void validate(const Motion& motion, const Scene& scene, const Place& place) {
  validate_times(motion.sample_times, place + ".sample_times");
  validate_start_times(motion.start_times, scene.bodies.size(), motion.sample_times.front(), place + ".start_times");
  if (motion.envelope) {
    positive(*motion.envelope, place + ".envelope");
    if (!(*motion.envelope < least_moving_size(scene) / 1000)) {
      throw InputError(place + ".envelope",
                       "expected less than a thousandth of the size of each body that moves" + found(*motion.envelope));
    }
  }
  validate_forces(motion, scene.bodies, place);
}

}  // namespace

double size(const Shape& shape) {
  return std::visit([](const auto& kind) { return size_of(kind); }, shape);
}

double envelope(const Scene& scene) {
  if (scene.motion && scene.motion->envelope) return *scene.motion->envelope;
  const double least = least_moving_size(scene);
  return std::isinf(least) ? 0 : std::ldexp(least, -30);
}

void validate(const Scene& scene) {
  finite(scene.gravity, "gravity");
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) validate(scene.bodies[i], item("bodies", i));
  std::vector<bool> there(scene.bodies.size(), false);
  for (std::size_t i = 0; i < scene.frames.size(); ++i) validate(scene.frames[i], there, item("frames", i));
  if (scene.contact) validate(*scene.contact, scene, "contact");
  if (scene.raster) validate(*scene.raster, "raster");
  if (scene.motion) validate(*scene.motion, scene, "motion");
}

}  // namespace touchstone
