#include "app/fuzz/enlarge.h"

#include <nlopt.h>

#include <cmath>
#include <memory>
#include <span>
#include <vector>

#include "app/fuzz/scene_numbers.h"
#include "app/system/interruption.h"
#include "app/trial/domain_watch.h"
#include "model/input_error.h"
#include "oracle/minimise/scene_edit.h"
#include "properties/fuzzing/complete.h"

namespace touchstone::app {
namespace {

using oracle::Finding;
using properties::Property;

constexpr double without_error = -1100;  ///< less than log2 of any double

class ErrorSearch {
 public:
  ErrorSearch(const Example& example, const Property& property, oracle::Subject& subject)
      : best_(example), property_(property), subject_(subject) {}

  void run(double step, int budget) {
    completed_ = best_.scene;
    Scene scene = best_.scene;
    oracle::drop_faces(scene);
    const std::vector<SceneNumber> numbers = numbers_of(scene);
    std::vector<double> x, steps;
    for (const SceneNumber& number : numbers) {
      x.push_back(*number.value);
      steps.push_back(step * number.scale);
    }
    scene_ = &scene;
    numbers_ = &numbers;
    const std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)> method(
        nlopt_create(NLOPT_LN_SBPLX, static_cast<unsigned>(x.size())), nlopt_destroy);
    nlopt_set_max_objective(method.get(), error_at, this);
    nlopt_set_initial_step(method.get(), steps.data());
    nlopt_set_maxeval(method.get(), budget);
    double greatest = 0;
    nlopt_optimize(method.get(), x.data(), &greatest);  // what it found is in best_
  }

  bool is_larger() const { return is_larger_; }
  const Example& best() const { return best_; }

 private:
  static double error_at(unsigned n, const double* x, double* /*gradient*/, void* search) {
    return static_cast<ErrorSearch*>(search)->error_at({x, n});
  }

  /// log2 of the error.
  double error_at(std::span<const double> x) {
    if (interrupted()) return without_error;
    const bool in_floats = subject_.card().precision == oracle::Precision::binary32;
    for (std::size_t i = 0; i < x.size(); ++i) {
      *(*numbers_)[i].value = in_floats ? static_cast<double>(static_cast<float>(x[i])) : x[i];
    }
    try {
      const Scene scene = properties::fuzzing::completed_after(*scene_, completed_, completed_);
      DomainWatch watch(subject_);
      const Finding finding = property_.check(scene, watch);
      const bool has_size = finding.outcome == oracle::Outcome::holds || finding.outcome == oracle::Outcome::fails;
      if (!has_size || !watch.beyond().empty() || finding.unit != best_.finding.unit) return without_error;
      if (finding.outcome == oracle::Outcome::fails && finding.error > best_.finding.error) {
        best_.scene = scene;
        best_.finding = finding;
        is_larger_ = true;
      }
      return finding.error > 0 ? std::log2(finding.error) : without_error;
    } catch (const InputError&) {
      return without_error;
    }
  }

  Example best_;
  const Property& property_;
  oracle::Subject& subject_;
  Scene completed_;         ///< the best scene before this run
  Scene* scene_ = nullptr;  ///< its numbers are the ones that change
  const std::vector<SceneNumber>* numbers_ = nullptr;
  bool is_larger_ = false;
};

}  // namespace

std::optional<Example> enlarged(const Example& example, const Property& property, oracle::Subject& subject,
                                int budget) {
  ErrorSearch search(example, property, subject);
  for (const double step : {0x1p-3, 0x1p-12, 0x1p-24}) search.run(step, budget / 3);
  return search.is_larger() ? std::optional(search.best()) : std::nullopt;
}

}  // namespace touchstone::app
