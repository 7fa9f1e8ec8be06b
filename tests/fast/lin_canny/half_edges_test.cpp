// Half-edges of a tetrahedron, and of what is no closed surface.
#include "fast/lin_canny/boundary/half_edges.h"

#include "model/input_error.h"
#include "tests/catch.h"

namespace touchstone::fast::lin_canny {
namespace {

using Faces = std::vector<std::vector<int>>;

const Faces tetrahedron = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

Loops loops(const Faces& faces) {
  Loops all;
  for (const std::vector<int>& face : faces) all.add(face);
  return all;
}

std::string refusal(const Faces& faces) {
  try {
    const HalfEdges edges(loops(faces), 4);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST_CASE("half edges: sorted, each with its face, its place and its twin") {
  const HalfEdges edges(loops(tetrahedron), 4);
  REQUIRE(edges.sorted().size() == 12);
  for (std::size_t i = 0; i < 12; ++i) {
    const HalfEdge &edge = edges.sorted()[i], &twin = edges.twin(i);
    const auto corner = static_cast<std::size_t>(edge.place % 3);
    const std::vector<int>& loop = tetrahedron[static_cast<std::size_t>(edge.face)];
    CHECK(edge.place / 3 == edge.face);
    CHECK(loop[corner] == edge.from);
    CHECK(loop[(corner + 1) % 3] == edge.to);
    CHECK(twin.from == edge.to);
    CHECK(twin.to == edge.from);
    CHECK(twin.face != edge.face);
    if (i == 0) continue;
    const HalfEdge& before = edges.sorted()[i - 1];
    CHECK((before.from < edge.from || (before.from == edge.from && before.to < edge.to)));
  }
}

TEST_CASE("half edges: what is no closed surface is refused") {
  Faces open = tetrahedron;
  open.pop_back();
  CHECK_THAT(refusal(open), Catch::Contains("is not met exactly once"));
  Faces twice = tetrahedron;
  twice.push_back({0, 2, 1});
  CHECK_THAT(refusal(twice), Catch::Contains("is not met exactly once"));
  Faces inside_out = tetrahedron;
  inside_out[0] = {0, 1, 2};
  CHECK_THAT(refusal(inside_out), Catch::Contains("edge 1-0 is not met exactly once"));
  Faces flat = tetrahedron;
  flat[1] = {0, 1};
  CHECK_THAT(refusal(flat), Catch::Contains("fewer than three"));
  Faces beyond = tetrahedron;
  beyond[1] = {0, 1, 4};
  CHECK_THAT(refusal(beyond), Catch::Contains("no vertex 4"));
}

}  // namespace
}  // namespace touchstone::fast::lin_canny
