// A libFuzzer target: one reader of texts from outside. It returns or throws its own error, whatever the bytes.
//
// The macro TOUCHSTONE_FUZZED_PARSER is "scene", "obj", "off", "stl", "ply" or "protocol".
#include <unistd.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "model/input_error.h"
#include "model/json.h"
#include "oracle/process/protocol.h"
#include "reference/mesh.h"

using namespace touchstone;

namespace {

constexpr std::size_t whole_one_of = 256;  // texts of meshes, by their hash: an exact hull takes longer than a text

/// The vertices of every text; of some also the file and the hull, as `read_mesh` does it.
void mesh(std::string_view text, const std::string& ending) {
  if (std::hash<std::string_view>{}(text) % whole_one_of != 0) {
    reference::mesh_vertices(std::string(text), "mesh" + ending);
    return;
  }
  static const std::string path =
      (std::filesystem::temp_directory_path() / ("touchstone_fuzz_" + std::to_string(getpid()) + ending)).string();
  std::ofstream(path, std::ios::binary) << text;
  reference::read_mesh(path);
}

/// A line of the protocol, as one of its readers reads it: the first byte says which.
void protocol(std::string_view text) {
  namespace lines = oracle::protocol;
  using Reader = void (*)(std::string_view);
  static constexpr std::array<Reader, 14> readers = {
      [](std::string_view line) { lines::seq_of(line); },
      [](std::string_view line) { lines::read_request(line); },
      [](std::string_view line) { lines::read_introduction(line, 1); },
      [](std::string_view line) { lines::read_snippet(line, 1); },
      [](std::string_view line) { lines::read_answer<Masses>(line, 1); },
      [](std::string_view line) { lines::read_answer<Bounds>(line, 1); },
      [](std::string_view line) { lines::read_answer<PairSet>(line, 1); },
      [](std::string_view line) { lines::read_answer<PairHistory>(line, 1); },
      [](std::string_view line) { lines::read_answer<Distance>(line, 1); },
      [](std::string_view line) { lines::read_answer<Penetration>(line, 1); },
      [](std::string_view line) { lines::read_answer<Pixels>(line, 1); },
      [](std::string_view line) { lines::read_answer<Impulse>(line, 1); },
      [](std::string_view line) { lines::read_answer<TimeOfImpact>(line, 1); },
      [](std::string_view line) { lines::read_answer<Trajectory>(line, 1); },
  };
  if (text.empty()) return;
  readers[static_cast<unsigned char>(text.front()) % readers.size()](text.substr(1));
}

using Parser = void (*)(std::string_view);

const std::map<std::string_view, Parser> parsers = {
    {"scene", [](std::string_view text) { scene_from(text, "scene"); }},
    {"obj", [](std::string_view text) { mesh(text, ".obj"); }},
    {"off", [](std::string_view text) { mesh(text, ".off"); }},
    {"stl", [](std::string_view text) { mesh(text, ".stl"); }},
    {"ply", [](std::string_view text) { mesh(text, ".ply"); }},
    {"protocol", protocol},
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Parser parser = parsers.at(TOUCHSTONE_FUZZED_PARSER);
  try {
    parser({reinterpret_cast<const char*>(data), size});
  } catch (const InputError&) {
  }
  return 0;
}
