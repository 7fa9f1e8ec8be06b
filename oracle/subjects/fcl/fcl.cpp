#include "oracle/subjects/fcl/fcl.h"

#include <algorithm>

#include "oracle/subject.h"
#include "oracle/subjects/common/customary_domain.h"
#include "oracle/subjects/fcl/input.h"
#include "oracle/subjects/fcl/snippet.h"

namespace touchstone::oracle::subjects {
namespace {

using namespace in_fcl;

/// FCL's inertia is that of unit mass for a Convex, and that of unit density for a Box and a Sphere.
std::optional<MassProperties> mass_of(const Body& body) {
  if (const MassProperties* given = std::get_if<MassProperties>(&body.mass)) return *given;
  if (!std::holds_alternative<Density>(body.mass)) return std::nullopt;
  const double density = std::get<Density>(body.mass).value;
  const Geometry geometry = std::visit(MakeGeometry{}, body.shape);
  const double mass = density * geometry->computeVolume();
  const double unit = std::holds_alternative<Polytope>(body.shape) ? mass : density;
  return MassProperties{mass, geometry->computeCOM(), unit * geometry->computeMomentofInertiaRelatedToCOM()};
}

Aabb aabb_of(const Body& body) {
  const FclBody ready(body);
  ::fcl::AABBd box;
  if (const auto* sphere = dynamic_cast<const ::fcl::Sphered*>(ready.geometry.get())) {
    ::fcl::computeBV(*sphere, ready.X_WB, box);
  } else if (const auto* cuboid = dynamic_cast<const ::fcl::Boxd*>(ready.geometry.get())) {
    ::fcl::computeBV(*cuboid, ready.X_WB, box);
  } else if (const auto* convex = dynamic_cast<const ::fcl::Convexd*>(ready.geometry.get())) {
    ::fcl::computeBV(*convex, ready.X_WB, box);
  }
  return {box.min_, box.max_};
}

bool note_pair(::fcl::CollisionObjectd* a, ::fcl::CollisionObjectd* b, void* pairs) {
  const auto index = [](const ::fcl::CollisionObjectd* object) {
    return *static_cast<const int*>(object->getUserData());
  };
  static_cast<PairSet*>(pairs)->push_back(std::minmax(index(a), index(b)));
  return false;  // continue the traversal
}

class Fcl : public Subject {
 public:
  Fcl(Card card, ::fcl::GJKSolverType solver) : card_(std::move(card)), solver_(solver) {}

  const Card& card() const override { return card_; }

  Answer<Masses> mass(const Scene& scene) override {
    if (has_compound(scene)) return no_compounds;
    Masses said;
    for (const Body& body : scene.bodies) said.push_back(mass_of(body));
    return said;
  }

  Answer<Bounds> bounds(const Scene& scene) override {
    if (has_compound(scene)) return no_compounds;
    Bounds said;
    for (const Body& body : scene.bodies) said.push_back(aabb_of(body));
    return said;
  }

  Answer<PairSet> broad_phase(const Scene& scene) override {
    if (has_compound(scene)) return no_compounds;
    std::vector<int> indices(scene.bodies.size());
    std::vector<std::unique_ptr<::fcl::CollisionObjectd>> objects;
    ::fcl::DynamicAABBTreeCollisionManagerd manager;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      const FclBody body(scene.bodies[i]);
      indices[i] = static_cast<int>(i);
      objects.push_back(std::make_unique<::fcl::CollisionObjectd>(body.geometry, body.X_WB));
      objects.back()->setUserData(&indices[i]);
      manager.registerObject(objects.back().get());
    }
    manager.setup();
    PairSet pairs;
    manager.collide(&pairs, note_pair);
    std::sort(pairs.begin(), pairs.end());
    return pairs;
  }

