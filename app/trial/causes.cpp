#include "app/trial/causes.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <map>
#include <utility>

namespace touchstone::app {
namespace {

bool is_digit(const std::string& words, std::size_t at) {
  return at < words.size() && std::isdigit(static_cast<unsigned char>(words[at])) != 0;
}

/// The end of the number that begins with the digit at `at`: 17, 0.5, 1e-05.
std::size_t end_of_number(const std::string& words, std::size_t at) {
  const auto skip_digits = [&] {
    while (is_digit(words, at)) ++at;
  };
  skip_digits();
  if (at < words.size() && words[at] == '.' && is_digit(words, at + 1)) {
    ++at;
    skip_digits();
  }
  if (at < words.size() && (words[at] == 'e' || words[at] == 'E')) {
    const bool sign = at + 1 < words.size() && (words[at + 1] == '-' || words[at + 1] == '+');
    if (is_digit(words, at + (sign ? 2 : 1))) {
      at += sign ? 2 : 1;
      skip_digits();
    }
  }
  return at;
}

}  // namespace

std::string without_numbers(const std::string& words) {
  std::string same;
  for (std::size_t at = 0; at < words.size();) {
    if (is_digit(words, at + (words[at] == '-' ? 1 : 0))) {
      at = end_of_number(words, at + (words[at] == '-' ? 1 : 0));
      same += '#';
    } else {
      same += words[at++];
    }
  }
  return same;
}

std::vector<Cause> causes(const ResultMatrix& results, const TestedSubject& subject) {
  std::vector<Cause> all;
  std::map<std::pair<oracle::Defect, std::string>, std::size_t> known;  // break -> index into `all`
  for (const Row* row : results.of(subject)) {
    if (!row->failing()) continue;
    const oracle::Finding& finding = shown_finding(*row);
    const auto next = all.size();
    const bool breaks = finding.outcome == oracle::Outcome::breaks;
    const std::size_t at =
        breaks ? known.try_emplace({finding.defect, without_numbers(finding.why)}, next).first->second : next;
    if (at == next) all.push_back({&subject, {}});
    all[at].rows.push_back(row);
  }
  return all;
}

std::vector<Cause> causes(const Ledger& ledger) {
  std::vector<Cause> all;
  for (const TestedSubject& subject : ledger.subjects)
    std::ranges::move(causes(ledger.results, subject), std::back_inserter(all));
  return all;
}

}  // namespace touchstone::app
