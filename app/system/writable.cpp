#include "app/system/writable.h"

#include <unistd.h>

#include <filesystem>

#include "model/input_error.h"

namespace touchstone::app {

namespace fs = std::filesystem;

void require_writable_folder(const std::string& folder, const std::string& place) {
  if (!fs::is_directory(folder)) throw InputError(place, "its folder does not exist");
  if (access(folder.c_str(), W_OK) != 0) throw InputError(place, "its folder is not ours to write in");
}

void require_writable_file(const std::string& file) {
  if (fs::is_directory(file)) throw InputError(file, "is a folder; expected a file's name");
  const bool replaced = !fs::exists(file) || fs::is_regular_file(file);  // devices and pipes are written in place
  if (replaced) return require_writable_folder(fs::absolute(file).parent_path(), file);
  if (access(file.c_str(), W_OK) != 0) throw InputError(file, "is not ours to write to");
}

}  // namespace touchstone::app
