// Properties that ask about scenes of their own make valid ones. A subject behind a pipe refuses others, which would
// count against it.
#include "model/input_error.h"
#include "model/limits.h"
#include "oracle/passing_on.h"
#include "oracle/subjects/touchstone/fast.h"
#include "properties/judging/remembered_answers.h"
#include "properties/property.h"
#include "properties/scenes/domain.h"
#include "tests/catch.h"

namespace touchstone::properties {
namespace {

/// Passes valid scenes on, and notes what is wrong with another.
class Validating final : public oracle::PassingOn<Validating> {
 public:
  using PassingOn::PassingOn;
  std::string fault;

 private:
  friend PassingOn;

  template <class T>
  Answer<T> pass(Answer<T> (Subject::*query)(const Scene&), const Scene& scene) {
    try {
      validate(scene);
    } catch (const InputError& error) {
      fault = error.what();
      return Abstains{fault};
    }
    return (subject_.*query)(scene);
  }
};

TEST_CASE("Every property asks about valid scenes alone") {
  const auto fast = oracle::subjects::make_fast();
  for (const std::string& query : tested_queries()) {
    for (const Family* family : for_query(families(), query)) {
      const Scene scene = draw(*family, 1, 0);
      RememberedAnswers answers(*fast);
      for (const Property& property : all()) {
        if (property.query != query) continue;
        Validating subject(answers);
        property.check(scene, subject);
        INFO(property.id << " on " << family->id);
        CHECK(subject.fault == "");
      }
    }
  }
}

}  // namespace
}  // namespace touchstone::properties
