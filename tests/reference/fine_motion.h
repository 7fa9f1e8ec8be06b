// Screw motions of bodies in 76 digits, and the gap between two hulls by all axes that can separate them. Checks
// certified times; shares no code with the reference.
#pragma once

#include <Eigen/Geometry>
#include <boost/multiprecision/eigen.hpp>
#include <boost/multiprecision/mpfr.hpp>
#include <vector>

#include "model/scene.h"

namespace touchstone::tests {

using Fine =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<76, boost::multiprecision::allocate_stack>,
                                  boost::multiprecision::et_off>;
using FineVec = Eigen::Matrix<Fine, 3, 1>;

/// A body with three equal moments about its own origin, a polytope.
class FineMotion {
 public:
  FineMotion(const Scene& scene, std::size_t index);

  std::vector<FineVec> vertices(double time) const;
  Pose pose(double time) const;  ///< to rounding
  const std::vector<std::vector<int>>& faces() const;

 private:
  FineVec turned(const FineVec& v, double time) const;
  FineVec place(double time) const;

  const Body& body_;
  FineVec gravity_;
};

/// The greatest over face normals and crossed edges n of (min n·a − max n·b)/|n|: above 0 exactly if the two are apart.
Fine greatest_gap(const FineMotion& A, const FineMotion& B, double time);

}  // namespace touchstone::tests
