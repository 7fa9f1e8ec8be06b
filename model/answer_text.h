// The text of a subject's answer.
#pragma once

#include <string>
#include <string_view>

#include "model/json.h"

namespace touchstone {

/// Does what `parse` (model/json.h) does, but reads an integer that no double equals as the nearest double. A scene
/// means exactly its numbers; an answer was computed in doubles, and JavaScript writes one from 2^53 to 10^21 as its
/// shortest digits and zeros: 2^69 is 590295810358705700000.
Json parse_answer(std::string_view line, const std::string& place);

}  // namespace touchstone
