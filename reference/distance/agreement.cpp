#include "reference/agreement.h"

#include "reference/certificate.h"
#include "reference/distance.h"

namespace touchstone::reference {
namespace {

std::string text(Verdict verdict) {
  return verdict == Verdict::separated ? "separated" : verdict == Verdict::touching ? "touching" : "overlapping";
}

std::string text(const Rational& r) { return r.text(); }

std::string text(const RationalVec3& v) { return v.x.text() + ", " + v.y.text() + ", " + v.z.text(); }

std::string text(const Feature& feature) {
  std::string list = "part ";
  list.append(std::to_string(feature.part)).append(", vertices");
  for (const int v : feature.vertices) list.append(" ").append(std::to_string(v));
  return list;
}

std::string text(const Interval& i) { return Rational(i.lo).text() + " to " + Rational(i.hi).text(); }

std::string difference(const DistanceTruth& certified, const DistanceTruth& other, const std::string& route) {
  const auto differs = [&](const std::string& what, const auto& ours, const auto& theirs) {
    return what + ": certified says " + text(ours) + ", " + route + " says " + text(theirs);
  };
  if (certified.verdict != other.verdict) return differs("verdict", certified.verdict, other.verdict);
  if (certified.core_squared != other.core_squared) return differs("|d*|²", certified.core_squared, other.core_squared);
  if (certified.difference != other.difference) return differs("d*", certified.difference, other.difference);
  if (certified.distance != other.distance) return differs("distance", certified.distance, other.distance);
  if (certified.feature_A != other.feature_A) return differs("feature A", certified.feature_A, other.feature_A);
  if (certified.feature_B != other.feature_B) return differs("feature B", certified.feature_B, other.feature_B);
  return "";
}

}  // namespace

std::string disagreement(const Scene& scene) {
  const DistanceTruth certified = distance(scene, Route::certified);
  const std::string flaw = check(certified.certificate, scene);
  if (!flaw.empty()) return "certificate: " + flaw;
  const std::string brute = difference(certified, distance(scene, Route::brute_force), "brute force");
  if (!brute.empty()) return brute;
  return difference(certified, distance(scene, Route::qp), "the quadratic program");
}

}  // namespace touchstone::reference
