// The files of a new adapter: adapters/ of the source tree, embedded in the program by CMake.
#pragma once

#include <string>
#include <vector>

namespace touchstone::app {

struct SkeletonFile {
  std::string name, text;
  std::string about;  ///< a few words
};

struct Skeleton {
  std::vector<SkeletonFile> files;
  std::vector<std::string> next;  ///< the commands that build and check the adapter
};

/// The languages in which there are skeletons.
const std::vector<std::string>& adapter_languages();

/// For a language of adapter_languages() and a name of small letters, digits and _. The files are to be written to the
/// folder `name`.
Skeleton skeleton_of(const std::string& language, const std::string& name);

}  // namespace touchstone::app
