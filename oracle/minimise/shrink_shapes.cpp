// Fewer bodies, parts and vertices, and none of what the question does not need.
#include <algorithm>
#include <limits>
#include <numeric>

#include "oracle/minimise/scene_edit.h"
#include "oracle/minimise/shrink.h"
#include "oracle/truth/truth.h"
#include "oracle/truth/world_points.h"

namespace touchstone::oracle::shrink {
namespace {

/// From the centre of this body's points to the centre of all others'; for a separated pair, along its exact distance.
Point towards_others(const Scene& scene, Slot slot) {
  if (scene.bodies.size() == 2) {
    const reference::RationalVec3& d = truth::distance(scene).difference;  // a* − b*
    const Point apart(d.x.nearest(), d.y.nearest(), d.z.nearest());
    if (!apart.isZero(0)) return slot.body == 0 ? Point(-apart) : apart;
  }
  Point own = Point::Zero();
  Point others = Point::Zero();
  Real own_count = 0;
  Real other_count = 0;
  for (const Slot any : slots(scene)) {
    const bool is_own = any.body == slot.body;
    for (const Point& p : world_points(scene.bodies[any.body], any.part)) {
      (is_own ? own : others) += p;
      (is_own ? own_count : other_count) += 1;
    }
  }
  if (other_count == 0) return Point::UnitX();
  return others / other_count - own / own_count;
}

/// Indices of a solid's vertices, the farthest from the others first.
std::vector<std::size_t> farthest_first(const Scene& scene, Slot slot) {
  const Points points = world_points(scene.bodies[slot.body], slot.part);
  const Point towards = towards_others(scene, slot);
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return towards.dot(points[i]); });
  return order;
}

bool exists(const Scene& scene, Slot slot) {
  if (slot.body >= scene.bodies.size()) return false;
  const auto* compound = std::get_if<Compound>(&scene.bodies[slot.body].shape);
  return slot.part == 0 || (compound && slot.part < static_cast<int>(compound->parts.size()));
}

/// Drops the vertices with the ranks from … from + count − 1.
std::optional<Scene> without_vertices(Scene scene, Slot slot, std::size_t from, std::size_t count) {
  if (!exists(scene, slot)) return std::nullopt;
  const ConvexShape shape = shape_at(scene, slot);
  const std::vector<Vec3> all = corners(shape);
  if (all.size() < 4 + count || from + count > all.size()) return std::nullopt;
  const std::vector<std::size_t> order = farthest_first(scene, slot);
  std::vector<bool> dropped(all.size(), false);
  for (std::size_t i = from; i < from + count; ++i) dropped[order[i]] = true;
  Polytope rest;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!dropped[i]) rest.vertices.push_back(all[i]);
  }
  set_shape(scene, slot, rest);
  return scene;
}

/// Moves that drop chunks of count/first, of half of that, …, down to count/last or one vertex.
std::vector<Move> vertices_less(const Scene& scene, std::size_t first, std::size_t last) {
  std::vector<Move> moves;
  for (const Slot slot : slots(scene)) {
    const std::size_t count = corners(shape_at(scene, slot)).size();
    for (std::size_t parts = first; parts <= last && parts < 2 * count; parts *= 2) {
      const std::size_t chunk = std::max<std::size_t>(1, count / parts);
      for (std::size_t from = 0; from + chunk <= count; from += chunk) {
        moves.push_back([=](const Scene& s) { return without_vertices(s, slot, from, chunk); });
      }
    }
  }
  return moves;
}

std::optional<Scene> without_bodies(Scene scene, std::size_t from, std::size_t count) {
  if (from + count > scene.bodies.size() || count == scene.bodies.size()) return std::nullopt;
  const auto begin = scene.bodies.begin() + static_cast<std::ptrdiff_t>(from);
  scene.bodies.erase(begin, begin + static_cast<std::ptrdiff_t>(count));
  const auto drop = [=](auto& about_bodies) {
    std::erase_if(about_bodies, [=](const auto& one) {
      return static_cast<std::size_t>(one.body) >= from && static_cast<std::size_t>(one.body) < from + count;
    });
    for (auto& one : about_bodies) one.body -= static_cast<std::size_t>(one.body) < from ? 0 : static_cast<int>(count);
  };
  for (SequenceFrame& frame : scene.frames) drop(frame);
  if (scene.motion) {
    drop(scene.motion->forces);
    std::vector<double>& starts = scene.motion->start_times;
    const auto first = starts.begin() + static_cast<std::ptrdiff_t>(starts.empty() ? 0 : from);
    starts.erase(first, first + static_cast<std::ptrdiff_t>(starts.empty() ? 0 : count));
  }
  return scene;
}

std::optional<Scene> part_alone(Scene scene, Slot slot) {
  if (!exists(scene, slot)) return std::nullopt;
  Body& body = scene.bodies[slot.body];
  const auto* compound = std::get_if<Compound>(&body.shape);
  if (!compound) return std::nullopt;
  const Part part = compound->parts[static_cast<std::size_t>(slot.part)];
  const Quaternion& q = body.X_WB.q_WB;
  const Quaternion& r = part.X_BP.q_WB;
  body.X_WB.p_WB += rounded_rotation(q) * part.X_BP.p_WB;
  body.X_WB.q_WB = {q.w * r.w - q.x * r.x - q.y * r.y - q.z * r.z, q.w * r.x + q.x * r.w + q.y * r.z - q.z * r.y,
                    q.w * r.y - q.x * r.z + q.y * r.w + q.z * r.x, q.w * r.z + q.x * r.y - q.y * r.x + q.z * r.w};
  std::visit([&body](const auto& shape) { body.shape = shape; }, part.shape);
  return scene;
}

