#include "properties/fuzzing/mutate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <variant>

#include "model/input_error.h"
#include "model/sequence.h"
#include "oracle/minimise/scene_edit.h"
#include "oracle/tolerance/tolerance.h"
#include "oracle/truth/truth.h"
#include "properties/fuzzing/complete.h"
#include "properties/fuzzing/invent.h"
#include "properties/fuzzing/usual.h"
#include "properties/scenes/pair.h"
#include "properties/transforms/scene.h"

namespace touchstone::properties::fuzzing {
namespace {

using oracle::Slot;

// Choices: scenes stay as small as those that families draw, so that an execution takes milliseconds.
constexpr int attempts = 8;
constexpr std::size_t most_bodies = 16;
constexpr std::size_t most_frames = 16;
constexpr std::size_t most_vertices = 64;
constexpr long most_pixels = 4096;
constexpr double usual_travel = 64;  ///< sizes of the smallest body

std::size_t some_body(const Scene& scene, Random& random) { return random.index(scene.bodies.size()); }

/// Numbers of one kind, to be copied among each other; some scenes have none of a kind.
std::vector<double*> some_numbers(Scene& scene, Random& random) {
  const int kind = random.below(8);
  if (kind < 4) return oracle::lengths(scene);
  if (kind < 6) return oracle::motion_numbers(scene);
  return kind == 6 ? oracle::quaternion_components(scene) : oracle::mass_numbers(scene);
}

/// Replaces one number by what `change` makes of it.
template <class Change>
Changed with_number(Scene scene, Random& random, Change&& change) {
  const std::vector<double*> numbers = some_numbers(scene, random);
  if (numbers.empty()) return std::nullopt;
  double& number = *random.pick(numbers);
  number = change(number, numbers);
  oracle::drop_faces(scene);
  return scene;
}

Changed copy_number(const Scene& scene, const Scene&, Random& random) {
  return with_number(scene, random, [&](double, const std::vector<double*>& numbers) {
    const double from = *random.pick(numbers);
    return from * random.sign();
  });
}

Changed plain_number(const Scene& scene, const Scene&, Random& random) {
  return with_number(scene, random, [&](double number, const std::vector<double*>&) {
    switch (random.below(4)) {
      case 0:
        return std::nearbyint(number);
      case 1:
        return number == 0 ? 1 : std::copysign(std::exp2(std::ilogb(number)), number);
      case 2:
        return static_cast<double>(static_cast<float>(number));
      default:
        return random.pick({0.0, 1.0, -1.0, 0.5, 2.0});
    }
  });
}

Changed by_ulps(const Scene& scene, const Scene&, Random& random) {
  return with_number(scene, random, [&](double number, const std::vector<double*>&) {
    const double towards = random.sign() * std::numeric_limits<double>::infinity();
    for (int steps = random.between(1, 4); steps > 0; --steps) number = std::nextafter(number, towards);
    return number;
  });
}

Changed by_a_little(const Scene& scene, const Scene&, Random& random) {
  return with_number(scene, random, [&](double number, const std::vector<double*>& numbers) {
    const double of = random.one_in(2) ? number : *random.pick(numbers);
    const double factor = std::exp2(-random.between(0, 50));
    return number + random.sign() * of * factor;
  });
}

/// A coordinate of two positions, or of two vertices of a polytope, becomes equal.
Changed copy_coordinate(Scene scene, const Scene&, Random& random) {
  const std::vector<Slot> all = oracle::slots(scene);
  const Slot slot = random.pick(all);
  ConvexShape shape = oracle::shape_at(scene, slot);
  auto* polytope = std::get_if<Polytope>(&shape);
  const int axis = random.below(3);
  if (polytope != nullptr && random.one_in(2)) {
    const Vec3 from = random.pick(polytope->vertices);
    polytope->vertices[random.index(polytope->vertices.size())][axis] = from[axis];
    polytope->faces.clear();
    oracle::set_shape(scene, slot, shape);
    return scene;
  }
  const std::vector<Pose*> all_poses = poses(scene);
  const double from = random.pick(all_poses)->p_WB[axis];
  random.pick(all_poses)->p_WB[axis] = from;
  return scene;
}

/// One body gets the rotation of another, perhaps after one that maps axes to axes: their faces are parallel then.
Changed align(Scene scene, const Scene&, Random& random) {
  const std::vector<Pose*> all = poses(scene);
  const Quaternion from = random.one_in(4) ? Quaternion{} : random.pick(all)->q_WB;
  const Quaternion about = random.one_in(2) ? Quaternion{} : axes_quaternion(random);
  random.pick(all)->q_WB = times(from, about);
  return scene;
}

/// The core's translation that makes bodies i and j touch: exact, then rounded once. None if they are compounds that
/// overlap.
std::optional<Vec3> way_to_contact(const Body& A, const Body& B) {
  Scene pair;
  pair.bodies = {A, B};
  const reference::DistanceTruth& truth = oracle::truth::distance(pair);
  const Vec3 d(truth.difference.x.nearest(), truth.difference.y.nearest(), truth.difference.z.nearest());
  if (truth.verdict == Verdict::separated) return Vec3(d.stableNormalized() * truth.distance.lo);
  if (truth.verdict == Verdict::touching) return Vec3(Vec3::Zero());
  if (std::holds_alternative<Compound>(A.shape) || std::holds_alternative<Compound>(B.shape)) return std::nullopt;
  const reference::PenetrationTruth& depth = oracle::truth::penetration(pair);
  return Vec3(-depth.nhat_BA_W * depth.depth.hi);
}

/// Moves one body until it touches another. Then perhaps a little further apart or together.
Changed touch(Scene scene, const Scene&, Random& random) {
  if (scene.bodies.size() < 2) return std::nullopt;
  const std::size_t i = some_body(scene, random);
  const std::size_t j = some_body(scene, random);
  if (i == j) return std::nullopt;
  const std::optional<Vec3> way = way_to_contact(scene.bodies[i], scene.bodies[j]);
  if (!way) return std::nullopt;
  Vec3& p_WB = scene.bodies[j].X_WB.p_WB;
  p_WB += *way;
  if (random.one_in(2)) return scene;
  const double size = oracle::tolerance::radius(scene.bodies[j]);
  const double by = random.sign() * size * std::exp2(-random.between(1, 53));
  const int axis = random.below(3);
  p_WB[axis] += by;
  return scene;
}

/// One body becomes as another, or its point reflection, whose faces are parallel too.
Changed copy_shape(Scene scene, const Scene& other, Random& random) {
  const Scene& source = random.one_in(2) ? scene : other;
  if (source.bodies.empty()) return std::nullopt;
  Scene from;
  from.bodies = {source.bodies[some_body(source, random)]};
  if (random.one_in(2)) {
    for (const Slot slot : oracle::slots(from)) {
      ConvexShape shape = oracle::shape_at(from, slot);
      if (auto* polytope = std::get_if<Polytope>(&shape)) {
        for (Vec3& vertex : polytope->vertices) vertex = -vertex;
        polytope->faces.clear();
        oracle::set_shape(from, slot, shape);
      }
    }
  }
  scene.bodies[some_body(scene, random)].shape = from.bodies[0].shape;
  return scene;
}

Changed scale_all(const Scene& scene, const Scene&, Random& random) { return scaled(scene, random.between(-20, 20)); }

/// One solid becomes larger or smaller, or flat or long.
Changed scale_solid(Scene scene, const Scene&, Random& random) {
  const Slot slot = random.pick(oracle::slots(scene));
  const double factor = std::exp2(random.between(-12, 12));
  Vec3 factors = Vec3::Constant(factor);
  if (random.one_in(2)) {
    factors.setOnes();
    factors[random.below(3)] = factor;
  }
  ConvexShape shape = oracle::shape_at(scene, slot);
  if (auto* sphere = std::get_if<Sphere>(&shape)) sphere->radius *= factor;
  if (auto* box = std::get_if<Box>(&shape)) box->half_extents = box->half_extents.cwiseProduct(factors);
  if (auto* polytope = std::get_if<Polytope>(&shape)) {
    for (Vec3& vertex : polytope->vertices) vertex = vertex.cwiseProduct(factors);
    polytope->faces.clear();
  }
  oracle::set_shape(scene, slot, shape);
  return scene;
}

/// The vertices in another order, one less, or one more in the middle of two.
Changed vertices(Scene scene, const Scene&, Random& random) {
  const Slot slot = random.pick(oracle::slots(scene));
  ConvexShape shape = oracle::shape_at(scene, slot);
  auto* polytope = std::get_if<Polytope>(&shape);
  if (polytope == nullptr) return std::nullopt;
  std::vector<Vec3>& all = polytope->vertices;
  const std::size_t i = random.index(all.size());
  const std::size_t j = random.index(all.size());
  switch (random.below(3)) {
    case 0:
      std::swap(all[i], all[j]);
      break;
    case 1:
      all.erase(all.begin() + static_cast<std::ptrdiff_t>(i));
      break;
    default:
      all.push_back((all[i] + all[j]) / 2);
  }
  polytope->faces.clear();
  oracle::set_shape(scene, slot, shape);
  return scene;
}

/// The same question in other words: the bodies or the axes in another order.
Changed renamed(const Scene& scene, const Scene&, Random& random) {
  const int way = random.below(3);
  if (way == 0 && !scene.motion) return swapped(scene);
  return way == 1 ? turned(scene) : Changed(half_turned(scene));
}

/// All bodies, a contact and a raster move along an axis by the same power of two; the numbers round.
Changed far_away(Scene scene, const Scene&, Random& random) {
  const int axis = random.below(3);
  const double by = random.sign() * std::exp2(random.between(-8, 40));
  for (Pose* X_WB : poses(scene)) X_WB->p_WB[axis] += by;
  if (scene.contact) scene.contact->p_WC[axis] += by;
  if (scene.raster && axis == 0) scene.raster->x += by;
  if (scene.raster && axis == 1) scene.raster->y += by;
  return scene;
}

/// A body of this scene or of the other one joins.
Changed add_body(Scene scene, const Scene& other, Random& random) {
  const Scene& source = random.one_in(2) ? scene : other;
  if (source.bodies.empty()) return std::nullopt;
  Body body = source.bodies[some_body(source, random)];
  const int axis = random.below(3);
  body.X_WB.p_WB[axis] += random.sign() * 2 * oracle::tolerance::radius(body);
  if (!scene.frames.empty()) {
    scene.frames[random.index(scene.frames.size())].push_back({static_cast<int>(scene.bodies.size()), body.X_WB});
  }
  if (scene.motion && !scene.motion->start_times.empty()) scene.motion->start_times.push_back(0);
  scene.bodies.push_back(std::move(body));
  return scene;
}

/// The last body leaves, so that no index changes.
Changed remove_body(Scene scene, const Scene&, Random&) {
  if (scene.bodies.size() < 2) return std::nullopt;
  const int last = static_cast<int>(scene.bodies.size()) - 1;
  scene.bodies.pop_back();
  for (SequenceFrame& frame : scene.frames) std::erase_if(frame, [&](const Placement& p) { return p.body == last; });
  if (scene.motion) {
    std::erase_if(scene.motion->forces, [&](const AppliedForce& force) { return force.body == last; });
    if (!scene.motion->start_times.empty()) scene.motion->start_times.pop_back();
  }
  return scene;
}

/// A body of the other scene takes the place of one, with its own pose or at that of the old body.
Changed splice_body(Scene scene, const Scene& other, Random& random) {
  if (other.bodies.empty()) return std::nullopt;
  Body& body = scene.bodies[some_body(scene, random)];
  const Pose X_WB = body.X_WB;
  body = other.bodies[some_body(other, random)];
  if (random.one_in(2)) body.X_WB = X_WB;
  return scene;
}

/// Mass, material and velocity of one body become those of another, or its velocity is reversed or 0.
Changed copy_state(Scene scene, const Scene&, Random& random) {
  const Body from = scene.bodies[some_body(scene, random)];
  Body& body = scene.bodies[some_body(scene, random)];
  switch (random.below(6)) {
    case 0:
      body.mass = from.mass;
      break;
    case 1:
      body.material = from.material;
      break;
    case 2:
      body.velocity = from.velocity;
      break;
    case 3:
      body.velocity.v_WBcm = -from.velocity.v_WBcm;
      break;
    case 4:
      body.velocity.w_WB.setZero();
      break;
    default:
      body.velocity.v_WBcm.setZero();
  }
  return scene;
}

/// The other scene's contact, raster, motion or gravity. A scene gets no part that it had not.
Changed splice_settings(Scene scene, const Scene& other, Random& random) {
  switch (random.below(4)) {
    case 0:
      scene.gravity = other.gravity;
      break;
    case 1:
      if (scene.contact && other.contact) scene.contact = other.contact;
      break;
    case 2:
      if (scene.raster && other.raster) scene.raster = other.raster;
      break;
    default:
      if (scene.motion && other.motion) scene.motion = other.motion;
  }
  return scene;
}

/// Another law of the contact or of the motion; coefficients at an end of their range.
Changed coefficients(Scene scene, const Scene&, Random& random) {
  const Law law = random.pick({Law::poisson, Law::stronge, Law::newton});
  const double e = random.pick({0.0, 0.5, 1.0});
  const double mu = random.pick({0.0, 0.5, 1.0, 10.0});
  if (scene.motion) {
    if (random.one_in(3)) scene.motion->law = law;
    scene.bodies[some_body(scene, random)].material = {e, mu};
    return scene;
  }
  if (!scene.contact) return std::nullopt;
  switch (random.below(3)) {
    case 0:
      scene.contact->law = law;
      break;
    case 1:
      scene.contact->restitution = e;
      break;
    default:
      scene.contact->friction = mu;
  }
  return scene;
}

/// A frame of a sequence is left out, repeated, or changes its place.
Changed frames(Scene scene, const Scene&, Random& random) {
  if (scene.frames.empty()) return std::nullopt;
  const std::size_t f = random.index(scene.frames.size());
  const std::size_t g = random.index(scene.frames.size());
  switch (random.below(3)) {
    case 0:
      if (scene.frames.size() > 1) scene.frames.erase(scene.frames.begin() + static_cast<std::ptrdiff_t>(f));
      break;
    case 1:
      scene.frames.push_back(SequenceFrame(scene.frames[f]));
      break;
    default:
      std::swap(scene.frames[f], scene.frames[g]);
  }
  return scene;
}

struct Mutation {
  const char* name;
  Changed (*make)(const Scene&, const Scene& other, Random&);
  enum class For { all, more_than_pairs, compounds } queries = For::all;
};

using For = Mutation::For;

/// A depth of compounds is not defined, and the time stepper takes none.
bool takes_compounds(const oracle::Query& query) { return query.name != "penetration" && query.name != "constraint"; }

bool suits(const Mutation& mutation, const oracle::Query& query) {
  if (mutation.queries == For::more_than_pairs) return !query.about_two_bodies;
  return mutation.queries != For::compounds || takes_compounds(query);
}

template <Changed (*make)(Scene, const Scene&, Random&)>
Changed of_copy(const Scene& scene, const Scene& other, Random& random) {
  return make(scene, other, random);
}

constexpr Mutation all[] = {
    {"copy_number", copy_number},
    {"plain_number", plain_number},
    {"by_ulps", by_ulps},
    {"by_a_little", by_a_little},
    {"copy_coordinate", of_copy<copy_coordinate>},
    {"align", of_copy<align>},
    {"touch", of_copy<touch>},
    {"copy_shape", of_copy<copy_shape>},
    {"scale_all", scale_all},
    {"scale_solid", of_copy<scale_solid>},
    {"vertices", of_copy<vertices>},
    {"renamed", renamed},
    {"far_away", of_copy<far_away>},
    {"add_body", of_copy<add_body>, For::more_than_pairs},
    {"remove_body", of_copy<remove_body>, For::more_than_pairs},
    {"splice_body", of_copy<splice_body>},
    {"copy_state", of_copy<copy_state>},
    {"splice_settings", of_copy<splice_settings>},
    {"coefficients", of_copy<coefficients>},
    {"frames", of_copy<frames>},
    {"other_solid", of_copy<other_solid>},
    {"join_part", of_copy<join_part>, For::compounds},
    {"drop_part", of_copy<drop_part>},
    {"other_mass", of_copy<other_mass>},
    {"other_normal", of_copy<other_normal>},
    {"other_raster", of_copy<other_raster>},
    {"other_times", of_copy<other_times>},
    {"other_forces", of_copy<other_forces>},
    {"place", of_copy<place>, For::more_than_pairs},
};

std::size_t vertices_of_largest_part(const Scene& scene) {
  std::size_t most = 0;
  for (const Slot slot : oracle::slots(scene)) {
    most = std::max(most, oracle::corners(oracle::shape_at(scene, slot)).size());
  }
  return most;
}

/// How far bodies come and turn until the motion's end, in sizes of the smallest; 0 without a motion.
double travel(const Scene& scene) {
  if (!scene.motion || scene.motion->sample_times.empty()) return 0;
  const double T = scene.motion->sample_times.back();
  double size = std::numeric_limits<double>::infinity();
  double way = 0;
  double turn = 0;
  for (const Body& body : scene.bodies) {
    size = std::min(size, oracle::tolerance::radius(body));
    way = std::max(way, body.velocity.v_WBcm.stableNorm() * T + scene.gravity.stableNorm() * T * T / 2);
    turn = std::max(turn, body.velocity.w_WB.stableNorm() * T);
  }
  return way / size + turn;
}

bool has_parts_of(const Scene& before, const Scene& scene) {
  return scene.contact.has_value() == before.contact.has_value() &&
         scene.raster.has_value() == before.raster.has_value() && scene.motion.has_value() == before.motion.has_value();
}

bool is_ordinary(Scene& scene, const Scene& before) {
  for (const auto& numbers : {oracle::lengths(scene), oracle::quaternion_components(scene), oracle::mass_numbers(scene),
                              oracle::motion_numbers(scene)}) {
    if (!std::ranges::all_of(numbers, [](const double* number) { return is_usual(*number); })) return false;
  }
  const auto no_more = [](auto now, auto earlier, auto usual) { return now <= std::max(earlier, usual); };
  const auto pixels = [](const Scene& s) { return s.raster ? long{s.raster->columns} * s.raster->rows : 0; };
  return no_more(scene.bodies.size(), before.bodies.size(), most_bodies) &&
         no_more(scene.frames.size(), before.frames.size(), most_frames) &&
         no_more(vertices_of_largest_part(scene), vertices_of_largest_part(before), most_vertices) &&
         no_more(pixels(scene), pixels(before), most_pixels) && no_more(travel(scene), travel(before), usual_travel);
}

/// Bodies that overlap where their motion begins are bad input for every engine.
bool begin_apart(const Scene& scene, std::size_t i, std::size_t j) {
  const Body& A = scene.bodies[i];
  const Body& B = scene.bodies[j];
  Scene pair;
  pair.bodies = {A, B};
  const std::vector<double>& starts = scene.motion->start_times;
  if (starts.empty() || starts[i] == starts[j]) {
    return oracle::truth::distance(pair).verdict != Verdict::overlapping;
  }
  pair.gravity = scene.gravity;
  pair.motion = Motion{scene.motion->sample_times, {starts[i], starts[j]}};
  oracle::truth::time_of_impact(pair);  // throws InputError where they overlap
  return true;
}

/// Two fixed bodies may overlap, unless they are what the query is about.
bool begins_apart(const Scene& scene, const oracle::Query& query) {
  const auto may_overlap = [&](std::size_t i, std::size_t j) {
    return is_fixed(scene.bodies[i]) && is_fixed(scene.bodies[j]) && !query.about_two_bodies;
  };
  for (std::size_t j = 0; scene.motion && j < scene.bodies.size(); ++j) {
    for (std::size_t i = 0; i < j; ++i) {
      if (!may_overlap(i, j) && !begin_apart(scene, i, j)) return false;
    }
  }
  return true;
}

/// None if the mutation does not apply, or what it makes is not valid or not ordinary.
Changed after(const Mutation& mutation, const Scene& scene, const Scene& other, const oracle::Query& query,
              Random& random) try {
  Changed changed = mutation.make(scene, other, random);
  if (!changed || *changed == scene) return std::nullopt;
  if (!has_parts_of(scene, *changed) || !is_ordinary(*changed, scene)) return std::nullopt;
  changed = completed_after(std::move(*changed), scene, other);
  if (*changed == scene) return std::nullopt;  // only its faces were dropped
  if (!begins_apart(*changed, query)) return std::nullopt;
  return changed;
} catch (const InputError&) {
  return std::nullopt;
}

}  // namespace

std::vector<std::string> mutations() {
  std::vector<std::string> names;
  for (const Mutation& mutation : all) names.emplace_back(mutation.name);
  return names;
}

Scene mutated(const Scene& scene, const Scene& other, const oracle::Query& query, Random& random) {
  for (int attempt = 0; attempt < attempts; ++attempt) {
    const Mutation& mutation = all[random.below(static_cast<int>(std::size(all)))];
    if (!suits(mutation, query)) continue;
    if (scene.bodies.empty() && mutation.make != of_copy<add_body>) continue;
    if (Changed changed = after(mutation, scene, other, query, random)) return std::move(*changed);
  }
  return scene;
}

}  // namespace touchstone::properties::fuzzing
