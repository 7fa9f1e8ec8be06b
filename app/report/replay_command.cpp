#include "app/report/replay_command.h"

#include <fmt/format.h>

#include <filesystem>

#include "app/system/program_folder.h"

namespace touchstone::app {

namespace fs = std::filesystem;

std::string shell_word(const std::string& word) {
  constexpr const char* plain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_./-+:,@%";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char c : word) {
    if (c == '\'') {
      quoted += R"('\'')";
    } else {
      quoted += c;
    }
  }
  return quoted + '\'';
}

std::string folder_of(const std::string& connectable) {
  return connectable.starts_with("exec:") ? fs::current_path().string() : "";
}

std::string replay_command(const std::string& case_file, const std::string& connectable,
                           std::optional<double> time_limit) {
  std::string command =
      fmt::format("{} replay {}", shell_word(program_file()), shell_word(fs::absolute(case_file).string()));
  if (time_limit) command += fmt::format(" --time-limit {}", *time_limit);
  const std::string folder = folder_of(connectable);
  if (folder.empty()) return command;
  return fmt::format("(cd {} && {} --subject {})", shell_word(folder), command, shell_word(connectable));
}

}  // namespace touchstone::app
