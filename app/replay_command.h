// Command lines that ask a case again, to be pasted into a shell.
#pragma once

#include <optional>
#include <string>

namespace touchstone::app {

/// The word as a POSIX shell reads it back, in single quotes if it needs any.
std::string shell_word(const std::string& word);

/// Runs as printed, from any folder of this machine: program and case by their absolute paths. A subject "exec:..." is
/// named by --subject, since a case file may not (case_commands.h), and runs in this process's folder, which its
/// relative paths are meant in. `time_limit`: where it decides whether the case fails.
std::string replay_command(const std::string& case_file, const std::string& connectable,
                           std::optional<double> time_limit = {});

}  // namespace touchstone::app
