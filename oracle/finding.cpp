#include "oracle/finding.h"

#include <algorithm>

#include "model/infinity.h"

namespace touchstone::oracle {

double excess(const Finding& finding) {
  if (finding.error == 0) return 0;
  if (finding.unit.starts_with("ulps of ")) return finding.error / std::max(finding.allowed, 1.0);
  return finding.allowed > 0 ? finding.error / finding.allowed : infinity;
}

std::string name_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::holds:
      return "holds";
    case Outcome::fails:
      return "fails";
    case Outcome::abstains:
      return "abstains";
    case Outcome::breaks:
      return "breaks";
    case Outcome::outside:
      return "outside";
  }
  return "unknown";
}

std::string name_of(Defect defect) {
  switch (defect) {
    case Defect::none:
      return "none";
    case Defect::phantom:
      return "phantom";
    case Defect::missed:
      return "missed";
    case Defect::too_far:
      return "too_far";
    case Defect::too_near:
      return "too_near";
    case Defect::overdeep:
      return "overdeep";
    case Defect::shallow:
      return "shallow";
    case Defect::wrong_normal:
      return "wrong_normal";
    case Defect::wrong_witness:
      return "wrong_witness";
    case Defect::wrong_feature:
      return "wrong_feature";
    case Defect::wrong_box:
      return "wrong_box";
    case Defect::loose_box:
      return "loose_box";
    case Defect::wrong_mass:
      return "wrong_mass";
    case Defect::wrong_velocity:
      return "wrong_velocity";
    case Defect::wrong_momentum:
      return "wrong_momentum";
    case Defect::wrong_energy:
      return "wrong_energy";
    case Defect::too_early:
      return "too_early";
    case Defect::too_late:
      return "too_late";
    case Defect::wrong_motion:
      return "wrong_motion";
    case Defect::drifts:
      return "drifts";
    case Defect::pulls:
      return "pulls";
    case Defect::beyond_cone:
      return "beyond_cone";
    case Defect::broken_enclosure:
      return "broken_enclosure";
    case Defect::too_much_work:
      return "too_much_work";
    case Defect::loose_enclosure:
      return "loose_enclosure";
    case Defect::asymmetric:
      return "asymmetric";
    case Defect::moved_with_frame:
      return "moved_with_frame";
    case Defect::scaled:
      return "scaled";
    case Defect::relabelled:
      return "relabelled";
    case Defect::nondeterministic:
      return "nondeterministic";
    case Defect::inconsistent:
      return "inconsistent";
    case Defect::not_finite:
      return "not_finite";
    case Defect::threw:
      return "threw";
    case Defect::refused:
      return "refused";
    case Defect::crashed:
      return "crashed";
    case Defect::hung:
      return "hung";
    case Defect::garbage:
      return "garbage";
  }
  return "unknown";
}

}  // namespace touchstone::oracle
