#include "oracle/subjects/bullet/cast.h"

#include <BulletCollision/NarrowPhaseCollision/btContinuousConvexCollision.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkConvexCast.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btSubSimplexConvexCast.h>

#include <cmath>
#include <stdexcept>

#include "oracle/subject.h"
#include "oracle/subjects/bullet/input.h"
#include "oracle/subjects/common/cast.h"

namespace touchstone::oracle::subjects {
namespace {

using namespace in_bullet;

struct Result : btConvexCast::CastResult {
  void reportFailure(int error, int iterations) override {
    throw std::runtime_error("the cast failed with error " + std::to_string(error) + " after " +
                             std::to_string(iterations) + " iterations");
  }
};

class BulletCast : public Subject {
 public:
  explicit BulletCast(const std::string& algorithm) : algorithm_(algorithm) {
    const bool turns = algorithm == "continuous";
    card_.name = "bullet." + algorithm;
    card_.version = std::to_string(btGetVersion() / 100) + "." + std::to_string(btGetVersion() % 100);
    card_.precision = is_double ? Precision::binary64 : Precision::binary32;
    card_.answers = {"time_of_impact"};
    card_.about = std::string(turns                       ? "btContinuousConvexCollision"
                              : algorithm == "subsimplex" ? "btSubsimplexConvexCast"
                                                          : "btGjkConvexCast") +
                  (turns ? " over ways of less than half a radian" : ", which does not turn") + ", margins 0";
    card_.domain = domain();
    // In their sources btSubsimplexConvexCast ends at a squared distance of 10 SIMD_EPSILON, the others at 0.001.
    card_.contact_tolerance.absolute = algorithm == "subsimplex" ? std::sqrt(10 * SIMD_EPSILON) : 0.001;
    card_.homepage = "https://github.com/bulletphysics/bullet3";
  }

  const Card& card() const override { return card_; }

  Answer<TimeOfImpact> time_of_impact(const Scene& scene) override {
    return cast_along(scene, algorithm_ == "continuous", [&](const Way& way) -> std::optional<double> {
      const ConvexPtr A = std::visit(MakeShape{}, scene.bodies[0].shape);
      const ConvexPtr B = std::visit(MakeShape{}, scene.bodies[1].shape);
      Result result;
      const auto along = [&](btConvexCast&& cast) {
        return cast.calcTimeOfImpact(transform(way.from_A), transform(way.to_A), transform(way.from_B),
                                     transform(way.to_B), result);
      };
      btVoronoiSimplexSolver simplex;
      btGjkEpaPenetrationDepthSolver epa;
      const bool hit = algorithm_ == "continuous" ? along(btContinuousConvexCollision(A.get(), B.get(), &simplex, &epa))
                       : algorithm_ == "subsimplex" ? along(btSubsimplexConvexCast(A.get(), B.get(), &simplex))
                                                    : along(btGjkConvexCast(A.get(), B.get(), &simplex));
      // A fraction above 1 is a hit after the end of the way. The casts leave it to their callers, as Bullet's own do.
      return hit && result.m_fraction <= 1 ? std::optional<double>(result.m_fraction) : std::nullopt;
    });
  }

 private:
  std::string algorithm_;
  Card card_;
};

}  // namespace

std::unique_ptr<Subject> make_bullet_cast(const std::string& algorithm) {
  return std::make_unique<BulletCast>(algorithm);
}

}  // namespace touchstone::oracle::subjects
