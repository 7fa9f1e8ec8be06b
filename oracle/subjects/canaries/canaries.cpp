#include "oracle/subjects/canaries/canaries.h"

#include <algorithm>

#include "model/input_error.h"
#include "oracle/subjects/canaries/lie.h"

namespace touchstone::oracle::subjects {

const std::vector<Canary>& canaries() {
  static const std::vector<Canary> all = [] {
    std::vector<Canary> joined;
    for (const auto& some :
         {canaries_about_mass, canaries_about_boxes, canaries_about_sequences, canaries_about_pairs_of_bodies,
          canaries_about_closest_features, canaries_about_impacts, canaries_about_pixels, canaries_about_motion,
          canaries_about_simulations, canaries_about_constraints, canaries_about_anything}) {
      for (Canary& canary : some()) joined.push_back(std::move(canary));
    }
    return joined;
  }();
  return all;
}

const Canary& canary(const std::string& id) {
  const auto found = std::ranges::find(canaries(), id, &Canary::id);
  if (found != canaries().end()) return *found;
  std::string ids;
  for (const Canary& known : canaries()) ids += " " + known.id;
  throw InputError("canary " + id, "unknown; there are" + ids);
}

}  // namespace touchstone::oracle::subjects
