// Checks before a long run that its results can be written.
#pragma once

#include <string>

namespace touchstone::app {

/// Throws InputError, about `place`, unless files can be created in the folder.
void require_writable_folder(const std::string& folder, const std::string& place);

/// Throws InputError if the file can be neither created nor overwritten.
void require_writable_file(const std::string& file);

}  // namespace touchstone::app
