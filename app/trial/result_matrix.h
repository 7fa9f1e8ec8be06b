// The results of a run: a matrix of rows (app/trial/row.h) by property and subject.
#pragma once

#include <span>
#include <vector>

#include "app/trial/row.h"

namespace touchstone::app {

class ResultMatrix {
 public:
  using Properties = std::vector<const properties::Property*>;

  /// An empty row for each property and each subject. The matrix points to both, which must outlive it.
  ResultMatrix(Properties tested, const std::vector<TestedSubject>& subjects);

  const Properties& tested_properties() const { return properties_; }

  /// The tested properties, query by query.
  std::vector<Properties> by_query() const;

  /// Throws std::out_of_range if the property or the subject is not of this matrix.
  Row& at(const properties::Property& property, const TestedSubject& subject);

  /// The rows of a property, subject by subject. Throws std::out_of_range if the property is not of this matrix.
  std::span<const Row> of(const properties::Property& property) const;

  /// The rows of a subject, property by property.
  std::vector<const Row*> of(const TestedSubject& subject) const;

  /// All rows, property by property.
  std::span<Row> all() { return rows_; }
  std::span<const Row> all() const { return rows_; }

  /// Adds a later part of the run: the same subjects, and some of the properties.
  void merge(const ResultMatrix& later);

  /// As if the subject had not been asked.
  void forget(const TestedSubject& subject);

 private:
  std::size_t first_row(const properties::Property& property) const;

  Properties properties_;
  std::size_t subjects_;
  std::vector<Row> rows_;  ///< of subject s under property p: p · subjects + s
};

}  // namespace touchstone::app
