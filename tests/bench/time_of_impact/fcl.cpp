#include <fcl/fcl.h>

#include <memory>
#include <optional>

#include "oracle/rotation.h"
#include "tests/bench/fcl_shape.h"
#include "tests/bench/time_of_impact/casting.h"

namespace touchstone::bench {
namespace {

/// With its reference point: FCL 0.7.0 leaves that of a motion between two transforms unset.
::fcl::InterpMotion<double> motion(const Pose& from, const Pose& to) {
  const auto turned = [](const Pose& X) { return oracle::rotation(X.q_WB).toRotationMatrix(); };
  return {turned(from), from.p_WB, turned(to), to.p_WB, Vec3::Zero()};
}

struct Pair {
  explicit Pair(const Scene& given)
      : A(fcl_convex(std::get<Polytope>(given.bodies[0].shape))),
        B(fcl_convex(std::get<Polytope>(given.bodies[1].shape))) {
    request.ccd_solver_type = ::fcl::CCDC_CONSERVATIVE_ADVANCEMENT;
  }

  std::optional<double> cast(const oracle::subjects::Way& way) const {
    ::fcl::ContinuousCollisionResultd result;
    const ::fcl::InterpMotion<double> of_A = motion(way.from_A, way.to_A), of_B = motion(way.from_B, way.to_B);
    ::fcl::continuousCollide(A.get(), &of_A, B.get(), &of_B, request, result);
    return result.is_collide ? std::optional<double>(result.time_of_contact) : std::nullopt;
  }

  std::shared_ptr<::fcl::Convexd> A, B;
  ::fcl::ContinuousCollisionRequestd request;
};

}  // namespace

std::vector<Entrant> fcl() { return {{"FCL conservative advancement", "peer", casting<Pair>}}; }

}  // namespace touchstone::bench
