#include "oracle/subjects/touchstone/fast_pairs.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "fast/bounds.h"
#include "fast/broad_phase/all_pairs.h"
#include "fast/collider.h"
#include "fast/lin_canny/rotation.h"
#include "fast/penetration.h"
#include "model/input_error.h"
#include "oracle/subject.h"
#include "oracle/subjects/common/broad_phase_world.h"
#include "oracle/subjects/touchstone/fast_work.h"
#include "oracle/subjects/touchstone/fast_work_limits.h"

namespace touchstone::oracle::subjects {
namespace {

using fast::lin_canny::FeatureId;
using fast::lin_canny::Hull;
using fast::lin_canny::Kind;
using fast::lin_canny::NearestParts;
using fast::lin_canny::Solid;

std::vector<int> vertices_of(const Hull& hull, const FeatureId& feature) {
  if (feature.kind == Kind::vertex) return {feature.index};
  if (feature.kind == Kind::edge) return {hull.edge(feature.index).tail, hull.edge(feature.index).head};
  std::vector<int> corners;
  for (const Hull::Corner& corner : hull.corners(hull.face(feature.index))) corners.push_back(corner.vertex);
  return corners;
}

/// Vertices of a hull by their indices in the shape, which may have more: none of those is a corner of the hull. Of
/// equal vertices the first is named.
Feature named(const Shape& shape, int part, const std::vector<int>& exact, const FeatureId& walked) {
  const auto core = [part](const Solid& solid) { return solid.parts()[static_cast<std::size_t>(part)].core; };
  const Hull hull = core(Solid(shape)), given = core(Solid(shape, Solid::Preparation::vertices));
  Feature feature{part, exact.empty() ? vertices_of(hull, walked) : exact};
  for (int& v : feature.vertices) {
    v = static_cast<int>(std::ranges::find(given.vertices(), hull.vertex(v)) - given.vertices().begin());
  }
  std::ranges::sort(feature.vertices);
  return feature;
}

/// Some 30 degrees of rotation from X and, unless that is beyond the range of doubles, some way beside it.
Pose beside(const Pose& X, const Vec3& from) {
  const auto& [w, x, y, z] = fast::lin_canny::at_moderate_scale(X.q_WB);
  Pose moved = X;
  moved.q_WB = {w - x / 4 - y / 8, x + w / 4 + z / 8, y + w / 8 - z / 4, z + y / 4 - x / 8};
  const Vec3 p = X.p_WB + (X.p_WB - from) / 8;
  if (p.allFinite()) moved.p_WB = p;
  return moved;
}

/// The answer; an abstention if a number is beyond the range of doubles, or of a depth of compounds.
template <class Said, class Ask>
Answer<Said> unless_beyond(Ask&& ask) {
  try {
    return ask();
  } catch (const InputError& beyond) {
    return Abstains{beyond.what()};
  } catch (const std::range_error& beyond) {
    return Abstains{beyond.what()};
  }
}

/// What is measured of the first two bodies; an abstention if there are fewer.
template <class Measure>
auto of_two(const Scene& scene, Measure&& measure) {
  return unless_beyond<decltype(measure(Body(), Body()))>([&] {
    if (scene.bodies.size() < 2) throw InputError("bodies", "expected two");
    return measure(scene.bodies[0], scene.bodies[1]);
  });
}

/// m: with this margin the cubes about the two overlap, also where B is beside itself.
double margin_of(const Body& A, const Body& B) {
  double farthest = 0;
  for (const Body* body : {&A, &B}) {
    const Aabb box = fast::box(*body);
    farthest = std::max({farthest, box.lo.cwiseAbs().maxCoeff(), box.hi.cwiseAbs().maxCoeff()});
  }
  return 4 * farthest;
}

/// The near pairs of bodies that come, move and go.
class ColliderWorld : public World {
 public:
  explicit ColliderWorld(const Scene& scene) : scene_(scene) {}

