// An adapter whose queries go wrong, each in its own way.
#include <touchstone_adapter.h>

#include <cmath>
#include <cstdio>

using namespace touchstone_adapter;

Json bounds(const Json& scene) {
  std::puts("an engine that prints");
  std::fflush(stdout);
  const Vec3 p = in_world(scene.at("bodies").at(0).at("X_WB"), {1, 2, 3});
  return {{{"lo", p}, {"hi", {1.0, 2.0, 3.0}}}};
}

Json distance(const Json&) { throw Abstain("not today"); }

Json mass(const Json&) { return {{{"mass", 1.0}, {"p_BBcm", {0.0, std::nan(""), 0.0}}}}; }

Json penetration(const Json&) { throw std::runtime_error("the engine failed"); }

Json pixel(const Json&) { throw Refused("no compounds"); }

int main() {
  serve({{"name", "faulty"}, {"version", "1"}, {"precision", "binary32"}},
        {{"mass", mass}, {"bounds", bounds}, {"distance", distance}, {"penetration", penetration}, {"pixel", pixel}},
        {{"mass", [](const Json& scene) { return "ask about \"" + std::to_string(scene.at("bodies").size()) + '"'; }}});
}
