#include "app/system/program_folder.h"

#include <filesystem>

namespace touchstone::app {
namespace {

namespace fs = std::filesystem;

fs::path base_folder() { return fs::read_symlink("/proc/self/exe").parent_path().parent_path(); }

}  // namespace

std::string program_file() { return (base_folder() / "bin" / "touchstone").string(); }

std::string subjects_folder() {
  const fs::path built = base_folder() / "subjects";
  return (fs::is_directory(built) ? built : base_folder() / "libexec" / "touchstone").string();
}

std::string benches_folder() { return (base_folder() / "tests" / "bench").string(); }

std::vector<std::string> mesh_folders() {
  return {(base_folder() / "dart-doc" / "usr/share/doc/dart/data").string(), "/usr/share/doc/dart/data"};
}

}  // namespace touchstone::app
