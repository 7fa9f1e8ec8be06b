#include <fcl/fcl.h>

#include "tests/bench/distance/contestant.h"

namespace touchstone::bench {
namespace {

std::shared_ptr<fcl::Convexd> convex(const Polytope& polytope) {
  const auto faces = std::make_shared<std::vector<int>>();
  for (const std::vector<int>& face : polytope.faces) {
    faces->push_back(static_cast<int>(face.size()));
    faces->insert(faces->end(), face.begin(), face.end());
  }
  return std::make_shared<fcl::Convexd>(std::make_shared<const std::vector<Vec3>>(polytope.vertices),
                                        static_cast<int>(polytope.faces.size()), faces);
}

fcl::Transform3d transform(const Pose& X) {
  const Quaternion& q = X.q_WB;
  fcl::Transform3d T = fcl::Transform3d::Identity();
  T.linear() = Eigen::Quaterniond(q.w, q.x, q.y, q.z).toRotationMatrix();
  T.translation() = X.p_WB;
  return T;
}

/// fcl::distance with witness points, starting from the cached direction of the previous query.
class Fcl : public Contestant {
 public:
  Fcl(const Polytope& A, const Polytope& B, fcl::GJKSolverType solver) : A_(convex(A)), B_(convex(B)) {
    request_.enable_nearest_points = true;
    request_.gjk_solver_type = solver;
  }

  double distance(const FrameSequence::Poses& poses) override {
    fcl::DistanceResultd result;
    return fcl::distance(A_.get(), transform(poses.X_WA), B_.get(), transform(poses.X_WB), request_, result);
  }

 private:
  std::shared_ptr<fcl::Convexd> A_;
  std::shared_ptr<fcl::Convexd> B_;
  fcl::DistanceRequestd request_;
};

Entrant entrant(const std::string& name, fcl::GJKSolverType solver) {
  return {name, "peer", [solver](const Polytope& A, const Polytope& B) { return std::make_unique<Fcl>(A, B, solver); }};
}

}  // namespace

std::vector<Entrant> fcl_solvers() {
  return {entrant("FCL libccd", fcl::GST_LIBCCD), entrant("FCL indep", fcl::GST_INDEP)};
}

}  // namespace touchstone::bench
