#include "app/commands/completion.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "app/commands/option_values.h"

namespace touchstone::app {
namespace {

/// Lets zsh run functions that are written for bash.
constexpr const char* zsh_start = R"((( $+functions[compdef] )) || { autoload -Uz compinit && compinit; }
autoload -Uz bashcompinit && bashcompinit
)";

/// $1: a command, or the name of a value.
constexpr const char* words_function = R"(_touchstone_words() {{
  case $1 in
{}  esac
}}
)";

/// $1: a command and one of its options, or a command and the position of an argument, from 0 on. Prints nothing for a
/// flag.
constexpr const char* value_function = R"(_touchstone_value() {{
  case $1 in
{}  esac
}}
)";

/// bash splits --option=value into three words. A name is completed after a comma too. The registration in the last
/// line falls back on file names; that is turned off where no file is meant, but zsh has no compopt.
constexpr const char* complete_function = R"sh(_touchstone() {
  local word=${COMP_WORDS[COMP_CWORD]} command=${COMP_WORDS[1]} value= position=0 key i
  if [[ $word == "=" ]]; then word=; fi
  for ((i = 2; i < COMP_CWORD; ++i)); do
    if [[ ${COMP_WORDS[i]} == "=" ]]; then continue; fi
    if [[ -n $value ]]; then value=
    elif [[ ${COMP_WORDS[i]} == -?* ]]; then value=$(_touchstone_value "$command ${COMP_WORDS[i]}")
    else position=$((position + 1)); fi
  done
  if ((COMP_CWORD == 1)); then key=COMMAND
  elif [[ -n $value ]]; then key=$value
  elif [[ $word == -* ]]; then key=$command
  else key=$(_touchstone_value "$command $position"); fi
  case $key in
    FILE|FOLDER|CASE|MESH|SCENE) ;;
    *) compopt +o default 2>/dev/null ;;
  esac
  local last=${word##*,}
  COMPREPLY=($(compgen -P "${word%"$last"}" -W "$(_touchstone_words "$key")" -- "$last"))
}
complete -o default -F _touchstone touchstone
)sh";

std::vector<const CLI::App*> commands_of(const CLI::App& program) {
  return program.get_subcommands([](const CLI::App*) { return true; });
}

std::string line(const std::string& pattern, const std::vector<std::string>& words) {
  return fmt::format("    {}) echo \"{}\" ;;\n", pattern, fmt::join(words, " "));
}

std::string lines_of_words(const CLI::App& program, const ValueWords& words) {
  std::string lines;
  for (const CLI::App* command : commands_of(program)) lines += line(command->get_name(), option_names(*command));
  for (const auto& [value, names] : words) lines += line(value, names);
  return lines;
}

std::string lines_of_values(const CLI::App& program) {
  std::map<std::string, std::vector<std::string>> places;  // the places of each value
  for (const CLI::App* command : commands_of(program)) {
    int position = 0;
    for (const CLI::Option* option : command->get_options()) {
      const bool positional = option->get_positional();
      const std::string value = positional ? option->get_name() : option->get_type_name();
      const bool is_flag = !positional && option->get_items_expected_max() == 0;
      if (is_flag) continue;
      places[value].push_back(
          fmt::format("\"{} {}\"", command->get_name(), positional ? std::to_string(position++) : option->get_name()));
    }
  }
  std::string lines;
  for (const auto& [value, of] : places) lines += line(fmt::format("{}", fmt::join(of, "|")), {value});
  return lines;
}

}  // namespace

const std::vector<std::string>& completion_shells() {
  static const std::vector<std::string> shells = {"bash", "zsh"};
  return shells;
}

std::string completion_script(const CLI::App& program, const ValueWords& words, const std::string& shell) {
  return fmt::format("# Completion of touchstone for {0}, made by `touchstone completion {0}`.\n", shell) +
         (shell == "zsh" ? zsh_start : "") + fmt::format(words_function, lines_of_words(program, words)) +
         fmt::format(value_function, lines_of_values(program)) + complete_function;
}

}  // namespace touchstone::app
