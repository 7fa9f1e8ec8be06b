// Where the running program stands, and what was built or installed beside it.
#pragma once

#include <string>
#include <vector>

namespace touchstone::app {

/// This program itself, also after a build has put another one in its place.
std::string program_file();

/// The folder of the subjects' programs: ../subjects in a build, ../libexec/touchstone in an installation.
std::string subjects_folder();

/// The folder of the comparisons' programs, which only a build with benchmarks has.
std::string benches_folder();

/// Where the robot meshes of Debian's dart-doc may be, in the order in which they are looked for.
std::vector<std::string> mesh_folders();

}  // namespace touchstone::app
