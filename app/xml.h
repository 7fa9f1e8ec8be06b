// Text inside XML and HTML.
#pragma once

#include <string>
#include <string_view>

namespace touchstone::app {

/// &, <, > and " escaped, after what is not printable (model/printable.h): XML 1.0 has no way to write most of that.
std::string escaped(std::string_view text);

}  // namespace touchstone::app
