#include "app/system/progress.h"
#include "tests/catch.h"

namespace touchstone::app {
namespace {

TEST_CASE("a bar has its parts") {
  CHECK(bar_line("asking", 120, 480, 31, "distance", 80) ==
        "asking [███████·······················] 120/480 0:31, 1:33 left  distance");
  CHECK(bar_line("asking", 0, 480, 61, "", 80) == "asking [······························] 0/480 1:01");
  CHECK(bar_line("asking", 480, 480, 3725, "", 80) ==
        "asking [██████████████████████████████] 480/480 1:02:05, 0:00 left");
}

TEST_CASE("a bar gives way, last words first") {
  CHECK(bar_line("asking", 120, 480, 31, "distance", 68) ==
        "asking [███████·······················] 120/480 0:31, 1:33 left  dis");
  CHECK(bar_line("asking", 120, 480, 31, "distance", 39) == "asking [█·····] 120/480 0:31, 1:33 left");
  CHECK(bar_line("asking", 120, 480, 31, "distance", 30) == "asking 120/480 0:31, 1:33 left");
  CHECK(bar_line("asking", 120, 480, 31, "distance", 25) == "120/480 0:31, 1:33 left");
  CHECK(bar_line("asking", 120, 480, 31, "distance", 7) == "120/480");
  CHECK(bar_line("asking", 120, 480, 31, "distance", 0).empty());
}

TEST_CASE("foreign words in a bar are printable, and wide ones count as wide") {
  CHECK(bar_line("\x1b", 1, 1, 0, "\r", 80) == "\\u001b [██████████████████████████████] 1/1 0:00, 0:00 left  \\r");
  CHECK(bar_line("ask", 1, 1, 0, "球球球", 63).ends_with("left  球球"));
}

}  // namespace
}  // namespace touchstone::app
