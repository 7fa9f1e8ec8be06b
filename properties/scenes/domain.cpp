#include "properties/scenes/domain.h"

#include <algorithm>

#include "model/input_error.h"
#include "properties/scenes/families.h"

namespace touchstone::properties {
namespace {

std::vector<Family> all_families() {
  std::vector<Family> all;
  for (const auto& some : {box_families(),
                           touching_families(),
                           parallel_families(),
                           slender_families(),
                           round_families(),
                           hull_families(),
                           mixed_families(),
                           redundant_families(),
                           ball_pair_families(),
                           compound_pair_families(),
                           contained_families(),
                           placed_families(),
                           crowd_families(),
                           sequence_families(),
                           long_sequence_families(),
                           mass_families(),
                           pixel_families(),
                           contact_families(),
                           motion_families(),
                           tangent_motion_families(),
                           long_motion_families(),
                           compound_motion_families(),
                           off_centre_motion_families(),
                           run_families(),
                           driven_run_families(),
                           stacked_run_families(),
                           table_families()}) {
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

/// Small, near the origin, and without a hull to compute.
std::vector<Family> plain_families() {
  std::vector<Family> plain;
  for (const auto& some : {box_families(), touching_families(), parallel_families()}) {
    std::ranges::copy_if(some, std::back_inserter(plain), &Family::binary32_exact);
  }
  return plain;
}

}  // namespace

const std::vector<Family>& families() {
  static const std::vector<Family> all = all_families();
  return all;
}

const Family& find_family(const std::string& id) {
  const auto found = std::ranges::find(families(), id, &Family::id);
  if (found != families().end()) return *found;
  std::string near;
  for (const Family& family : families()) {
    if (family.id.substr(0, family.id.find('.')) == id.substr(0, id.find('.'))) near += ' ' + family.id;
  }
  throw InputError(
      "family", "no family is called " + id + (near.empty() ? "; `list families` names them" : "; there are" + near));
}

std::vector<const Family*> for_query(const std::vector<Family>& families, const std::string& query) {
  std::vector<const Family*> chosen;
  for (const Family& family : families) {
    if (std::ranges::find(family.queries, query) != family.queries.end()) chosen.push_back(&family);
  }
  return chosen;
}

Scene draw(const Family& family, std::uint64_t seed, std::uint64_t index) {
  Random random(seed, family.id, index);
  return family.draw(random);
}

Scene some_pair(Random& random) {
  static const std::vector<Family> plain = plain_families();
  return random.pick(plain).draw(random);
}

}  // namespace touchstone::properties
