#include "oracle/minimise/minimise.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "model/input_error.h"
#include "model/sequence.h"
#include "oracle/minimise/scene_edit.h"
#include "oracle/minimise/shrink.h"

namespace touchstone::oracle {
namespace {

std::size_t vertex_count(const ConvexShape& shape) { return std::max<std::size_t>(1, corners(shape).size()); }

bool is_turned(const Quaternion& q) { return !(q == Quaternion{}); }

bool off_axis(const Vec3& n) { return n.cwiseAbs().maxCoeff() != 1; }

int extras(const Body& body) {
  return !body.name.empty() + !(body.velocity == Velocity{}) + !(body.material == Material{}) +
         !(body.mass == Mass{Density{}});
}

class Search {
 public:
  Search(const Scene& scene, const std::function<bool(const Scene&)>& still_fails, int budget)
      : scene_(scene), still_fails_(still_fails), budget_(budget) {}

  /// One pass over all stages. Returns whether any move helped.
  bool pass() {
    bool helped = false;
    for (const shrink::Stage& stage : shrink::stages()) {
      for (const shrink::Move& move : stage(scene_)) {
        while (budget_ > 0 && accepts(move)) helped = true;
      }
    }
    return helped;
  }

  const Scene& scene() const { return scene_; }

 private:
  bool accepts(const shrink::Move& move) {
    std::optional<Scene> candidate = shrink::step(scene_, move);
    if (!candidate) return false;
    --budget_;
    if (!still_fails_(*candidate)) return false;
    scene_ = std::move(*candidate);
    return true;
  }

  Scene scene_;
  const std::function<bool(const Scene&)>& still_fails_;
  int budget_;
};

}  // namespace

const std::vector<shrink::Stage>& shrink::stages() {
  static const std::vector<Stage> all = {
      shrink_to_defaults, shrink_contacts, shrink_motions,    fewer_pixels,       fewer_frames,  fewer_bodies,
      fewer_placements,   shrink_places,   fewer_parts,       many_vertices_less, shrink_shapes, shrink_poses,
      facing_along_z,     coarser_grids,   few_vertices_less, fewer_bits,         shrink_units};
  return all;
}

shrink::Cost shrink::cost(const Scene& scene) {
  Cost cost;
  cost.bodies = scene.bodies.size();
  cost.frames = scene.frames.size();
  if (const auto& raster = scene.raster) {
    cost.pixels = long{raster->columns} + raster->rows + std::labs(raster->shift_x) + std::labs(raster->shift_y);
  }
  if (scene.motion) cost.samples = scene.motion->sample_times.size() + scene.motion->forces.size();
  for (const SequenceFrame& frame : scene.frames) cost.placements += frame.size();
  const std::vector<Slot> all = slots(scene);
  cost.parts = all.size();
  for (const Slot slot : all) cost.vertices += vertex_count(shape_at(scene, slot));
  Scene numbers = scene;
  for (const auto& some :
       {lengths(numbers), quaternion_components(numbers), mass_numbers(numbers), motion_numbers(numbers)}) {
    for (const double* x : some) {
      const int bits = significant_bits(*x);
      cost.bits_max = std::max(cost.bits_max, bits);
      cost.bits_total += bits;
      if (*x != 0) cost.magnitudes += std::abs(std::ilogb(*x));
    }
  }
  cost.extras = !scene.name.empty() + !scene.gravity.isZero(0);
  if (const auto& motion = scene.motion) {
    cost.extras += 1 + (motion->law != Law::poisson) + !motion->start_times.empty() + motion->envelope.has_value() +
                   (motion->force_bound != 0);
  }
  if (scene.contact) cost.extras += 1 + (scene.contact->law != Law::poisson) + off_axis(scene.contact->nhat_BA_W);
  for (const Pose* X_WB : poses(numbers)) cost.turned += is_turned(X_WB->q_WB);
  for (const Body& body : scene.bodies) {
    cost.extras += extras(body);
    if (const auto* compound = std::get_if<Compound>(&body.shape)) {
      cost.extras += 1;
      for (const Part& part : compound->parts) cost.turned += is_turned(part.X_BP.q_WB);
    }
  }
  return cost;
}

std::optional<Scene> shrink::step(const Scene& scene, const Move& move) {
  std::optional<Scene> candidate = move(scene);
  if (!candidate) return std::nullopt;
  try {
    candidate = with_faces(std::move(*candidate));
  } catch (const InputError&) {
    return std::nullopt;
  }
  if (cost(*candidate) >= cost(scene)) return std::nullopt;
  return candidate;
}

Scene minimise(const Scene& scene, const std::function<bool(const Scene&)>& still_fails, int budget) {
  Search search(scene, still_fails, budget);
  while (search.pass()) {
  }
  return search.scene();
}

Size size_of(const Scene& scene) {
  Size size;
  size.bodies = static_cast<int>(scene.bodies.size());
  std::vector<int> vertices(scene.bodies.size(), 0);
  for (const Slot slot : slots(scene)) vertices[slot.body] += static_cast<int>(vertex_count(shape_at(scene, slot)));
  for (const int count : vertices) size.vertices_per_body_max = std::max(size.vertices_per_body_max, count);
  Scene numbers = scene;
  for (const auto& some : {lengths(numbers), quaternion_components(numbers), motion_numbers(numbers)}) {
    for (const double* x : some) size.significant_bits_max = std::max(size.significant_bits_max, significant_bits(*x));
  }
  return size;
}

}  // namespace touchstone::oracle
