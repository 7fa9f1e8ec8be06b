#include <fcl/fcl.h>

#include "tests/bench/distance/contestant.h"
#include "tests/bench/fcl_shape.h"

namespace touchstone::bench {
namespace {

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
  Fcl(const Polytope& A, const Polytope& B, fcl::GJKSolverType solver) : A_(fcl_convex(A)), B_(fcl_convex(B)) {
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
