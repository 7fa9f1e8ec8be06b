// Creates the subject that a user names.
#include <wordexp.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "model/input_error.h"
#include "model/near_names.h"
#include "oracle/process/pipe.h"

namespace touchstone::oracle {
namespace {

constexpr std::string_view exec_prefix = "exec:";
constexpr std::string_view by_name = "by_name";  // subjects whose hangs or crashes would dominate a run
constexpr std::string_view program_prefix = "touchstone-subject-";

/// WRDE_NOCMD: words and quotes are expanded, but no command is run while they are read.
std::vector<std::string> words_of(const std::string& command_line) {
  wordexp_t expanded{};
  const int error = wordexp(command_line.c_str(), &expanded, WRDE_NOCMD);
  if (error == WRDE_NOSPACE) throw std::bad_alloc();
  if (error != 0) throw InputError("exec:" + command_line, "not a plain command line: quote what a shell would read");
  const std::vector<std::string> words(expanded.we_wordv, expanded.we_wordv + expanded.we_wordc);
  wordfree(&expanded);
  if (words.empty()) throw InputError("exec:", "expected a command line");
  return words;
}

}  // namespace

std::vector<std::string> subjects_beside(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code no_folder;
  for (const auto& entry : std::filesystem::directory_iterator(folder, no_folder)) {
    const std::string file = entry.path().filename().string();
    if (file.starts_with(program_prefix)) names.push_back(file.substr(program_prefix.size()));
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::unique_ptr<Subject> connect(const std::string& connectable, const std::string& folder, PipeLimits limits) {
  if (connectable.starts_with(exec_prefix)) {
    return std::make_unique<PipeSubject>(words_of(connectable.substr(exec_prefix.size())), limits);
  }
  std::vector<std::string> known;
  for (const std::filesystem::path& place : {std::filesystem::path(folder), std::filesystem::path(folder) / by_name}) {
    for (const std::string& name : subjects_beside(place.string())) {
      if (name != connectable) {
        known.push_back(name);
        continue;
      }
      const std::string program = (place / (std::string(program_prefix) + name)).string();
      return std::make_unique<PipeSubject>(std::vector<std::string>{program}, limits);
    }
  }
  known.emplace_back("exec:COMMAND LINE");
  throw InputError("subject \"" + connectable + '"', unknown_among(connectable, known));
}

}  // namespace touchstone::oracle
