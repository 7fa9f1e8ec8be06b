// The exact distance of two bodies, and its proof.
#include <touchstone/reference/distance.h>
#include <touchstone/reference/validity.h>

#include <cstdio>

using namespace touchstone;

int main() {
  // A box, and a tetrahedron beside it. The quaternion (w, x, y, z) need not have length 1: it means the rotation of
  // q/|q|, exactly, which is a matrix of rational numbers.
  Body box, tetrahedron;
  box.shape = Box{Vec3(1, 1, 1)};
  tetrahedron.shape = Polytope{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}, {}};
  tetrahedron.X_WB = {Vec3(0.5, 3, 2.5), {3, 1, 2, 0}};

  // `completed` validates the scene and derives the tetrahedron's faces. It throws InputError, which names the place,
  // if a body is not a solid.
  Scene pair;
  pair.bodies = {box, tetrahedron};
  const Scene scene = reference::completed(pair);

  // All of the truth is exact: the square of the distance is a rational number, and `distance` holds the two doubles
  // next to its root.
  const reference::DistanceTruth truth = reference::distance(scene);
  std::printf("separated: %s\n", truth.verdict == Verdict::separated ? "yes" : "no");
  std::printf("squared distance: %s m^2, exactly\n", truth.core_squared.text().c_str());
  std::printf("distance: between %.17g and %.17g m\n", truth.distance.lo, truth.distance.hi);
  std::printf("closest points: (%g, %g, %g) and (%g, %g, %g)\n", truth.p_WCa.x(), truth.p_WCa.y(), truth.p_WCa.z(),
              truth.p_WCb.x(), truth.p_WCb.y(), truth.p_WCb.z());

  // The truth comes with a certificate, which a short checker verifies that shares no code with the search.
  const std::string complaint = reference::check(truth.certificate, scene);
  std::printf("proof: %s\n", complaint.empty() ? "holds" : complaint.c_str());
}
