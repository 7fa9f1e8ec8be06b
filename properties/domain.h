// The scenes that are asked: families of near-degenerate scenes, drawn from a seed (docs/design/generators.md).
//
// Uniformly random scenes do not find the bugs (docs/design/generators.md has the figures), so the families make
// touching, parallel, equal, tiny, huge and far cases on purpose. Most are small integers times a power of two under
// integer quaternions: such scenes are exact in doubles, many in floats, and they shrink.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "model/scene.h"
#include "properties/random.h"

namespace touchstone::properties {

struct Family {
  std::string id;                  ///< "boxes.dyadic_gap"
  std::string says;                ///< what its scenes have in common
  std::vector<std::string> stems;  ///< which stems' properties it is for
  bool binary32_exact = false;     ///< every number of every scene it draws is a float
  std::function<Scene(Random&)> draw;
};

/// All families, in a fixed order.
const std::vector<Family>& families();

/// Throws InputError listing the near names.
const Family& find_family(const std::string& id);

/// A pure function of its arguments, the same bits on every machine. The scene is valid and has its faces.
Scene draw(const Family& family, std::uint64_t seed, std::uint64_t index);

/// What kind of case a scene is for a stem: verdict, closest features, shapes, "binary32", ... Asks oracle::truth.
std::vector<std::string> classes_of(const Scene& scene, const std::string& stem);

/// A kind of case that every run has to meet, and the least share of the scenes over all families of the stem.
struct Class {
  std::string name;
  double least_share = 0;
};

/// The classes that a run over all families of a stem must meet; a run in which one stayed empty says so.
const std::vector<Class>& classes(const std::string& stem);

}  // namespace touchstone::properties
