#include <exception>
#include <filesystem>

#include "app/commands/command_line.h"
#include "app/system/interruption.h"
#include "app/system/terminal.h"
#include "model/input_error.h"
#include "model/output_error.h"

namespace touchstone::app {
namespace {

int exit_code_of(int argc, char** argv) try {
  require_stdout();
  take_children_along();
  return run_command(argc, argv);
} catch (const InputError& error) {
  complain("{}", error.what());
  return 2;
} catch (const std::filesystem::filesystem_error& error) {
  complain("{}", error.what());
  return 2;
} catch (const OutputError& error) {
  complain("{}", error.what());
  return fault_exit_code;
} catch (const std::exception& error) {
  complain("{}\nThis is our own fault. Please report it, with the command and the files that it read.", error.what());
  return fault_exit_code;
}

/// If the run was interrupted, the exit code says so, whatever error follows.
int run(int argc, char** argv) {
  const int code = exit_code_of(argc, argv);
  return exit_code_after_flush(code > 1 && interrupted() ? interrupted_exit_code() : code);
}

}  // namespace
}  // namespace touchstone::app

int main(int argc, char** argv) { return touchstone::app::run(argc, argv); }
