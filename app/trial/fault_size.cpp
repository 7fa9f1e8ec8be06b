#include "app/trial/fault_size.h"

#include <algorithm>
#include <cmath>

#include "oracle/tolerance/motion.h"
#include "oracle/tolerance/precision.h"
#include "oracle/tolerance/tolerance.h"

namespace touchstone::app {
namespace {

bool has_magnitude(const oracle::Finding& finding) {
  return !finding.unit.empty() && finding.unit != oracle::without_size;
}

bool in_ulps(const oracle::Finding& finding) { return finding.unit.starts_with("ulps of "); }

double over_scene(const oracle::Finding& finding, const Scene& scene, oracle::Precision precision) {
  if (in_ulps(finding)) return finding.error * oracle::unit_roundoff(precision);
  if (finding.unit == "m") return finding.error / oracle::tolerance::scale(scene);
  const double fastest = oracle::tolerance::fastest_at_start(scene);
  if (finding.unit == "m/s" && fastest > 0) return finding.error / fastest;
  return 0;
}

}  // namespace

FaultSize fault_size(const oracle::Finding& finding, const Scene& scene, oracle::Precision precision) {
  if (!has_magnitude(finding)) return {};
  return {oracle::excess(finding), over_scene(finding, scene, precision)};
}

bool is_measurable(const oracle::Finding& finding, oracle::Precision precision) {
  if (!has_magnitude(finding)) return true;
  if (!std::isfinite(finding.error) || !std::isfinite(finding.allowed)) return false;
  return !in_ulps(finding) || finding.allowed * oracle::unit_roundoff(precision) < 1;
}

bool as_large(const FaultSize& now, const FaultSize& found) {
  return now.over_allowance >= found.over_allowance && now.over_scene >= found.over_scene;
}

}  // namespace touchstone::app
