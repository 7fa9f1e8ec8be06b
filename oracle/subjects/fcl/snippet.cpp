#include "oracle/subjects/fcl/snippet.h"

#include <fmt/ranges.h>

#include "oracle/subjects/common/snippet.h"

namespace touchstone::oracle::subjects::in_fcl {
namespace {

/// FCL's box takes full side lengths.
struct Declared {
  std::string name;

  std::string operator()(const Sphere& sphere) const {
    return fmt::format("  const fcl::Sphered {}({});\n", name, cpp_number(sphere.radius));
  }
  std::string operator()(const Box& box) const {
    return fmt::format("  const fcl::Boxd {}({});\n", name, cpp_list(2 * box.half_extents));
  }
  std::string operator()(const Polytope& polytope) const {
    std::string vertices, faces;
    for (const Vec3& v : polytope.vertices) vertices += fmt::format("    {{{}}},\n", cpp_list(v));
    for (const std::vector<int>& face : polytope.faces) {
      faces += fmt::format("    {}, {},\n", face.size(), fmt::join(face, ", "));
    }
    return fmt::format(
        "  const auto vertices_{0} = std::make_shared<const std::vector<fcl::Vector3d>>(std::vector<fcl::Vector3d>{{\n"
        "{1}  }});\n  const auto faces_{0} = std::make_shared<const std::vector<int>>(std::vector<int>{{\n{2}  }});\n"
        "  const fcl::Convexd {0}(vertices_{0}, {3}, faces_{0});\n",
        name, vertices, faces, polytope.faces.size());
  }
  std::string operator()(const Compound&) const { return ""; }
};

/// The matrix, as the adapter gives it to FCL.
std::string placed(const std::string& name, const Body& body) {
  const Mat3 R = rotation(body.X_WB.q_WB).toRotationMatrix();
  return fmt::format(
      "{0}  fcl::Transform3d X_{1} = fcl::Transform3d::Identity();\n  X_{1}.linear() << {2},\n      {3},\n      {4};\n"
      "  X_{1}.translation() << {5};\n",
      std::visit(Declared{name}, body.shape), name, cpp_list(R.row(0)), cpp_list(R.row(1)), cpp_list(R.row(2)),
      cpp_list(body.X_WB.p_WB));
}

std::string program(const std::string& expected, const std::string& statements) {
  return "// g++ fcl.cpp $(pkg-config --cflags --libs fcl ccd) -o fcl && ./fcl\n#include <fcl/fcl.h>\n\n"
         "#include <cstdio>\n\nint main() {\n" +
         cpp_printed(expected) + statements + "}\n";
}

std::string pair(const Scene& scene) { return placed("A", scene.bodies.at(0)) + placed("B", scene.bodies.at(1)); }

}  // namespace

std::string distance_snippet(const Scene& scene, const std::string& solver, const std::string& expected) {
  return program(expected, pair(scene) + fmt::format(R"(  fcl::DistanceRequestd request(true);
  request.gjk_solver_type = fcl::{};
  fcl::DistanceResultd result;
  fcl::distance(&A, X_A, &B, X_B, request, result);
  std::printf("distance: %.17g\n", result.min_distance);  // below 0 in collision
  for (const fcl::Vector3d& p : result.nearest_points) std::printf("point: %.17g %.17g %.17g\n", p.x(), p.y(), p.z());
)",
                                                     solver));
}

std::string penetration_snippet(const Scene& scene, const std::string& solver, const std::string& expected) {
  return program(expected, pair(scene) + fmt::format(R"(  fcl::CollisionRequestd request(1, true);
  request.gjk_solver_type = fcl::{};
  fcl::CollisionResultd result;
  fcl::collide(&A, X_A, &B, X_B, request, result);
  std::printf("in collision: %d\n", result.isCollision());
  if (!result.isCollision()) return 0;
  const fcl::Contactd& contact = result.getContact(0);
  const fcl::Vector3d& n = contact.normal;
  std::printf("depth: %.17g\nnormal from A to B: %.17g %.17g %.17g\n", contact.penetration_depth, n.x(), n.y(), n.z());
)",
                                                     solver));
}

std::string mass_snippet(const Scene& scene, const std::string& expected) {
  std::string statements;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const Body& body = scene.bodies[i];
    if (!std::holds_alternative<Density>(body.mass)) continue;
    const std::string name = fmt::format("body_{}", i);
    statements += std::visit(Declared{name}, body.shape) + fmt::format(R"(  {{
    const fcl::Vector3d c = {0}.computeCOM();
    const fcl::Matrix3d I = {0}.computeMomentofInertiaRelatedToCOM();  // of a Convex: of unit mass; else of unit density
    std::printf("volume: %.17g\ncentre: %.17g %.17g %.17g\n", {0}.computeVolume(), c.x(), c.y(), c.z());
    for (int k = 0; k < 3; ++k) std::printf("inertia: %.17g %.17g %.17g\n", I(k, 0), I(k, 1), I(k, 2));
  }}
)",
                                                                       name);
  }
  return program(expected, statements);
}

}  // namespace touchstone::oracle::subjects::in_fcl
