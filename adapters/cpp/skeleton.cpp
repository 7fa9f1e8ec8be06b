// An adapter of NAME for Touchstone. Build and run it by
//     g++ -std=c++17 -O2 NAME.cpp -o NAME && touchstone adapter check "exec:./NAME"
// It answers the distance of two balls, and abstains from all else. Replace the parts that are marked TODO.
#include <cmath>

#include "touchstone_adapter.h"

using namespace touchstone_adapter;

// TODO: make your engine's shape of the body's. Mind what your engine calls radius, half extents and sides:
// {"type": "sphere", "radius"}, {"type": "box", "half_extents"}: a box has the sides 2 hx, 2 hy, 2 hz;
// {"type": "polytope", "vertices", "faces"}: its faces are counter-clockwise seen from outside.
double shape_of(const Json& body) {
  if (body.at("shape").at("type") != "sphere") throw Abstain("balls only");
  return body.at("shape").at("radius");
}

// The distance of bodies 0 (A) and 1 (B). A pose X_WB maps points of the body's frame B to the world's frame W:
// p_WQ = R(q) p_BQ + p. q = {w, x, y, z} may have any length but 0; unit_quaternion(q) has length 1.
Json distance(const Json& scene) {
  const Json &A = scene.at("bodies").at(0), &B = scene.at("bodies").at(1);
  const double r_A = shape_of(A), r_B = shape_of(B);
  const Vec3 p_WA = A.at("X_WB").at("p"), p_WB = B.at("X_WB").at("p");
  // TODO: ask your engine here. Do not repair its answer: no clamping, no epsilon, no second try.
  const double x = p_WA[0] - p_WB[0], y = p_WA[1] - p_WB[1], z = p_WA[2] - p_WB[2];
  const double length = std::hypot(x, y, z), gap = length - r_A - r_B;
  if (gap <= 0) return {{"verdict", "overlapping"}, {"distance", 0.0}};
  const Vec3 n = {x / length, y / length,
                  z / length};  // all positions and directions of answers are in the world's frame W
  const Vec3 p_WCa = {p_WA[0] - r_A * n[0], p_WA[1] - r_A * n[1], p_WA[2] - r_A * n[2]};
  const Vec3 p_WCb = {p_WB[0] + r_B * n[0], p_WB[1] + r_B * n[1], p_WB[2] + r_B * n[2]};
  return {
      {"verdict", "separated"}, {"distance", gap}, {"p_WCa", p_WCa}, {"p_WCb", p_WCb}};  // leave out what is unknown
}

// TODO: the name and version of your engine; "binary32" if it computes in floats; which settings you use; a function
// for each query that it answers: mass, bounds, broad_phase, pair_history, distance, penetration, impulse, pixel,
// time_of_impact, simulation, constraint. Queries that are not here are never asked.
int main() {
  serve({{"name", "NAME"}, {"version", "0"}, {"precision", "binary64"}, {"about", "closed form; a skeleton"}},
        {{"distance", distance}});
}
