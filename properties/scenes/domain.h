// The scenes for queries: families of nearly degenerate scenes, drawn from a seed (docs/design/generators.md).
//
// Uniformly random scenes do not find the bugs (docs/design/generators.md has the figures), so the families make
// touching, parallel, equal, tiny, huge and distant cases on purpose. Most scenes consist of small integers times a
// power of two, with integer quaternions: they are exact in doubles, many also in floats, and they shrink.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "model/scene.h"
#include "properties/random.h"

namespace touchstone::properties {

struct Family {
  std::string id;                    ///< "boxes.dyadic_gap"
  std::string says;                  ///< what its scenes have in common
  std::vector<std::string> queries;  ///< the queries whose properties use it
  bool binary32_exact = false;       ///< every number of every scene that it draws is a float
  std::function<Scene(Random&)> draw;
};

/// All families, in a fixed order.
const std::vector<Family>& families();

/// Throws InputError with a list of similar names if there is no such family.
const Family& find_family(const std::string& id);

/// The families, out of these or of the extreme ones, from which the query's scenes are drawn.
std::vector<const Family*> for_query(const std::vector<Family>& families, const std::string& query);

/// A pure function of its arguments, with the same bits on every machine. The scene is valid, and its faces are set.
Scene draw(const Family& family, std::uint64_t seed, std::uint64_t index);

/// The classes of a scene for a query: verdict, closest features, shapes, "binary32", ... Uses oracle::truth.
std::vector<std::string> classes_of(const Scene& scene, const std::string& query);

/// A class of scenes that every run must contain, and its least share among the scenes of all families of the query.
struct Class {
  std::string name;
  double least_share = 0;
};

/// The classes that a run over all families of a query must contain; a run reports each class that stayed empty.
const std::vector<Class>& classes(const std::string& query);

}  // namespace touchstone::properties
