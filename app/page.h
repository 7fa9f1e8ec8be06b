// The sections of the page for people, as HTML, and the words that they share.
#pragma once

#include <string>

#include "app/ledger.h"
#include "oracle/grade.h"

namespace touchstone::app::page {

/// One failing scene of each engine.
std::string gallery(const Ledger& ledger);

/// Properties × subjects, with the legend of the grades.
std::string table(const Ledger& ledger);

/// A card a subject.
std::string subjects(const Ledger& ledger);

/// How large the errors were, property by property.
std::string errors(const Ledger& ledger);

/// Failing rows, subject by subject; each opens to its smallest failing scene.
std::string failures(const Ledger& ledger);

/// Meshes, kinds of case that were met, and those that were not.
std::string what_was_asked(const Ledger& ledger);

/// Escaped; what is too long for a reader (a list of 300 pairs) is cut.
std::string shown(const std::string& text);

std::string badge(oracle::Grade grade);

/// Where a failing row stands on the page.
std::string anchor(const Row& row);

/// An entry of a <dl>; nothing if there is nothing to say.
std::string definition(const std::string& term, const std::string& html);

/// "1 scene", "2 scenes"
std::string plural(long count, const std::string& noun);

}  // namespace touchstone::app::page
