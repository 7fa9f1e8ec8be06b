#include "app/ledger.h"

#include <tuple>
#include <utility>

namespace touchstone::app {
namespace {

using oracle::Grade;
using oracle::Outcome;

double excess(const oracle::Finding& finding) { return finding.error / (finding.allowed > 0 ? finding.allowed : 1); }

bool worse(const Example& a, const Example& b) {
  return std::pair(oracle::grade(a.finding), excess(a.finding)) >
         std::pair(oracle::grade(b.finding), excess(b.finding));
}

/// A better start for the minimiser: as bad, and smaller.
bool handier(const Example& a, const Example& b) {
  const auto cost = [](const Example& example) {
    const oracle::Size size = oracle::size_of(example.scene);
    return std::tuple(size.bodies, size.vertices_per_body_max, size.significant_bits_max);
  };
  const Grade grade_a = oracle::grade(a.finding);
  const Grade grade_b = oracle::grade(b.finding);
  return grade_a != grade_b ? grade_a > grade_b : cost(a) < cost(b);
}

void keep(std::optional<Example>& kept, const Example& candidate, bool (*better)(const Example&, const Example&)) {
  if (!kept || better(candidate, *kept)) kept = candidate;
}

}  // namespace

void Row::count(Example example) {
  const Outcome outcome = example.finding.outcome;
  if (outcome == Outcome::outside) {
    ++outside;
    return;
  }
  if (outcome == Outcome::abstains) {
    ++abstains;
    if (why_abstains.empty()) why_abstains = example.finding.why;
    return;
  }
  ++grades[static_cast<std::size_t>(oracle::grade(example.finding))];
  if (outcome == Outcome::holds) {
    ++holds;
    return;
  }
  ++(outcome == Outcome::fails ? fails : breaks);
  ++defects[example.finding.defect];
  keep(worst, example, worse);
  keep(smallest, example, handier);
}

void Row::merge(Row later) {
  holds += later.holds;
  fails += later.fails;
  abstains += later.abstains;
  breaks += later.breaks;
  outside += later.outside;
  not_asked += later.not_asked;
  for (std::size_t g = 0; g < grades.size(); ++g) grades[g] += later.grades[g];
  for (const auto& [defect, count] : later.defects) defects[defect] += count;
  if (why_abstains.empty()) why_abstains = later.why_abstains;
  if (later.worst) keep(worst, *later.worst, worse);
  if (later.smallest) keep(smallest, *later.smallest, handier);
}

std::optional<Grade> Row::grade() const {
  for (std::size_t g = grades.size(); g-- > 0;) {
    if (grades[g] > 0) return static_cast<Grade>(g);
  }
  return std::nullopt;
}

}  // namespace touchstone::app
