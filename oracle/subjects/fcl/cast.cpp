#include "oracle/subjects/fcl/cast.h"

#include <stdexcept>

#include "oracle/subject.h"
#include "oracle/subjects/common/cast.h"
#include "oracle/subjects/common/customary_domain.h"
#include "oracle/subjects/fcl/input.h"

namespace touchstone::oracle::subjects {
namespace {

using namespace in_fcl;

/// Given its reference point, since FCL 0.7.0 leaves it unset where it makes a motion from two poses itself, and then
/// reads it.
::fcl::InterpMotion<double> motion(const ::fcl::Transform3d& from, const ::fcl::Transform3d& to) {
  return {from.linear(), from.translation(), to.linear(), to.translation(), Vec3::Zero()};
}

class FclCast : public Subject {
 public:
  FclCast() {
    card_.name = "fcl.conservative_advancement";
    card_.version = FCL_VERSION;
    card_.answers = {"time_of_impact"};
    card_.about =
        "fcl::continuousCollide of two InterpMotions by conservative advancement with libccd's GJK, over ways of less "
        "than half a radian; settings as shipped, the reference points are the bodies' origins";
    card_.domain = customary_domain();
    // It ends once its next step is less than toc_err of the way; a distance is within GJK's tolerance.
    card_.contact_tolerance = {.absolute = ::fcl::DistanceRequestd().distance_tolerance,
                               .way = ::fcl::ContinuousCollisionRequestd().toc_err};
    card_.homepage = "https://github.com/flexible-collision-library/fcl";
  }

  const Card& card() const override { return card_; }

  Answer<TimeOfImpact> time_of_impact(const Scene& scene) override {
    return cast_along(scene, true, [&](const Way& way) -> std::optional<double> {
      const Geometry A = std::visit(MakeGeometry{}, scene.bodies[0].shape);
      const Geometry B = std::visit(MakeGeometry{}, scene.bodies[1].shape);
      ::fcl::ContinuousCollisionRequestd request;
      request.ccd_solver_type = ::fcl::CCDC_CONSERVATIVE_ADVANCEMENT;
      ::fcl::ContinuousCollisionResultd result;
      const ::fcl::InterpMotion<double> motion_A = motion(transform(way.from_A), transform(way.to_A));
      const ::fcl::InterpMotion<double> motion_B = motion(transform(way.from_B), transform(way.to_B));
      const double part = ::fcl::continuousCollide(A.get(), &motion_A, B.get(), &motion_B, request, result);
      if (part < 0) throw std::runtime_error("fcl::continuousCollide gave " + std::to_string(part));
      return result.is_collide ? std::optional<double>(result.time_of_contact) : std::nullopt;
    });
  }

 private:
  Card card_;
};

}  // namespace

std::unique_ptr<Subject> make_fcl_cast() { return std::make_unique<FclCast>(); }

}  // namespace touchstone::oracle::subjects
