#include <ccd/ccd.h>

#include <Eigen/Geometry>
#include <limits>

#include "tests/bench/distance/contestant.h"

namespace touchstone::bench {
namespace {

struct CcdBody {
  const std::vector<Vec3>* vertices = nullptr;
  Mat3 R_WB;
  Vec3 p_WB;
};

CcdBody body(const Polytope& polytope, const Pose& X) {
  const Quaternion& q = X.q_WB;
  return {&polytope.vertices, Eigen::Quaterniond(q.w, q.x, q.y, q.z).toRotationMatrix(), X.p_WB};
}

void support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* farthest) {
  const CcdBody& of = *static_cast<const CcdBody*>(object);
  const Vec3 n = of.R_WB.transpose() * Vec3(direction->v[0], direction->v[1], direction->v[2]);
  const Vec3* best = &of.vertices->front();
  double most = n.dot(*best);
  for (const Vec3& v : *of.vertices) {
    const double height = n.dot(v);
    if (height <= most) continue;
    best = &v;
    most = height;
  }
  const Vec3 p = of.R_WB * *best + of.p_WB;
  ccdVec3Set(farthest, p.x(), p.y(), p.z());
}

/// ccdGJKIntersect: whether the bodies overlap; libccd has no distance query.
class Libccd : public Contestant {
 public:
  Libccd(const Polytope& A, const Polytope& B) : A_(A), B_(B) {
    CCD_INIT(&ccd_);
    ccd_.support1 = ccd_.support2 = support;
  }

  double distance(const FrameSequence::Poses& poses) override {
    const CcdBody A = body(A_, poses.X_WA);
    const CcdBody B = body(B_, poses.X_WB);
    return ccdGJKIntersect(&A, &B, &ccd_) ? 0 : std::numeric_limits<double>::quiet_NaN();
  }

 private:
  const Polytope& A_;
  const Polytope& B_;
  ccd_t ccd_{};
};

}  // namespace

std::vector<Entrant> libccd() {
  return {{"libccd (yes or no)", "other",
           [](const Polytope& A, const Polytope& B) { return std::make_unique<Libccd>(A, B); }}};
}

}  // namespace touchstone::bench
