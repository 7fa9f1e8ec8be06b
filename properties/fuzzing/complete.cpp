#include "properties/fuzzing/complete.h"

#include <algorithm>
#include <utility>
#include <variant>
#include <vector>

#include "model/limits.h"
#include "oracle/truth/truth.h"

namespace touchstone::properties::fuzzing {
namespace {

/// Calls `see` with each polytope of the body, in the order of its parts.
template <class AnyBody, class See>
void each_polytope(AnyBody& body, See&& see) {
  if (auto* polytope = std::get_if<Polytope>(&body.shape)) see(*polytope);
  if (auto* compound = std::get_if<Compound>(&body.shape)) {
    for (auto& part : compound->parts) {
      if (auto* polytope = std::get_if<Polytope>(&part.shape)) see(*polytope);
    }
  }
}

void add_polytopes(const Scene& scene, std::vector<const Polytope*>& all) {
  for (const Body& body : scene.bodies) {
    each_polytope(body, [&](const Polytope& polytope) { all.push_back(&polytope); });
  }
}

/// Checks the body's shape alone: it is valid in any scene or in none.
void check_shape(const Body& body) {
  Scene alone;
  alone.bodies = {body};
  oracle::truth::completed(std::move(alone));
}

}  // namespace

Scene completed_after(Scene changed, const Scene& before, const Scene& other) {
  std::vector<const Polytope*> known;
  add_polytopes(before, known);
  add_polytopes(other, known);
  for (Body& body : changed.bodies) {
    bool is_new = false;
    each_polytope(body, [&](Polytope& polytope) {
      const auto same = std::ranges::find_if(known, [&](const Polytope* p) {
        return p->vertices == polytope.vertices && (polytope.faces.empty() || p->faces == polytope.faces);
      });
      if (!polytope.faces.empty()) {
        is_new |= same == known.end();
      } else if (same != known.end()) {
        polytope.faces = (*same)->faces;
      } else {
        polytope = oracle::truth::convex_hull(polytope.vertices);
      }
    });
    if (is_new) check_shape(body);
  }
  validate(changed);
  return changed;
}

}  // namespace touchstone::properties::fuzzing
