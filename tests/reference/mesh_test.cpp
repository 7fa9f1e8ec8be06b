#include "reference/mesh.h"

#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include "model/input_error.h"
#include "reference/convex_hull.h"
#include "tests/catch.h"
#include "tests/reference/hard_pairs.h"

namespace touchstone::reference {
namespace {

using tests::Dice;

/// A folder that goes away with its test; nothing may be printed while it stands.
class Folder {
 public:
  Folder() : path_(std::filesystem::temp_directory_path() / ("touchstone-mesh-" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(path_);
    out_ = std::cout.rdbuf(printed_.rdbuf());
    err_ = std::cerr.rdbuf(printed_.rdbuf());
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::cout.rdbuf(out_);
    std::cerr.rdbuf(err_);
    std::filesystem::remove_all(path_);
  }

  std::string file(const std::string& name, const std::string& text) const {
    const std::string path = (path_ / name).string();
    std::ofstream(path, std::ios::binary) << text;
    return path;
  }
  std::string path() const { return path_.string(); }
  std::string printed() const { return printed_.str(); }

 private:
  std::filesystem::path path_;
  std::ostringstream printed_;
  std::streambuf* out_;
  std::streambuf* err_;
};

/// What is wrong, after the file's name: "LINE:COLUMN: " too, where it is text.
std::string complaint(const std::string& path) {
  try {
    read_mesh(path);
  } catch (const InputError& error) {
    const std::string what = error.what();
    REQUIRE(what.starts_with(path + ":"));
    return what.substr(path.size() + (what[path.size() + 1] == ' ' ? 2 : 1));
  }
  return "none";
}

template <class Number>
void put(std::string& bytes, Number number, bool reversed = false) {
  std::string own(sizeof number, '\0');
  std::memcpy(own.data(), &number, sizeof number);
  if (reversed) std::reverse(own.begin(), own.end());
  bytes += own;
}

const std::string obj =
    "# corner\no solid\nv 0 0 0\nv 0.1 0 0\nv 0 1e0 0\nv 0 0 1\nvn 0 0 1\nf 1 3 2\nf 1//1 2//1 4//1\nf 1 4 3\nf 2 3 "
    "4\n";
const std::string off =
    "OFF # corner\n4 4 6\n\n0 0 0\n0.1 0 0 255 0 0\n0 1 0\n# between\n0 0 +1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
const std::string ply =
    "ply\nformat ascii 1.0\ncomment corner\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\n"
    "element face 4\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n0.1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

std::string stl_text() {
  std::string text = "solid corner\n";
  const char* facets[] = {"0 0 0 0 1 0 0.1 0 0", "0 0 0 0.1 0 0 0 0 1", "0 0 0 0 0 1 0 1 0", "0.1 0 0 0 1 0 0 0 1"};
  for (const char* facet : facets) {
    std::istringstream numbers(facet);
    text += "facet normal 0 0 0\nouter loop\n";
    for (std::string x, y, z; numbers >> x >> y >> z;) text += "vertex " + x + " " + y + " " + z + "\n";
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid corner\n";
}

std::string stl_binary(const std::vector<Vec3>& corners, std::uint32_t declared) {
  std::string bytes(80, ' ');
  put(bytes, declared);
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    for (int k = 0; k < 3; ++k) put(bytes, 0.0F);
    for (std::size_t k = 0; k < 3; ++k) {
      for (const double x : corners[i + k]) put(bytes, static_cast<float>(x));
    }
    bytes += std::string(2, '\0');
  }
  return bytes;
}

std::vector<Vec3> corner_facets(double x) {
  const Vec3 o(0, 0, 0), a(x, 0, 0), b(0, 1, 0), c(0, 0, 1);
  return {o, b, a, o, a, c, o, c, b, a, b, c};
}

std::string ply_binary(bool big) {
  std::string bytes =
      std::string("ply\nformat binary_") + (big ? "big" : "little") +
      "_endian 1.0\nelement patch 2\nproperty list ushort float weights\nproperty int id\nelement vertex 4\n"
      "property uchar red\nproperty float z\nproperty float64 x\nproperty float y\nend_header\n";
  const bool reversed = big != (std::endian::native == std::endian::big);
  for (int i = 0; i < 2; ++i) {
    put(bytes, static_cast<std::uint16_t>(i + 1), reversed);
    for (int k = 0; k <= i; ++k) put(bytes, 1.5F, reversed);
    put(bytes, 7, reversed);
  }
  for (const Vec3& p : {Vec3(0, 0, 0), Vec3(0.1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}) {
    put(bytes, static_cast<std::uint8_t>(9));
    put(bytes, static_cast<float>(p.z()), reversed);
    put(bytes, p.x(), reversed);
    put(bytes, static_cast<float>(p.y()), reversed);
  }
  return bytes;
}

TEST_CASE("mesh: a tetrahedron in each format") {
  const Folder folder;
  const Polytope corner = convex_hull({{0, 0, 0}, {0.1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  CHECK(read_mesh(folder.file("a.obj", obj)) == corner);
  CHECK(read_mesh(folder.file("a.OFF", off)) == corner);
  CHECK(read_mesh(folder.file("oneline.off", "OFF 4 0 0\n0 0 0\n0.1 0 0\n0 1 0\n0 0 1\n")) == corner);
  CHECK(read_mesh(folder.file("a.ply", ply)) == corner);
  CHECK(read_mesh(folder.file("little.ply", ply_binary(false))) == corner);
  CHECK(read_mesh(folder.file("big.ply", ply_binary(true))) == corner);
  CHECK(read_mesh(folder.file("text.Stl", stl_text())).vertices.size() == 4);
  // A binary STL has floats: 0.1 becomes the nearest float, exactly.
  const Polytope from_floats = read_mesh(folder.file("binary.stl", stl_binary(corner_facets(0.1), 4)));
  CHECK(std::any_of(from_floats.vertices.begin(), from_floats.vertices.end(),
                    [](const Vec3& v) { return v.x() == static_cast<double>(0.1F); }));
  CHECK(folder.printed().empty());
}

TEST_CASE("mesh: an STL in binary may have a vertex as the first, second or third corner alone") {
  const Folder folder;
  const Vec3 o(0, 0, 0), a(1, 0, 0), b(0, 1, 0), c(0, 0, 1);
  for (const std::vector<Vec3>& corners :
       {std::vector<Vec3>{b, a, o, c, a, b, c, o, a, c, b, o}, std::vector<Vec3>{o, b, a, b, c, a, o, c, b, a, c, o},
        std::vector<Vec3>{a, o, b, a, b, c, o, a, c, b, o, c}}) {
    CHECK(read_mesh(folder.file("apex.stl", stl_binary(corners, 4))).vertices.size() == 4);
  }
  CHECK(folder.printed().empty());
}

TEST_CASE("mesh: the name of a solid in an STL is any words of its line") {
  const Folder folder;
  const Polytope corner = read_mesh(folder.file("plain.stl", stl_text()));
  for (const std::string name : {"", "vertex group", "solid", "endsolid vertex 1 2", "facet"}) {
    std::string text = stl_text();
    for (auto at = text.find("corner"); at != std::string::npos; at = text.find("corner")) text.replace(at, 6, name);
    CHECK(read_mesh(folder.file("named.stl", text)) == corner);
  }
  CHECK(folder.printed().empty());
}

TEST_CASE("mesh: a byte order mark takes no vertex away") {
  const Folder folder;
  const std::pair<const char*, std::string> texts[] = {{"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n"},
                                                       {"a.off", off},
                                                       {"a.ply", ply},
                                                       {"a.stl", stl_text()}};
  for (const auto& [name, text] : texts) {
    CHECK(read_mesh(folder.file(name, "\xEF\xBB\xBF" + text)) == read_mesh(folder.file(name, text)));
    CHECK(complaint(folder.file(name, "\xFF\xFE" + text)) == "text in UTF-16; expected UTF-8: save it as that");
  }
}

TEST_CASE("mesh: a mesh that is not convex gives its hull") {
  const Folder folder;
  std::string text = "OFF\n9 0 0\n";
  for (int i = 0; i < 8; ++i)
    text += std::to_string(i & 1) + " " + std::to_string(i >> 1 & 1) + " " + std::to_string(i >> 2) + "\n";
  const Polytope cube = read_mesh(folder.file("dent.off", text + "0.5 0.5 0.25\n"));
  CHECK(cube.vertices.size() == 8);
  CHECK(cube.faces.size() == 6);
}

TEST_CASE("mesh: files that are none") {
  const Folder folder;
  CHECK(complaint(folder.path() + "/missing.stl") == "cannot read: No such file or directory");
  std::filesystem::create_directory(folder.path() + "/folder.stl");
  CHECK(complaint(folder.path() + "/folder.stl") == "is a folder; expected a plain file, or - to read standard input");
  CHECK(complaint(folder.file("a.dae", "<COLLADA/>")) ==
        "COLLADA (.dae) is not read; expected .obj, .off, .stl or .ply");
  CHECK(complaint(folder.file("a.txt", off)) == "not a mesh format by its name; expected .obj, .off, .stl or .ply");
  const std::string large = folder.file("large.stl", "");
  std::filesystem::resize_file(large, 300'000'000);  // sparse: takes no room
  CHECK(complaint(large) == "has 300 MB; at most 100 MB are read");
  for (const char* name : {"a.obj", "a.off", "a.ply", "a.stl"}) {
    CHECK(complaint(folder.file(name, "")) != "none");
    CHECK(complaint(folder.file(name, "{\"this\": \"is not a mesh\"}\n")) != "none");
  }
  CHECK(folder.printed().empty());
}

TEST_CASE("mesh: bad coordinates and flat meshes") {
  const Folder folder;
  CHECK(complaint(folder.file("four.off", "4OFF\n4 0 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n")).find("starts with \"4OFF\"") !=
        std::string::npos);
  CHECK(complaint(folder.file("nan.off", "OFF\n4 0 0\n0 0 0\n1 0 0\n0 nan 0\n0 0 1\n")) ==
        "5:3: expected a number that a double can hold, found \"nan\"");
  CHECK(complaint(folder.file("inf.stl", stl_binary(corner_facets(1e300), 4))).find(": NaN or infinite") !=
        std::string::npos);
  CHECK(complaint(folder.file("nan.stl", stl_binary(corner_facets(NAN), 4))).find(": NaN or infinite") !=
        std::string::npos);
  CHECK(complaint(folder.file("nan.obj", "v 0 0 0\nv 1 nan 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n")) ==
        "2:5: expected a number that a double can hold, found \"nan\"");
  CHECK(complaint(folder.file("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n")) ==
        "not an OBJ mesh: no line \"f\"");
  CHECK(complaint(folder.file("beyond.off", "OFF\n4 0 0\n0 0 0\n1e999 0 0\n0 1 0\n0 0 1\n")) ==
        "4:1: expected a number that a double can hold, found \"1e999\"");
  CHECK(complaint(folder.file("small.off", "OFF\n4 0 0\n0 0 0\n1 0 -1e-400\n0 1 0\n0 0 1\n")) ==
        "4:5: too small for a double, found \"-1e-400\": it would be read as 0");
  CHECK(complaint(folder.file("denormal.off", "OFF\n4 0 0\n0 0 0\n1e-320 0 0\n0 1 0\n0 0 1\n")) == "none");
  CHECK(complaint(folder.file("torn.obj", "v 0 0 0\nv 1 0\nf 1 2 3\n")) ==
        "2:6: expected a number, found the end of the line");
  CHECK(complaint(folder.file("nul.obj", obj + '\0')) == "12:1: a NUL byte; expected text");
  CHECK(complaint(folder.file("flat.off", "OFF\n4 0 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n")) ==
        "points: all in one plane: a solid needs 4 that are not");
  CHECK(complaint(folder.file("few.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n")) ==
        "points: fewer than 4: a solid needs 4 that are not in one plane");
  CHECK(folder.printed().empty());
}

TEST_CASE("mesh: what a file declares is not believed") {
  const Folder folder;
  CHECK(complaint(folder.file("many.off", "OFF\n18446744073709551615 9 9\n0 0 0\n")) ==
        "4:1: not a whole OFF mesh: it ends before its last vertex");
  CHECK(complaint(folder.file("less.off", "OFF\n-4 0 0\n")) == "2:1: expected a number of items, found \"-4\"");
  CHECK(complaint(folder.file("many.stl", stl_binary(corner_facets(1), 4'000'000'000U))) ==
        "not an STL mesh: neither text that starts with \"solid\" nor of the size that its header declares");
  const std::string start = "ply\nformat ascii 1.0\n";
  const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
  CHECK(complaint(folder.file("many.ply", start + "element vertex 99999999999999\n" + xyz + "end_header\n1 2 3\n")) ==
        "9:1: not a whole PLY mesh: it ends before its last vertex");
  CHECK(complaint(folder.file("empty.ply",
                              start + "element ghost 99999999999999999\nelement vertex 1\n" + xyz + "end_header\n")) ==
        "9:1: not a whole PLY mesh: it ends before its last vertex");
  CHECK(complaint(folder.file("list.ply", start + "element face 1\nproperty list uint int i\nelement vertex 1\n" + xyz +
                                              "end_header\n4294967295 1 2 3\n")) ==
        "11:1: not a whole PLY mesh: it ends before its last vertex");
  CHECK(complaint(folder.file("flat.ply", start + "element vertex 9\nproperty int x\nproperty int y\nend_header\n")) ==
        "not a PLY mesh: a vertex needs one number z");
  CHECK(complaint(folder.file("none.ply", start + "end_header\n")) == "not a PLY mesh: no element \"vertex\"");
  CHECK(complaint(folder.file("type.ply", start + "element vertex 1\nproperty quad x\n")) ==
        "4:10: not a PLY mesh: unknown type \"quad\"");
  CHECK(complaint(folder.file("stray.ply", start + xyz)) == "3:1: not a PLY mesh: a property before any element");
  CHECK(folder.printed().empty());
}

TEST_CASE("mesh: torn and garbled files give a hull or a complaint, never a crash") {
  const Folder folder;
  const std::pair<const char*, std::string> whole[] = {
      {"a.obj", obj},        {"a.off", off},
      {"a.ply", ply},        {"b.ply", ply_binary(false)},
      {"a.stl", stl_text()}, {"b.stl", stl_binary(corner_facets(1), 4)}};
  Dice dice(61);
  for (const auto& [name, text] : whole) {
    for (std::size_t size = 0; size < text.size(); size += 3) complaint(folder.file(name, text.substr(0, size)));
    for (int i = 0; i < 300; ++i) {
      std::string garbled = text;
      for (int k = dice.between(1, 8); k > 0; --k) {
        garbled[dice.bits() % garbled.size()] = static_cast<char>(dice.bits());
      }
      complaint(folder.file(name, garbled));
    }
  }
  CHECK(folder.printed().empty());
}

}  // namespace
}  // namespace touchstone::reference
