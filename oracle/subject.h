// A subject is what is being tested. It answers the queries that it offers and abstains from the others.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "model/answers.h"
#include "model/scene.h"
#include "oracle/domain.h"
#include "oracle/dynamics.h"
#include "oracle/work.h"

namespace touchstone::oracle {

/// The arithmetic in which the subject computes: rational, or with 53 or 24 bits. Allowed errors follow from it.
enum class Precision { exact, binary64, binary32 };

/// A known departure from the specification, as data. It explains a failing row but does not excuse it.
struct Deviation {
  std::string clause;
  std::string what;
  std::string link;
};

/// How a time-stepping engine integrates motions.
struct Stepping {
  double step = 0;  ///< s; the longest step
  int order = 1;    ///< of the method: 1 for explicit, semi-implicit and implicit Euler steps, 2 for Verlet or midpoint

  bool operator==(const Stepping&) const = default;
};

/// Which box of a body it answers: the least one; the turned one about a hull or compound in the body's own axes; or
/// one between the least and that of the ball about the body's box in its own axes.
enum class BoxKind { tight, of_turned_box, of_ball };

/// A subject's description of itself.
struct Card {
  std::string name;     ///< "bullet.double"
  std::string version;  ///< the version that the engine reports
  Precision precision = Precision::binary64;
  std::vector<std::string> answers;  ///< the queries it claims, by their names in oracle/query.h
  bool knows_touching = false;       ///< verdicts have three values, not two
  double broad_phase_margin = 0;     ///< m, on each side of a box; boxes closer than twice this may be a pair
  std::string about;                 ///< one line: which functions of the engine are called, with which settings
  std::string homepage;
  std::vector<Deviation> deviations;
  Domain domain = {};  ///< the scenes by which it wants to be judged; others are asked too, and counted apart
  DistanceTolerance distance_tolerance = {};
  ContactTolerance contact_tolerance = {};  ///< of `time_of_impact`
  BoxKind boxes = BoxKind::tight;
  std::map<std::string, Precision> precision_of =
      {};  ///< by query, or by a shape that a scene has: the coarsest counts
  Dynamics dynamics = {};
  std::vector<std::string> reproduces = {};  ///< the queries for which it writes a snippet
  std::optional<Stepping> stepping = {};     ///< of `simulation`; `simulation` grants the errors that it explains
  std::vector<WorkLimit> work_limits = {};   ///< of the queries whose work it counts
};

/// The precision in which the subject answers the query about the scene.
Precision precision_for(const Card& card, const std::string& query, const Scene& scene);

/// An adapter overrides the queries that its engine answers. It never repairs the engine's answer. An exception that
/// leaves a query also leaves Property::check (properties/property.h); only where the subject runs in a process of its
/// own it is caught, and counted as `Breaks`.
class Subject {
 public:
  virtual ~Subject() = default;

  virtual const Card& card() const = 0;

  virtual Answer<Masses> mass(const Scene&) { return Abstains{"no mass query"}; }
  virtual Answer<Bounds> bounds(const Scene&) { return Abstains{"no bounds query"}; }
  virtual Answer<PairSet> broad_phase(const Scene&) { return Abstains{"no broad phase"}; }
  virtual Answer<PairHistory> pair_history(const Scene&) { return Abstains{"no broad phase over frames"}; }
  virtual Answer<Distance> distance(const Scene&) { return Abstains{"no distance query"}; }
  virtual Answer<Penetration> penetration(const Scene&) { return Abstains{"no penetration query"}; }
  virtual Answer<Impulse> impulse(const Scene&) { return Abstains{"no impulse query"}; }
  virtual Answer<Pixels> pixel(const Scene&) { return Abstains{"no pixel query"}; }
  virtual Answer<TimeOfImpact> time_of_impact(const Scene&) { return Abstains{"no time of impact"}; }
  virtual Answer<Trajectory> simulation(const Scene&) { return Abstains{"no simulation"}; }
  virtual Answer<Trajectory> constraint(const Scene&) { return Abstains{"no constraint-based simulation"}; }

  /// A program in the engine's own API that prints `expected`, if it is not empty, asks the engine the query about the
  /// scene and prints what it says.
  virtual Answer<std::string> reproduce(const std::string& /*query*/, const Scene&, const std::string& /*expected*/) {
    return Abstains{"no snippets"};
  }

  /// What the answer to the query about the scene takes.
  virtual Answer<Work> work(const std::string& /*query*/, const Scene&) { return Abstains{"does not count its work"}; }
};

}  // namespace touchstone::oracle
