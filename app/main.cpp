#include <fmt/format.h>

#include <exception>
#include <filesystem>

#include "app/command_line.h"
#include "app/interruption.h"
#include "model/input_error.h"

int main(int argc, char** argv) {
  try {
    touchstone::app::watch_for_interruption();
    return touchstone::app::run_command(argc, argv);
  } catch (const touchstone::InputError& error) {
    fmt::print(stderr, "touchstone: {}\n", error.what());
    return 2;
  } catch (const std::filesystem::filesystem_error& error) {
    fmt::print(stderr, "touchstone: {}\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    fmt::print(
        stderr,
        "touchstone: {}\nThis is our own fault. Please report it, with the command and the files that it read.\n",
        error.what());
    return 3;
  }
}
