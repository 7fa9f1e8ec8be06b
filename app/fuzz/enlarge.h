// Makes an error larger: a search without derivatives over the numbers of the scene that shows it.
#pragma once

#include <optional>

#include "app/trial/row.h"
#include "oracle/subject.h"
#include "properties/property.h"

namespace touchstone::app {

/// The example with the largest error that the search found, of the same property, in its unit; none if it found no
/// larger one. The search is NLopt's Subplex method (Rowan 1990), first with steps of an eighth of what a number
/// belongs to, then of 2^-12 and 2^-24 of it, with a third of the `budget` of questions each, always from the best
/// scene so far. A scene that is not valid, outside the domain that the card declares, or not answered, counts as one
/// without an error. Deterministic. Requires an example whose error has a size.
std::optional<Example> enlarged(const Example& example, const properties::Property& property, oracle::Subject& subject,
                                int budget);

}  // namespace touchstone::app
