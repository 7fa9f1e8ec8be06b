// A case file: one scene, one subject, one property, and what came of it; enough to run it again anywhere.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "model/json.h"
#include "model/scene.h"
#include "oracle/finding.h"

namespace touchstone::oracle {

struct Case {
  std::string property;     ///< "distance.value"
  std::string subject;      ///< "bullet.double"; empty in a corpus: ask anyone
  std::string family;       ///< where the scene was drawn, "" for a scene that came from elsewhere
  std::uint64_t seed = 0;   ///< of the draw, before it was minimised
  std::uint64_t index = 0;  ///< likewise
  Scene scene;
  Finding finding;
  std::string note;

  bool operator==(const Case&) const = default;
};

/// Doubles survive bit for bit. JSON has no infinity and no NaN: those are the strings "inf", "-inf" and "nan".
Json json_of(const Finding& finding);
Json json_of(const Case& a_case);

/// Strict as model/json.h is: an unknown key, a wrong type, an unknown outcome or defect, or a scene that is not valid
/// is an InputError that names the place. `place` is what messages start with.
Finding read_finding(const Json& json, const std::string& place);
Case case_from(std::string_view text, const std::string& place);

Case read_case(const std::string& path);
void write_case(const Case& a_case, const std::string& path);

}  // namespace touchstone::oracle
