// A libFuzzer target: `fast` about one query. Any bytes are a valid scene (properties/fuzzing/recipe.h), which is asked
// under all properties. A failure is written as a case file for `touchstone replay`, and ends the program.
//
// The query is the macro TOUCHSTONE_FUZZED_QUERY. docs/how_to/fuzz.md says how to build and run it.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "model/input_error.h"
#include "oracle/case.h"
#include "oracle/subject.h"
#include "oracle/subjects/touchstone/fast.h"
#include "oracle/subjects/touchstone/reference.h"
#include "properties/fuzzing/recipe.h"
#include "properties/property.h"

using namespace touchstone;

namespace {

const std::string query = TOUCHSTONE_FUZZED_QUERY;

struct Subject {
  std::string connectable;
  std::unique_ptr<oracle::Subject> subject;
};

Subject subject_of_query() {
  for (const std::string& answered : oracle::subjects::make_fast()->card().answers) {
    if (answered == query) return {"inproc:fast", oracle::subjects::make_fast()};
  }
  return {"inproc:reference", oracle::subjects::make_reference()};
}

[[noreturn]] void report(const properties::Property& property, const std::string& subject, const Scene& scene,
                         const oracle::Finding& finding) {
  const std::string file = property.id + '.' + name_of(finding.defect) + ".json";
  oracle::write_case({property.id, subject, "", 0, 0, scene, finding, "found by libFuzzer"}, file);
  std::fprintf(stderr, "%s: %s; touchstone replay %s\n", property.id.c_str(), name_of(finding.defect).c_str(),
               file.c_str());
  std::abort();
}

std::size_t copy_back(const std::vector<std::uint8_t>& recipe, std::uint8_t* data) {
  for (std::size_t i = 0; i < recipe.size(); ++i) data[i] = recipe[i];
  return recipe.size();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Subject asked = subject_of_query();
  const Scene scene = properties::fuzzing::scene_of(query, {data, size});
  for (const properties::Property& property : properties::all()) {
    if (property.query != query) continue;
    try {
      const oracle::Finding finding = property.check(scene, *asked.subject);
      if (failed(finding)) report(property, asked.connectable, scene, finding);
    } catch (const InputError&) {  // bad input for the query, as bodies that overlap where a motion begins
    }
  }
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
  std::vector<std::uint8_t> recipe(data, data + size);
  properties::fuzzing::mutate_recipe(recipe, most, seed);
  return copy_back(recipe, data);
}

extern "C" std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* a, std::size_t size_a, const std::uint8_t* b,
                                                 std::size_t size_b, std::uint8_t* out, std::size_t most,
                                                 unsigned seed) {
  return copy_back(properties::fuzzing::crossed({a, size_a}, {b, size_b}, most, seed), out);
}
