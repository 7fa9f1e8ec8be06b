// Command lines that replay a case, to be pasted into a shell.
#pragma once

#include <optional>
#include <string>

namespace touchstone::app {

/// Quotes a word for a POSIX shell, in single quotes if it needs any.
std::string shell_word(const std::string& word);

/// For the case of a subject "exec:...": this process's folder, to which its relative paths refer. Else empty.
std::string folder_of(const std::string& connectable);

/// A command that runs as printed, from any folder of this machine: it names program and case by absolute paths. A
/// subject "exec:..." is named by --subject, since a case file must not name one (app/commands/case_commands.h). It
/// runs in this process's folder, to which its relative paths refer. `time_limit`: given if it decides whether the case
/// fails.
std::string replay_command(const std::string& case_file, const std::string& connectable,
                           std::optional<double> time_limit = {});

}  // namespace touchstone::app
