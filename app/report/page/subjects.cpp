#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <map>
#include <vector>

#include "app/report/page/page.h"
#include "app/report/xml.h"
#include "oracle/process/protocol.h"

namespace touchstone::app::page {
namespace {

using oracle::Grade;

struct Summary {
  int hold = 0;
  int fail = 0;
  int silent = 0;
  std::array<long, oracle::grade_count> grades{};
  const Row* most_wrong = nullptr;                          ///< in ulps of the scene's scale
  std::map<std::string, std::vector<std::string>> silence;  ///< reason -> properties
};

Summary summary_of(const Ledger& ledger, const TestedSubject& subject) {
  Summary summary;
  for (const Row* row : ledger.results.of(subject)) {
    ++(row->failing() ? summary.fail : row->counts.holds > 0 ? summary.hold : summary.silent);
    for (std::size_t g = 0; g < row->grades.size(); ++g) summary.grades[g] += row->grades[g];
    if (row->answered() == 0 && row->counts.abstains > 0)
      summary.silence[row->why_abstains].push_back(row->property->id);
    if (row->largest_error.unit == "ulps of the scene's scale" &&
        (summary.most_wrong == nullptr || row->largest_error.size > summary.most_wrong->largest_error.size)) {
      summary.most_wrong = row;
    }
  }
  return summary;
}

std::string grades(const Summary& summary) {
  std::string bar;
  std::string tally;
  for (std::size_t g = 0; g < summary.grades.size(); ++g) {
    const std::string name = oracle::name_of(static_cast<Grade>(g));
    if (summary.grades[g] > 0)
      bar += fmt::format("<i class=\"{}\" style=\"flex:{} 1 2px\"></i>", name, summary.grades[g]);
    tally += fmt::format("<li>{}{}</li>", badge(static_cast<Grade>(g)), summary.grades[g]);
  }
  return fmt::format("<div class=\"bar\" aria-hidden=\"true\">{}</div><ul class=\"tally\">{}</ul>", bar, tally);
}

std::string silences(const Summary& summary) {
  if (summary.silence.empty()) return "";
  std::string html = fmt::format("<details><summary>Abstains from {}</summary><ul>", plural(summary.silent, "row"));
  for (const auto& [why, ids] : summary.silence) {
    html += fmt::format("<li>{}: {}</li>", escaped(why), escaped(fmt::format("{}", fmt::join(ids, ", "))));
  }
  return html + "</ul></details>";
}

std::string deviations(const oracle::Card& card) {
  if (card.deviations.empty()) return "";
  std::string html = "<p>Known deviations, which do not excuse a failure:</p><ul>";
  for (const oracle::Deviation& known : card.deviations) {
    html += "<li>" + escaped(known.what);
    if (known.link.starts_with("http")) html += fmt::format(" (<a href=\"{}\">issue</a>)", escaped(known.link));
    html += "</li>";
  }
  return html + "</ul>";
}

/// A line of the card in the words of the protocol, if it declares anything.
std::string line_of(const char* what, const Json& declared) {
  return declared.empty() ? "" : fmt::format("<p>{}: <code>{}</code></p>", what, escaped(declared.dump()));
}

std::string declared(const oracle::Card& card) {
  namespace protocol = oracle::protocol;
  std::string html = line_of("Declared domain", protocol::json_of(card.domain));
  if (const auto& d = card.distance_tolerance; !(d == oracle::DistanceTolerance{})) {
    html += fmt::format(
        "<p>Declared tolerance of distances: {:.3g} m + {:.3g} times the distance; slop {:.3g} m, margin {:.3g} m a "
        "body</p>",
        d.absolute, d.relative, d.slop, d.margin);
  }
  if (const auto& d = card.contact_tolerance; !(d == oracle::ContactTolerance{})) {
    html += fmt::format(
        "<p>Declared tolerance of contacts: {:.3g} m + {:.3g} times the thinnest body + {:.3g} times the way</p>",
        d.absolute, d.size, d.way);
  }
  if (card.boxes == oracle::BoxKind::of_turned_box) html += "<p>Its boxes are those of turned local boxes</p>";
  if (card.boxes == oracle::BoxKind::of_ball) html += "<p>Its boxes are at most those of balls about local boxes</p>";
  html += line_of("Declared precision of parts", protocol::json_of(card.precision_of));
  html += line_of("Declared dynamics", protocol::json_of(card.dynamics));
  if (card.stepping)
    html += fmt::format("<p>Steps of {:.3g} s, order {}</p>", card.stepping->step, card.stepping->order);
  return html;
}

std::string subject_card(const Ledger& ledger, const TestedSubject& subject) {
  const oracle::Card& card = subject.card;
  const Summary summary = summary_of(ledger, subject);
  std::string html = fmt::format(
      "<section class=\"card\" id=\"{0}\" data-subject=\"{1}\"><h3>{1} <small>{2}</small></h3><p>{3} of its rows hold, "
      "{4}, {5} say nothing</p>",
      subject_anchor(subject), escaped(card.name), escaped(card.version), summary.hold,
      summary.fail == 0 ? "none fails"
                        : fmt::format("<a href=\"#{}\">{} fail</a>", failures_anchor(subject), summary.fail),
      summary.silent);
  html += grades(summary);
  if (summary.most_wrong != nullptr) {
    html += fmt::format("<p>Largest error: {:.3g} {} ({})</p>", summary.most_wrong->largest_error.size,
                        escaped(summary.most_wrong->largest_error.unit), escaped(summary.most_wrong->property->id));
  }
  return html + fmt::format("<p class=\"soft\">{}</p>", escaped(card.about)) + declared(card) + deviations(card) +
         silences(summary) + "</section>";
}

}  // namespace

std::string subjects(const Ledger& ledger) {
  std::string html = "<div class=\"cards\">";
  for (const TestedSubject& subject : ledger.subjects) html += subject_card(ledger, subject);
  return html + "</div>";
}

}  // namespace touchstone::app::page