  void put(int body, const Pose& X_WB) override {
    collider_.insert(static_cast<fast::BodyId>(body), scene_.bodies[static_cast<std::size_t>(body)].shape, X_WB);
  }
  void move(int body, const Pose& X_WB) override { collider_.move(static_cast<fast::BodyId>(body), X_WB); }
  void take(int body) override { collider_.remove(static_cast<fast::BodyId>(body)); }

  PairFrame end_frame() override {
    collider_.update();
    PairFrame frame;
    for (const auto& [bodies, nearest] : collider_.pairs()) {
      frame.pairs.emplace_back(static_cast<int>(bodies.a), static_cast<int>(bodies.b));
    }
    std::ranges::sort(frame.pairs);
    return frame;
  }

 private:
  fast::Collider collider_;
  const Scene& scene_;
};

class FastPairs : public Subject {
 public:
  FastPairs(const std::string& name, bool is_warm) : is_warm_(is_warm) {
    card_.name = "fast." + name;
    card_.version = "0.1.0";
    card_.answers = {"distance", "penetration"};
    card_.knows_touching = true;
    card_.about = std::string("Touchstone's collider (Lin and Canny's walk) and penetration pair, ") +
                  (is_warm ? "from where they ended in the frame before" : "in their first frame");
    card_.work_limits = fast_pairs_work_limits();
    if (!is_warm) return;
    card_.answers.insert(card_.answers.end(), {"broad_phase", "pair_history"});
    card_.boxes = BoxKind::of_ball;
  }

  const Card& card() const override { return card_; }

  Answer<Work> work(const std::string& query, const Scene& scene) override { return fast_work(*this, query, scene); }

  Answer<PairSet> broad_phase(const Scene& scene) override {
    if (!is_warm_) return Subject::broad_phase(scene);
    return unless_beyond<PairSet>([&] { return broad_phase_in(make_world, scene); });
  }
  Answer<PairHistory> pair_history(const Scene& sequence) override {
    if (!is_warm_) return Subject::pair_history(sequence);
    return unless_beyond<PairHistory>([&] { return pair_history_in(make_world, sequence); });
  }

  Answer<Distance> distance(const Scene& scene) override {
    return of_two(scene, [&](const Body& A, const Body& B) { return measured(A, B); });
  }

  Answer<Penetration> penetration(const Scene& scene) override {
    return of_two(scene, [&](const Body& A, const Body& B) {
      fast::PenetrationPair pair(A.shape, B.shape);
      if (is_warm_) pair.at(A.X_WB, beside(B.X_WB, A.X_WB.p_WB));
      return pair.at(A.X_WB, B.X_WB).answer;
    });
  }

 private:
  static std::unique_ptr<World> make_world(const Scene& scene) { return std::make_unique<ColliderWorld>(scene); }

  Distance measured(const Body& A, const Body& B) const {
    fast::Collider collider(std::make_unique<fast::AllPairs>(), margin_of(A, B));
    collider.insert(0, A.shape, A.X_WB);
    collider.insert(1, B.shape, is_warm_ ? beside(B.X_WB, A.X_WB.p_WB) : B.X_WB);
    collider.update();
    if (is_warm_) {
      collider.move(1, B.X_WB);
      collider.update();
    }
    const NearestParts& nearest = collider.pairs().at(0).nearest;
    const fast::lin_canny::Proximity& found = nearest.proximity;
    Distance answer = as_distance(found);
    if (found.verdict == Verdict::overlapping) return answer;
    answer.feature_A = named(A.shape, nearest.part_A, found.closest_vertices_A, found.features.a);
    answer.feature_B = named(B.shape, nearest.part_B, found.closest_vertices_B, found.features.b);
    return answer;
  }

  Card card_;
  bool is_warm_;
};

}  // namespace

std::unique_ptr<Subject> make_fast_pairs(const std::string& name) {
  return std::make_unique<FastPairs>(name, name == "warm");
}

}  // namespace touchstone::oracle::subjects
