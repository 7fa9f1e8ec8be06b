#include <fmt/format.h>

#include <tuple>
#include <utility>

#include "app/report/finding_words.h"
#include "app/report/page.h"
#include "app/report/picture.h"
#include "app/report/xml.h"
#include "app/trial/questions.h"

namespace touchstone::app::page {
namespace {

/// The row that shows an engine's fault best: the verdict, distance or depth of a pair, badly wrong against the truth,
/// with few vertices.
const Row* plainest_failure(const Ledger& ledger, const TestedSubject& subject) {
  const auto rank = [](const Row& row) {
    const properties::Property& property = *row.property;
    const oracle::Size size = oracle::size_of(row.minimised.result->scene);
    return std::tuple(property.query != "distance" && property.query != "penetration", !compares_with_truth(property),
                      -static_cast<int>(*row.grade()), shown_finding(row).observed.empty(),
                      size.vertices_per_body_max + size.significant_bits_max);
  };
  const Row* best = nullptr;
  for (const Row* row : ledger.results.of(subject)) {
    if (row->minimised.result && (best == nullptr || rank(*row) < rank(*best))) best = row;
  }
  return best;
}

std::string glance(const Row& row) {
  std::string facts;
  for (const auto& [label, words] : lines_of(shown_finding(row))) {
    if (label != "outcome") facts += definition(label, shown(words));
  }
  return fmt::format(
      "<section class=\"card\"><h3>{}{}</h3><p class=\"soft\">must hold: {}</p>{}<dl>{}</dl><p><a "
      "href=\"#{}\">{}</a></p>"
      "</section>",
      badge(*row.grade()), escaped(row.subject->card.name), escaped(row.property->says),
      picture(row.minimised.result->scene), facts, anchor(row), escaped(row.property->id));
}

}  // namespace

std::string gallery(const Ledger& ledger) {
  std::string cards;
  for (const TestedSubject& subject : ledger.subjects) {
    if (const Row* row = plainest_failure(ledger, subject)) cards += glance(*row);
  }
  if (cards.empty()) return "<p>Nothing fails.</p>";
  return "<p>One failing scene of each engine, reduced to the smallest that still fails. Body A is drawn solid, body "
         "B dashed, "
         "the exact closest points as dots; a ring marks a body too small to see.</p><div class=\"cards\">" +
         cards + "</div>";
}

}  // namespace touchstone::app::page
