// What a unit found, as JSON that can be read back without loss: shards of a run are merged from it.
#pragma once

#include <string>

#include "app/units/unit.h"
#include "model/json.h"

namespace touchstone::app {

/// Times are left out, since they differ from run to run, and rows without any scene. A scene is not written, but the
/// family and the index of its draw.
Json json_of(const UnitResult& result);

/// Draws the scenes of the unit's examples again. Throws InputError, about `place`, for anything that json_of does not
/// write: another property, a subject that does not exist, a scene that is not of this unit.
UnitResult read_unit(const Json& json, const QueryTrial& query, const Unit& unit, const TestedSubjects& tested,
                     const std::string& place);

}  // namespace touchstone::app