  Answer<Distance> distance(const Scene& scene) override {
    if (has_compound(scene)) return no_compounds;
    const FclBody A(scene.bodies.at(0));
    const FclBody B(scene.bodies.at(1));
    ::fcl::DistanceRequestd request(true);  // with nearest points; all else at FCL's defaults
    request.gjk_solver_type = solver_;
    ::fcl::DistanceResultd result;
    ::fcl::distance(A.geometry.get(), A.X_WB, B.geometry.get(), B.X_WB, request, result);
    // FCL reports "in collision" by a negative distance. For touching bodies a two-valued verdict may be either.
    if (result.min_distance <= 0) return in_collision();
    return apart(result.min_distance, result.nearest_points[0], result.nearest_points[1]);
  }

  Answer<Penetration> penetration(const Scene& scene) override {
    if (has_compound(scene)) return no_compounds;
    const FclBody A(scene.bodies.at(0));
    const FclBody B(scene.bodies.at(1));
    ::fcl::CollisionRequestd request(1, true);  // the deepest contact; all else at FCL's defaults
    request.gjk_solver_type = solver_;
    ::fcl::CollisionResultd result;
    ::fcl::collide(A.geometry.get(), A.X_WB, B.geometry.get(), B.X_WB, request, result);
    if (!result.isCollision()) return no_penetration();
    // FCL's normal points from A to B.
    return deep(result.getContact(0).penetration_depth, -result.getContact(0).normal);
  }

  Answer<std::string> reproduce(const std::string& query, const Scene& scene, const std::string& expected) override {
    if (has_compound(scene)) return no_compounds;
    const char* solver = solver_ == ::fcl::GST_LIBCCD ? "GST_LIBCCD" : "GST_INDEP";
    if (query == "distance") return distance_snippet(scene, solver, expected);
    if (query == "penetration") return penetration_snippet(scene, solver, expected);
    if (query == "mass") return mass_snippet(scene, expected);
    return Abstains{"no snippets of " + query};
  }

 private:
  Card card_;
  ::fcl::GJKSolverType solver_;
};

const std::string issues = "https://github.com/flexible-collision-library/fcl/issues/";

Card card(const std::string& name, const std::string& solver, std::vector<Deviation> deviations) {
  deviations.push_back({"",
                        "a Convex's inertia is that of a unit mass, but is moved to its centre as if of unit density",
                        issues + "595"});
  return {.name = name,
          .version = FCL_VERSION,
          .answers = {"mass", "bounds", "broad_phase", "distance", "penetration"},
          .about = "fcl::distance, fcl::collide (deepest contact), computeBV, DynamicAABBTreeCollisionManager; " +
                   solver + ", FCL's own settings",
          .homepage = "https://github.com/flexible-collision-library/fcl",
          .deviations = std::move(deviations),
          .domain = customary_domain(),
          .boxes = BoxKind::of_ball,  // CollisionObject::computeAABB of a rotated object; also FCL's issue 509
          .reproduces = {"mass", "distance", "penetration"}};
}

}  // namespace

std::unique_ptr<Subject> make_fcl_libccd() {
  Card libccd = card("fcl.libccd", "GST_LIBCCD",
                     {{"", "the distance of two unit boxes, 3 apart along y, is 3.16", issues + "508"},
                      {"", "__ccdGJK mistakes touching and giving up for separated", issues + "366"},
                      {"", "exceptions and failed asserts in EPA when touching", issues + "319"}});
  libccd.distance_tolerance.absolute = ::fcl::DistanceRequestd().distance_tolerance;  // that of collide() is the same
  return std::make_unique<Fcl>(std::move(libccd), ::fcl::GST_LIBCCD);
}

std::unique_ptr<Subject> make_fcl_indep() {
  return std::make_unique<Fcl>(
      card(
          "fcl.indep", "GST_INDEP",
          {{"", "collide() reports the depth of convex shapes negated, which aborts a signed distance", issues + "541"},
           {"", "collide() leaves the normal of convex shapes in the first one's frame", ""}}),
      ::fcl::GST_INDEP);
}

}  // namespace touchstone::oracle::subjects
