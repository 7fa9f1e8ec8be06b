// The sections of the HTML page, and the words that they share.
#pragma once

#include <string>

#include "app/trial/ledger.h"
#include "oracle/judge/grade.h"

namespace touchstone::app::page {

/// Subjects × queries: how many properties hold, how many answers fail.
std::string matrix(const Ledger& ledger);

/// One failing scene of each engine, the plainest first.
std::string gallery(const Ledger& ledger);

/// For each query its properties × the subjects that answer it, with the legend of the grades.
std::string tables(const Ledger& ledger);

/// One card per subject.
std::string subjects(const Ledger& ledger);

/// The distribution of the errors, property by property.
std::string errors(const Ledger& ledger);

/// Error against CPU time, query by query: the only part of the page that differs from run to run.
std::string speed(const Ledger& ledger);

/// Heat maps: outcomes by the sizes of the scenes, with the domains that cards declare.
std::string atlas(const Ledger& ledger);

/// What the plans of the scenes leave out.
std::string left_out(const Ledger& ledger);

/// Failing rows, subject by subject; each row opens to its smallest failing scene.
std::string failures(const Ledger& ledger);

/// The meshes, the classes of cases that occurred, and those that did not.
std::string what_was_asked(const Ledger& ledger);

/// Escapes a text and cuts it if it is too long for a reader (a list of 300 pairs).
std::string shown(const std::string& text);

std::string badge(oracle::Grade grade);

/// The anchor of a failing row on the page.
std::string anchor(const Row& row);

/// The anchor of a subject's card.
std::string subject_anchor(const TestedSubject& subject);

/// The anchor of a subject's failing rows.
std::string failures_anchor(const TestedSubject& subject);

/// The anchor of a query's table.
std::string table_anchor(const std::string& query);

/// Why the scenes of rows that are not answered were not: "abstains", "beyond its domain", "no answer",
/// "not asked" or "outside".
std::string silence_of(const Counts& counts);

/// Escapes a name that may be broken into lines after each underscore.
std::string breakable(const std::string& name);

/// An entry of a <dl>; empty if the text is empty.
std::string definition(const std::string& term, const std::string& html);

/// What may be wider than the screen, as a region of its own that scrolls and that the keyboard reaches.
std::string scrolling(const std::string& label, const std::string& html);

/// "1 scene", "2 scenes"
std::string plural(long count, const std::string& noun);

}  // namespace touchstone::app::page
