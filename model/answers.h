// The answers of a subject: one plain type for each query, wrapped in `Answer<T>` = `T | Abstains | Breaks`.
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

/// How two closed solids lie to each other. `touching`: they share boundary points, but no interior point.
enum class Verdict { separated, touching, overlapping };

/// The vertices of a convex part whose hull is one of its faces, edges or vertices. A sphere has one "vertex", its
/// centre, with index 0.
struct Feature {
  int part = 0;  ///< index into Compound::parts; 0 for a convex body
  std::vector<int> vertices;

  bool operator==(const Feature&) const = default;
};

/// "How far apart are bodies 0 (A) and 1 (B)?" A subject fills in what it computes; an absent member means "no claim".
struct Distance {
  std::optional<Verdict> verdict;
  std::optional<double> distance;  ///< m; ≥ 0, and 0 when touching or overlapping
  std::optional<Vec3> p_WCa;       ///< witness point on A
  std::optional<Vec3> p_WCb;       ///< witness point on B
  std::optional<Feature> feature_A;
  std::optional<Feature> feature_B;
  std::optional<Interval> enclosure;  ///< claimed to contain the exact distance

  bool operator==(const Distance&) const = default;
};

/// "How deeply do bodies 0 (A) and 1 (B) overlap?" The shortest translation of A after which they share no interior
/// point.
struct Penetration {
  std::optional<Verdict> verdict;
  std::optional<double> depth;    ///< m; ≥ 0, and 0 unless overlapping
  std::optional<Vec3> nhat_BA_W;  ///< unit, from B to A: translating A by depth·nhat_BA_W separates the two

  bool operator==(const Penetration&) const = default;
};

/// Index pairs i < j, sorted, without duplicates.
using PairSet = std::vector<std::pair<int, int>>;

/// The answer of a broad phase after one frame. If a subject reports no events, `begun` and `ended` are absent.
struct PairFrame {
  PairSet pairs;                 ///< overlapping pairs among the bodies that are present
  std::optional<PairSet> begun;  ///< pairs of this frame that the previous frame did not have
  std::optional<PairSet> ended;  ///< pairs of the previous frame that this frame does not have

  bool operator==(const PairFrame&) const = default;
};

/// "Which boxes overlap in each frame of the sequence?" One entry per frame.
using PairHistory = std::vector<PairFrame>;

/// One box per body, in the scene's order.
using Bounds = std::vector<Aabb>;

/// One entry per body, in the scene's order; a fixed body has none.
using Masses = std::vector<std::optional<MassProperties>>;

/// "What is the result of the impact at the scene's contact?"
struct Impulse {
  std::array<Velocity, 2> after;  ///< of bodies 0 (A) and 1 (B)
  std::optional<Vec3> P_A_W;      ///< impulse on A at C (N s); B takes its opposite
  std::optional<double>
      error;  ///< claimed: sqrt((P − P*)ᵀ K (P − P*)) is at most this (sqrt(J)), K as in docs/spec/impulse.md
  std::optional<double> ambiguous;  ///< the impact law itself jumps within this relative distance of the scene

  bool operator==(const Impulse&) const = default;
};

/// The pixels of a raster: one string per row, the lowest row first; '1' is a pixel in the set, '0' one outside it.
using Mask = std::vector<std::string>;

/// The overlap of two masks, the second one moved by the raster's shift: how many pixels are in both, and the first of
/// them by row, then column.
struct MaskOverlap {
  int count = 0;
  std::optional<std::pair<int, int>> first;  ///< column, row

  bool operator==(const MaskOverlap&) const = default;
};

/// "Which pixels of the raster do the bodies cover, and in which pixels do bodies 0 (A) and 1 (B) intersect?" Bodies
/// are closed sets.
struct Pixels {
  std::vector<Mask> sampled;       ///< by body: the pixel's centre is in the body's image
  std::vector<Mask> conservative;  ///< by body: contains every pixel whose closed square intersects the body's image
  MaskOverlap overlap;             ///< of A's and B's sampled masks
  Mask meet_sampled;               ///< A and B share a point on the vertical line through the pixel's centre
  Mask meet_conservative;          ///< contains every pixel over whose closed square A and B share a point

  bool operator==(const Pixels&) const = default;
};

/// "When do bodies 0 (A) and 1 (B) first come into contact?" Contact at the start of their motion counts if they
/// approach there.
struct TimeOfImpact {
  enum class Status { hit, miss, undecided };
  Status status = Status::undecided;
  std::optional<double> time;         ///< s; of a hit
  std::optional<Interval> enclosure;  ///< claimed: the bodies are apart before `lo`; a hit occurs no later than `hi`
  std::optional<double> gap;          ///< m; undecided: at some time in the enclosure the bodies are this close

  bool operator==(const TimeOfImpact&) const = default;
};

/// Pose and velocity of one body at one time, in W.
struct State {
  Pose X_WB;
  Velocity velocity;

  bool operator==(const State&) const = default;
};

/// What ended one ballistic motion and started the next. From `time` on, each body moves from its state given here.
struct Event {
  enum class Kind {
    impact,           ///< an impulse at one point
    micro_collision,  ///< one of many impulses that replace a resting contact
    completed,        ///< a sequence of impacts, mostly infinite, summed in closed form until `time`
    contact,          ///< the pair starts to roll, slide or rest on each other, or changes between these
    release,          ///< such a contact ends
    force             ///< an applied force on body a starts, changes or ends; b = −1
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

/// What a simulator says of the solver of its contacts.
struct ContactSolver {
  int steps = 0;        ///< in which contacts were solved
  int unconverged = 0;  ///< steps whose residual exceeds the accuracy that the simulator aims at
  double residual = 0;  ///< m; the greatest over all steps: how far a contact is from its conditions

  bool operator==(const ContactSolver&) const = default;
};

/// "What happens next?" The trajectory until the last sample time of the scene's motion.
struct Trajectory {
  std::vector<std::vector<State>> states;    ///< by sample time, then by body
  std::optional<std::vector<Event>> events;  ///< in the order in which they were resolved
  std::optional<double> complete_until;      ///< s; the time at which the subject gave up: states and events end here
  std::string gave_up;                       ///< why, and at which bodies; empty: did not give up, or does not say
  std::optional<ContactSolver> contact_solver = {};  ///< if contacts were solved in steps, and the subject reports it

  bool operator==(const Trajectory&) const = default;
};

/// The subject does not answer this query; never counted as a pass.
struct Abstains {
  std::string why;

  bool operator==(const Abstains&) const = default;
};

/// The subject failed to answer; always counted as a failure. `refused`: the engine itself says that it does not take
/// this input.
struct Breaks {
  enum class Kind { threw, crashed, hung, garbage, refused };
  Kind kind = Kind::threw;
  std::string how;

  bool operator==(const Breaks&) const = default;
};

/// What a subject returns to a query: the answer, or why there is none.
template <class T>
using Answer = std::variant<T, Abstains, Breaks>;

/// Whether the subject exceeded its time limit.
template <class T>
bool hung(const Answer<T>& answer) {
  const auto* breaks = std::get_if<Breaks>(&answer);
  return breaks != nullptr && breaks->kind == Breaks::Kind::hung;
}

}  // namespace touchstone
