#include "app/trial/row.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "app/trial/fault_size.h"
#include "oracle/tolerance/tolerance.h"

namespace touchstone::app {
namespace {

using oracle::Grade;
using oracle::Outcome;

bool has_size(const oracle::Finding& finding) { return !finding.unit.empty() && finding.allowed > 0; }

bool closer(const Example& a, const Example& b) { return excess(a.finding) > excess(b.finding); }

bool worse(const Example& a, const Example& b) {
  return std::pair(oracle::grade(a.finding), excess(a.finding)) >
         std::pair(oracle::grade(b.finding), excess(b.finding));
}

/// Scenes of a usual size: a counterexample of 1e-18 m only shows that an engine has an absolute epsilon.
bool in_usual_units(const Scene& scene) {
  const double scale = oracle::tolerance::scale(scene);
  return 1e-3 <= scale && scale <= 1e3;
}

/// Three decimal digits of the fault beside its scene. (The examples of a row are of one subject, so its precision
/// changes no order.)
int digits_of_fault(const Example& example) {
  const double size = fault_size(example.finding, example.scene, oracle::Precision::binary64).over_scene;
  return size > 0 && std::isfinite(size) ? static_cast<int>(std::floor(std::log2(size) / 10)) : -1000;
}

/// Is `a` a better start for the minimiser? Usual units first, then a fault that can be measured, then the worse grade,
/// then the larger fault beside its scene, then the smaller scene.
bool handier(const Example& a, const Example& b) {
  const auto rank = [](const Example& example) {
    const oracle::Size size = oracle::size_of(example.scene);
    return std::tuple(!in_usual_units(example.scene), !is_measurable(example.finding, oracle::Precision::binary64),
                      -static_cast<int>(oracle::grade(example.finding)), -digits_of_fault(example), size.bodies,
                      size.vertices_per_body_max, size.significant_bits_max);
  };
  return rank(a) < rank(b);
}

/// Errors in different units are not compared: the first unit of the row counts.
void widen(LargestError& largest, const LargestError& other) {
  if (other.unit.empty() || (!largest.unit.empty() && other.unit != largest.unit)) return;
  largest.size = std::max(largest.size, other.size);
  largest.unit = other.unit;
}

void worsen(std::map<oracle::Defect, Grade>& worst, oracle::Defect defect, Grade grade) {
  Grade& known = worst.try_emplace(defect, grade).first->second;
  known = std::max(known, grade);
}

/// Requires a failure.
long& count_of(const oracle::Finding& finding, Counts& counts) {
  if (finding.outcome == Outcome::fails) return counts.fails;
  return finding.defect == oracle::Defect::refused ? counts.refused : counts.breaks;
}

void keep(std::optional<Example>& kept, const Example& candidate, bool (*better)(const Example&, const Example&)) {
  if (!kept || better(candidate, *kept)) kept = candidate;
}

}  // namespace

void Row::count(const Example& example) {
  const Outcome outcome = example.finding.outcome;
  if (outcome == Outcome::outside) {
    ++counts.outside;
    return;
  }
  if (outcome == Outcome::abstains) {
    ++counts.abstains;
    if (why_abstains.empty()) why_abstains = example.finding.why;
    return;
  }
  ++grades[static_cast<std::size_t>(oracle::grade(example.finding))];
  counts.impacts += example.finding.impacts;
  errors.count(example.finding);
  if (outcome == Outcome::holds) {
    ++counts.holds;
    if (has_size(example.finding)) keep(examples.closest, example, closer);
    return;
  }
  ++count_of(example.finding, counts);
  ++defects[example.finding.defect];
  worsen(worst_grades, example.finding.defect, oracle::grade(example.finding));
  widen(largest_error, {example.finding.error, example.finding.unit});
  keep(examples.worst, example, worse);
  keep(examples.smallest, example, handier);
}

Counts& Counts::operator+=(const Counts& more) {
  holds += more.holds;
  fails += more.fails;
  abstains += more.abstains;
  breaks += more.breaks;
  refused += more.refused;
  outside += more.outside;
  not_asked += more.not_asked;
  unanswered += more.unanswered;
  beyond += more.beyond;
  impacts += more.impacts;
  return *this;
}

void Row::merge(const Row& later) {
  counts += later.counts;
  for (std::size_t g = 0; g < grades.size(); ++g) grades[g] += later.grades[g];
  for (const auto& [defect, count] : later.defects) defects[defect] += count;
  for (const auto& [defect, grade] : later.worst_grades) worsen(worst_grades, defect, grade);
  if (why_abstains.empty()) why_abstains = later.why_abstains;
  errors.merge(later.errors);
  widen(largest_error, later.largest_error);
  if (later.examples.closest) keep(examples.closest, *later.examples.closest, closer);
  if (later.examples.worst) keep(examples.worst, *later.examples.worst, worse);
  if (later.examples.smallest) keep(examples.smallest, *later.examples.smallest, handier);
}

void Row::forget() {
  Row blank;
  blank.property = property;
  blank.subject = subject;
  blank.counts.not_asked = counts.all();
  *this = std::move(blank);
}

std::optional<Grade> Row::grade() const {
  std::optional<Grade> worst;
  for (std::size_t g = 0; g < grades.size(); ++g) {
    if (grades[g] > 0) worst = static_cast<Grade>(g);
  }
  if (worst && minimised.result && failed(minimised.result->finding)) {
    worst = std::max(*worst, oracle::grade(minimised.result->finding));
  }
  return worst;
}

const oracle::Finding& shown_finding(const Row& row) {
  return row.minimised.result ? row.minimised.result->finding : row.examples.worst->finding;
}

std::string percent(long some, long all) {
  const double share = 100 * static_cast<double>(some) / static_cast<double>(all);
  return share < 1 ? fmt::format("{:.2g} %", share) : fmt::format("{:.0f} %", some < all ? std::min(share, 99.0) : 100);
}

std::string share_of(const Row& row) {
  const std::string share =
      fmt::format("{} of {} fail ({})", row.failures(), row.answered(), percent(row.failures(), row.answered()));
  return row.counts.refused > 0 ? fmt::format("{}, {} of them refused", share, row.counts.refused) : share;
}

std::string text_of(const oracle::Size& size) {
  const auto counted = [](int n, const char* one, const char* many) {
    return fmt::format("{} {}", n, n == 1 ? one : many);
  };
  return fmt::format("{}, at most {} a body and {}", counted(size.bodies, "body", "bodies"),
                     counted(size.vertices_per_body_max, "vertex", "vertices"),
                     counted(size.significant_bits_max, "significant bit", "significant bits"));
}

}  // namespace touchstone::app
