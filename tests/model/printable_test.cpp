#include "model/printable.h"

#include <string>

#include "tests/catch.h"

namespace touchstone {
namespace {

using namespace std::string_literals;

TEST_CASE("what is harmless stays as it is") {
  for (const std::string text :
       {"", "plain", "d ≤ ½ · ¾", "naïve Größe", "球と箱", "🎱", "\"quoted\" \\n", "\xef\xbf\xbd"}) {
    CHECK(printable(text) == text);
  }
}

TEST_CASE("control characters become the escapes of JSON") {
  CHECK(printable("\x1b[31m\a\x7f\0"s) == "\\u001b[31m\\u0007\\u007f\\u0000");
  CHECK(printable("a\nb\r\tc") == "a\\nb\\r\\tc");
  CHECK(printable_lines("a\nb\r\tc") == "a\nb\\r\\tc");
  CHECK(printable("\xc2\x9b 2J") == "\\u009b 2J");
}

TEST_CASE("nothing turns the writing around or hides") {
  CHECK(printable("\u202e \u2066 \u200b \u061c \u2028 \ufeff") == "\\u202e \\u2066 \\u200b \\u061c \\u2028 \\ufeff");
  CHECK(printable("\xef\xbf\xbe") == "\\ufffe");
  CHECK(printable("\U000e0041") == "\\udb40\\udc41");
}

TEST_CASE("a byte that is not UTF-8 is shown as such") {
  CHECK(printable("\xff.obj") == "\\xff.obj");
  CHECK(printable("\xc0\xaf") == "\\xc0\\xaf");                    // overlong
  CHECK(printable("\xe0\x80\xaf") == "\\xe0\\x80\\xaf");           // overlong
  CHECK(printable("\xed\xa0\x80") == "\\xed\\xa0\\x80");           // a surrogate
  CHECK(printable("\xf4\x90\x80\x80") == "\\xf4\\x90\\x80\\x80");  // beyond the last
  CHECK(printable("cut \xe2\x82") == "cut \\xe2\\x82");
  CHECK(printable("\x80 \xfe") == "\\x80 \\xfe");
}

TEST_CASE("printable text of any bytes is printable already") {
  std::string bytes;
  for (int i = 0; i < 4096; ++i) bytes += static_cast<char>(i * i * 31 + i / 7);
  const std::string once = printable(bytes);
  CHECK(printable(once) == once);
}

}  // namespace
}  // namespace touchstone
