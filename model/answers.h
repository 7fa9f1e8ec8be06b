// What a subject answers: one plain type a stem, wrapped in Answer<T> = T | Abstains | Breaks.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "model/frame.h"
#include "model/scene.h"

namespace touchstone {

/// Of two closed solids. `touching`: they share boundary points, but no interior point.
enum class Verdict { separated, touching, overlapping };

/// Vertices of a convex part whose hull is a face, edge or vertex of it. A sphere's only "vertex" is its centre, 0.
struct Feature {
  int part = 0;  ///< index into Compound::parts; 0 for a convex body
  std::vector<int> vertices;

  bool operator==(const Feature&) const = default;
};

/// "How far apart are bodies 0 (A) and 1 (B)?" A subject fills in what it offers; absent means "does not say".
struct Distance {
  std::optional<Verdict> verdict;
  std::optional<double> distance;  ///< m; ≥ 0, and 0 when touching or overlapping
  std::optional<Vec3> p_WCa;       ///< witness point on A
  std::optional<Vec3> p_WCb;       ///< witness point on B
  std::optional<Feature> feature_A;
  std::optional<Feature> feature_B;
  std::optional<Interval> enclosure;  ///< claimed to hold the exact distance

  bool operator==(const Distance&) const = default;
};

/// "How deep are bodies 0 (A) and 1 (B) in each other?" The least translation of A that leaves no common interior.
struct Penetration {
  std::optional<Verdict> verdict;
  std::optional<double> depth;    ///< m; ≥ 0, and 0 unless overlapping
  std::optional<Vec3> nhat_BA_W;  ///< unit, from B to A: moving A by depth·nhat_BA_W separates the two

  bool operator==(const Penetration&) const = default;
};

/// Index pairs i < j, sorted, each once.
using PairSet = std::vector<std::pair<int, int>>;

/// What a broad phase says once a frame is done. A subject that has no events leaves begun and ended absent.
struct PairFrame {
  PairSet pairs;                 ///< of bodies that are there
  std::optional<PairSet> begun;  ///< in pairs, and not in those of the frame before
  std::optional<PairSet> ended;  ///< the other way round

  bool operator==(const PairFrame&) const = default;
};

/// "Which boxes meet in each frame of the film?" One entry a frame.
using PairHistory = std::vector<PairFrame>;

/// One box a body, in the scene's order.
using Bounds = std::vector<Aabb>;

/// One entry a body, in the scene's order; a fixed body has none.
using Masses = std::vector<std::optional<MassProperties>>;

/// The subject does not answer this; never a pass.
struct Abstains {
  std::string why;

  bool operator==(const Abstains&) const = default;
};

/// The subject failed to answer; always a failure.
struct Breaks {
  enum class Kind { threw, crashed, hung, garbage };
  Kind kind = Kind::threw;
  std::string how;

  bool operator==(const Breaks&) const = default;
};

template <class T>
using Answer = std::variant<T, Abstains, Breaks>;

}  // namespace touchstone
