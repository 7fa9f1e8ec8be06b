// The folder of the running program, and the folders that are built or installed beside it.
#pragma once

#include <string>
#include <vector>

namespace touchstone::app {

/// The path of this program; it stays valid when a build replaces the file.
std::string program_file();

/// The folder of the subjects' programs: ../subjects in a build, ../libexec/touchstone in an installation.
std::string subjects_folder();

/// The folder of the comparisons' programs. Only a build with benchmarks has it.
std::string benches_folder();

/// The folders that may hold the robot meshes of Debian's dart-doc, in the order in which they are tried.
std::vector<std::string> mesh_folders();

}  // namespace touchstone::app
