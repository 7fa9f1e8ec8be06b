#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <tuple>
#include <vector>

#include "app/report/finding_words.h"
#include "app/report/page/page.h"
#include "app/report/page/picture.h"
#include "app/report/xml.h"
#include "app/trial/questions.h"

namespace touchstone::app::page {
namespace {

constexpr std::size_t shown_at_once = 6;

/// Small for a row that shows an engine's fault well: the verdict, distance or depth of a pair, badly wrong against the
/// truth, with few vertices. Requires a minimised scene.
auto plainness(const Row& row) {
  const properties::Property& property = *row.property;
  const oracle::Size size = oracle::size_of(row.minimised.result->scene);
  return std::tuple(property.query != "distance" && property.query != "penetration", !compares_with_truth(property),
                    -static_cast<int>(*row.grade()), shown_finding(row).observed.empty(),
                    size.vertices_per_body_max + size.significant_bits_max);
}

bool simpler(const Row* a, const Row* b) { return plainness(*a) < plainness(*b); }

const Row* plainest_failure(const Ledger& ledger, const TestedSubject& subject) {
  std::vector<const Row*> rows = ledger.results.of(subject);
  std::erase_if(rows, [](const Row* row) { return !row->minimised.result; });
  const auto best = std::ranges::min_element(rows, simpler);
  return best == rows.end() ? nullptr : *best;
}

std::string glance(const Row& row) {
  std::string facts;
  for (const auto& [label, words] : lines_of(shown_finding(row))) {
    if (label != "outcome") facts += definition(label, shown(words));
  }
  return fmt::format(
      "<section class=\"card\" data-subject=\"{1}\"><h3>{0}{1}</h3><p class=\"soft\">must hold: "
      "{2}</p>{3}<dl>{4}</dl><p><a "
      "href=\"#{5}\">{6}</a></p>"
      "</section>",
      badge(*row.grade()), escaped(row.subject->card.name), escaped(row.property->says), picture(*row.minimised.result),
      facts, anchor(row), escaped(row.property->id));
}

}  // namespace

std::string gallery(const Ledger& ledger) {
  std::vector<const Row*> rows;
  for (const TestedSubject& subject : ledger.subjects) {
    if (const Row* row = plainest_failure(ledger, subject)) rows.push_back(row);
  }
  if (rows.empty()) return "<p>Nothing fails.</p>";
  std::ranges::stable_sort(rows, simpler);
  std::string first, others;
  for (std::size_t r = 0; r < rows.size(); ++r) (r < shown_at_once ? first : others) += glance(*rows[r]);
  if (!others.empty()) {
    others = fmt::format("<details><summary>{} more</summary><div class=\"cards\">{}</div></details>",
                         rows.size() - shown_at_once, others);
  }
  return "<p>Reduced to the smallest scene that still fails, the plainest first. Body A is drawn solid, body B dashed, "
         "the exact closest points as dots; a ring marks a body too small to see. What the subject claims is drawn in "
         "dashes.</p><div class=\"cards\">" +
         first + "</div>" + others;
}

}  // namespace touchstone::app::page
