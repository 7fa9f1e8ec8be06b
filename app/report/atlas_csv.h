// The stability atlas as a table for programs.
#pragma once

#include <string>

#include "app/trial/ledger.h"

namespace touchstone::app {

/// query,subject,axis,unit,above,up_to,scenes,failing,broken,largest_error_over_allowed,declared: a line for each
/// class in which a subject answered; `declared` says whether the class is inside, across or outside the domain that
/// its card declares.
std::string atlas_csv(const Ledger& ledger);

/// "inside", "across" or "outside"
std::string name_of(DomainSide side);

}  // namespace touchstone::app
