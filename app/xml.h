// Text inside XML and HTML.
#pragma once

#include <string>
#include <string_view>

namespace touchstone::app {

/// &, <, > and " escaped; characters that XML 1.0 does not know are replaced by a question mark.
std::string escaped(std::string_view text);

}  // namespace touchstone::app