std::optional<Scene> part_less(Scene scene, Slot slot) {
  if (!exists(scene, slot)) return std::nullopt;
  auto* compound = std::get_if<Compound>(&scene.bodies[slot.body].shape);
  if (!compound || compound->parts.size() == 1) return std::nullopt;
  compound->parts.erase(compound->parts.begin() + slot.part);
  return scene;
}

/// Replaces a polytope by its bounding box at the same place: the body's origin moves to the box's centre.
std::optional<Scene> bounding_box(Scene scene, Slot slot) {
  Body& body = scene.bodies[slot.body];
  const auto* polytope = std::get_if<Polytope>(&body.shape);
  if (!polytope) return std::nullopt;
  Vec3 lo = polytope->vertices.front();
  Vec3 hi = lo;
  for (const Vec3& v : polytope->vertices) {
    lo = lo.cwiseMin(v);
    hi = hi.cwiseMax(v);
  }
  body.X_WB.p_WB += rounded_rotation(body.X_WB.q_WB) * (lo / 2 + hi / 2);
  body.shape = Box{hi / 2 - lo / 2};
  return scene;
}

/// Replaces a box by a corner and its three neighbours. `rank` counts the corners from the nearest one.
std::optional<Scene> corner_of_box(Scene scene, Slot slot, std::size_t rank) {
  const ConvexShape shape = shape_at(scene, slot);
  if (!std::holds_alternative<Box>(shape)) return std::nullopt;
  const std::vector<Vec3> all = corners(shape);
  const std::size_t corner = farthest_first(scene, slot)[all.size() - 1 - rank];
  set_shape(scene, slot, Polytope{{all[corner], all[corner ^ 1], all[corner ^ 2], all[corner ^ 4]}, {}});
  return scene;
}

/// Turns every box into a polytope, and puts every body's origin at its nearest vertex and the first of these at the
/// world's origin. The gap is then a translation of its own, and has few bits.
std::optional<Scene> anchored_at_nearest(Scene scene) {
  const Scene before = scene;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    Body& body = scene.bodies[i];
    const Slot slot{i, 0};
    if (std::holds_alternative<Compound>(body.shape)) continue;
    Polytope polytope{corners(shape_at(scene, slot)), {}};
    if (polytope.vertices.empty()) continue;
    const Vec3 origin = polytope.vertices[farthest_first(before, slot).back()];
    for (Vec3& v : polytope.vertices) v -= origin;
    body.X_WB.p_WB += rounded_rotation(body.X_WB.q_WB) * origin;
    body.shape = polytope;
  }
  const Vec3 first = scene.bodies.front().X_WB.p_WB;
  for (Body& body : scene.bodies) body.X_WB.p_WB -= first;
  return scene;
}

template <class Change>
Move changed(Change change) {
  return [change](const Scene& before) {
    Scene scene = before;
    change(scene);
    return std::optional<Scene>(std::move(scene));
  };
}

template <class Change>
Move each_body(Change change) {
  return changed([change](Scene& scene) {
    for (Body& body : scene.bodies) change(body);
  });
}

}  // namespace

std::vector<Move> shrink_to_defaults(const Scene&) {
  const auto no_names = each_body([](Body& body) { body.name.clear(); });
  const auto at_rest = each_body([](Body& body) { body.velocity = {}; });
  const auto no_material = each_body([](Body& body) { body.material = {}; });
  const auto no_mass = each_body([](Body& body) { body.mass = Density{}; });
  const auto no_gravity = changed([](Scene& scene) { scene.gravity = Vec3::Zero(); });
  const auto no_name = changed([](Scene& scene) { scene.name.clear(); });
  const auto all = [=](const Scene& s) {
    Scene scene = *no_name(*no_gravity(s));
    for (const auto& move : {no_names, at_rest, no_material, no_mass}) scene = *move(scene);
    return std::optional(scene);
  };
  return {all, no_name, no_names, at_rest, no_material, no_mass, no_gravity};
}

std::vector<Move> fewer_bodies(const Scene& scene) {
  std::vector<Move> moves;
  const std::size_t count = scene.bodies.size();
  for (std::size_t chunk = count / 2; chunk > 0; chunk /= 2) {
    for (std::size_t from = 0; from < count; from += chunk) {
      moves.push_back([=](const Scene& s) { return without_bodies(s, from, chunk); });
    }
  }
  return moves;
}

std::vector<Move> fewer_parts(const Scene& scene) {
  std::vector<Move> moves;
  for (const Slot slot : slots(scene)) {
    moves.push_back([slot](const Scene& s) { return part_alone(s, slot); });
  }
  for (const Slot slot : slots(scene)) {
    moves.push_back([slot](const Scene& s) { return part_less(s, slot); });
  }
  return moves;
}

std::vector<Move> shrink_shapes(const Scene& scene) {
  std::vector<Move> moves;
  for (const Slot slot : slots(scene)) {
    moves.push_back([slot](const Scene& s) { return bounding_box(s, slot); });
    for (std::size_t rank = 0; rank < 8; ++rank) {
      moves.push_back([=](const Scene& s) { return corner_of_box(s, slot, rank); });
    }
  }
  moves.push_back(anchored_at_nearest);
  return moves;
}

std::vector<Move> many_vertices_less(const Scene& scene) { return vertices_less(scene, 2, 8); }

std::vector<Move> few_vertices_less(const Scene& scene) {
  return vertices_less(scene, 2, std::numeric_limits<std::size_t>::max() / 2);
}

}  // namespace touchstone::oracle::shrink
