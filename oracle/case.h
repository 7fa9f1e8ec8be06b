// A case file: one scene, one subject, one property and the finding. It is enough to run the case again anywhere.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "model/json.h"
#include "model/json_node.h"
#include "model/scene.h"
#include "oracle/finding.h"

namespace touchstone::oracle {

/// The second question of a law, about the scene after a change whose effect on the truth is known.
struct ChangedScene {
  std::string how;  ///< "all lengths times 2^20"
  Scene scene;
  std::string snippet = {};  ///< as in Case

  bool operator==(const ChangedScene&) const = default;
};

/// The contents of a case file.
struct Case {
  std::string property;     ///< "distance.value"
  std::string subject;      ///< "bullet.double"; empty in a corpus: for any subject
  std::string family;       ///< the family that the scene was drawn from; "" for any other scene
  std::uint64_t seed = 0;   ///< of the draw, before the scene was minimised
  std::uint64_t index = 0;  ///< of the draw, likewise
  Scene scene;
  Finding finding;
  std::string note;
  std::optional<ChangedScene> changed = {};  ///< if the answer about this scene broke a law, or is missing
  std::string folder = {};                   ///< of a subject "exec:...": the absolute path where its command ran
  std::string snippet = {};                  ///< a program in the engine's own API that asks the question; may be empty

  bool operator==(const Case&) const = default;
};

/// A double, bit for bit. JSON has no infinity and no NaN, so these are written as "inf", "-inf" and "nan". `node` is
/// of the same value, for errors: InputError if it is none of these.
Json json_of_number(double x);
double read_number(const Json& json, const Node& node);

/// Without loss: `read_finding` and `case_from` read them.
Json json_of(const Finding& finding);
Json json_of(const Case& a_case);

/// Strict, as model/json.h is: an unknown key, a wrong type, an unknown outcome or defect, or a scene that is not valid
/// is an InputError that names the place. Messages start with `place`.
Finding read_finding(const Json& json, const std::string& place);
Case case_from(std::string_view text, const std::string& place);

/// `read_case` throws InputError for what `case_from` or read_source (model/source_text.h) refuses; `write_case` throws
/// what write_text (model/json.h) throws, and leaves the old file where it fails.
Case read_case(const std::string& path);
void write_case(const Case& a_case, const std::string& path);

}  // namespace touchstone::oracle
