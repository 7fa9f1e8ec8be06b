// Corrupted text is either refused or still a scene; nothing else may happen.
#include "model/json.h"
#include "tests/catch.h"
#include "tests/model/random_scene.h"

namespace touchstone {
namespace {

using tests::Bits;
using namespace std::string_literals;

/// Corrupts the text as files are in practice: truncates it, or removes, changes, repeats or moves a piece.
std::string spoiled(std::string text, Bits& bits) {
  const auto anywhere = [&] { return static_cast<std::size_t>(bits.below(static_cast<int>(text.size()))); };
  static const std::string telling = "{}[]\":,.-+eE0123456789ntfux\\ \n\t\0\x80\xff"s;
  const std::size_t at = anywhere();
  const auto length = static_cast<std::size_t>(1 + bits.below(8));
  const char letter = telling[static_cast<std::size_t>(bits.below(static_cast<int>(telling.size())))];
  switch (bits.below(6)) {
    case 0:
      return text.substr(0, at);
    case 1:
      return text.erase(at, length);
    case 2:
      return text.insert(at, 1, letter);
    case 3:
      return text.insert(at, text.substr(anywhere(), length * 8));
    case 4:
      return text.replace(at, length, text.substr(anywhere(), length));
    default:
      text[at] = letter;
      return text;
  }
}

TEST_CASE("spoiled scenes are refused or read, and what is read survives") {
  const std::string good = read_text(HERE "/good_scene.json");
  Bits bits(3);
  int read = 0;
  for (int i = 0; i < 20'000; ++i) {
    std::string text = good;
    for (int accidents = 1 + bits.below(3); accidents > 0 && !text.empty(); --accidents) text = spoiled(text, bits);
    try {
      const Scene scene = scene_from(text, "");
      REQUIRE(scene_from(json_of(scene).dump(), "") == scene);
      ++read;
    } catch (const InputError& error) {
      REQUIRE_FALSE(std::string(error.what()).empty());
    }
  }
  CHECK(read > 100);  // otherwise the corruptions are too coarse to test the reader behind the parser
}

}  // namespace
}  // namespace touchstone
