// What a subject answers: one plain type a stem, wrapped in Answer<T> = T | Abstains | Breaks.
#pragma once

#include <array>
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

/// "What does the impact at the scene's contact do?"
struct Impulse {
  std::array<Velocity, 2> after;  ///< of bodies 0 (A) and 1 (B)
  std::optional<Vec3> P_A_W;      ///< impulse on A at C (N s); B takes its opposite
  std::optional<double>
      error;  ///< claimed: sqrt((P − P*)ᵀ K (P − P*)) is at most this (sqrt(J)), K as in docs/spec/impulse.md
  std::optional<double> ambiguous;  ///< the law itself jumps within this relative distance of the scene

  bool operator==(const Impulse&) const = default;
};

/// Pixels of a raster: a string a row, the lowest first; '1' for a pixel that is in, '0' for one that is not.
using Mask = std::vector<std::string>;

/// Of two masks, the second moved by the raster's shift: how many pixels are in both, and the first of them by row,
/// then column.
struct MaskOverlap {
  int count = 0;
  std::optional<std::pair<int, int>> first;  ///< column, row

  bool operator==(const MaskOverlap&) const = default;
};

/// "Which pixels of the raster do the bodies cover, and in which do bodies 0 (A) and 1 (B) meet?" Bodies are closed.
struct Pixels {
  std::vector<Mask> sampled;       ///< by body: the pixel's centre is in its picture
  std::vector<Mask> conservative;  ///< by body: holds every pixel whose closed square meets its picture
  MaskOverlap overlap;             ///< of A's and B's sampled masks
  Mask meet_sampled;               ///< A and B share a point above the pixel's centre
  Mask meet_conservative;          ///< holds every pixel above whose closed square A and B share a point

  bool operator==(const Pixels&) const = default;
};

/// "When do bodies 0 (A) and 1 (B) first meet in flight?" Contact where both flights begin counts if they approach.
struct TimeOfImpact {
  enum class Meeting { hit, miss, undecided };
  Meeting meeting = Meeting::undecided;
  std::optional<double> time;         ///< s; of a hit
  std::optional<Interval> enclosure;  ///< claimed: apart before its lower end; of a hit, its upper end is not before it
  std::optional<double> gap;          ///< m; undecided: somewhere in the enclosure the two are as near as this

  bool operator==(const TimeOfImpact&) const = default;
};

struct State {
  Pose X_WB;
  Velocity velocity;

  bool operator==(const State&) const = default;
};

/// What ended one flight and began the next. From `time` on, each body flies from its state here.
struct Event {
  enum class Kind {
    impact,           ///< an impulse at one point
    micro_collision,  ///< one of many impulses that stand for a resting contact
    completed,        ///< infinitely many impacts, in closed form, that end at `time`
    contact,          ///< the pair begins to roll, slide or rest on each other, or changes between these
    release,          ///< such a contact ends
    push              ///< a force on body a begins, changes or ends; b = −1
  };
  Kind kind = Kind::impact;
  double time = 0;  ///< s
  int a = 0, b = -1;
  Vec3 p_WC = Vec3::Zero();
  Vec3 nhat_BA_W = Vec3::Zero();
  Vec3 P_A_W = Vec3::Zero();  ///< N s, on a; b takes its opposite
  State after_a, after_b;

  bool operator==(const Event&) const = default;
};

/// "What happens next?" Until the end of the scene's flight.
struct Trajectory {
  std::vector<std::vector<State>> states;    ///< by time of the flight, then by body
  std::optional<std::vector<Event>> events;  ///< in the order in which they were resolved
  std::optional<double> complete_until;      ///< s; where the subject gave up: states and events end here
  std::string gave_up;                       ///< why, and on whom; empty: it did not, or does not say

  bool operator==(const Trajectory&) const = default;
};

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
