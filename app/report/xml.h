// Escapes text for XML and HTML.
#pragma once

#include <string>
#include <string_view>

namespace touchstone::app {

/// Escapes &, <, > and ", after making the text printable (model/printable.h), since XML 1.0 cannot contain most
/// characters that are not.
std::string escaped(std::string_view text);

}  // namespace touchstone::app
