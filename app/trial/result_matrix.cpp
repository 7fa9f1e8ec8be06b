#include "app/trial/result_matrix.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace touchstone::app {

ResultMatrix::ResultMatrix(Properties tested, const std::vector<TestedSubject>& subjects)
    : properties_(std::move(tested)), subjects_(subjects.size()) {
  rows_.reserve(properties_.size() * subjects_);
  for (const properties::Property* property : properties_) {
    for (const TestedSubject& subject : subjects) {
      Row& row = rows_.emplace_back();
      row.property = property;
      row.subject = &subject;
    }
  }
}

std::vector<ResultMatrix::Properties> ResultMatrix::by_query() const {
  std::vector<Properties> queries;
  for (const properties::Property* property : properties_) {
    if (queries.empty() || queries.back().front()->query != property->query) queries.emplace_back();
    queries.back().push_back(property);
  }
  return queries;
}

Row& ResultMatrix::at(const properties::Property& property, const TestedSubject& subject) {
  Row& row = rows_.at(first_row(property) + subject.index);
  if (row.subject != &subject) throw std::out_of_range(subject.card.name + " is not a subject of this matrix");
  return row;
}

std::span<const Row> ResultMatrix::of(const properties::Property& property) const {
  return all().subspan(first_row(property), subjects_);
}

std::vector<const Row*> ResultMatrix::of(const TestedSubject& subject) const {
  std::vector<const Row*> rows;
  for (const Row& row : rows_) {
    if (row.subject == &subject) rows.push_back(&row);
  }
  return rows;
}

void ResultMatrix::merge(const ResultMatrix& later) {
  for (const Row& row : later.rows_) at(*row.property, *row.subject).merge(row);
}

void ResultMatrix::forget(const TestedSubject& subject) {
  for (Row& row : rows_) {
    if (row.subject == &subject) row.forget();
  }
}

std::size_t ResultMatrix::first_row(const properties::Property& property) const {
  const auto found = std::ranges::find(properties_, &property);
  if (found == properties_.end()) throw std::out_of_range(property.id + " is not a property of this matrix");
  return static_cast<std::size_t>(found - properties_.begin()) * subjects_;
}

}  // namespace touchstone::app
