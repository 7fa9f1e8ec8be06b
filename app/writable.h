// What would spoil the end of a long run is told before it: places that cannot be written to.
#pragma once

#include <string>

namespace touchstone::app {

/// Throws InputError, about `place`, unless files can be made in the folder.
void require_writable_folder(const std::string& folder, const std::string& place);

/// Throws InputError if the file can be neither made nor written over.
void require_writable_file(const std::string& file);

}  // namespace touchstone::app
