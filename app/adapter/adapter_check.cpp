#include "app/adapter/adapter_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "app/adapter/compare.h"
#include "app/adapter/mistakes.h"
#include "app/adapter/paper/paper_scene.h"
#include "app/trial/counted_hangs.h"
#include "app/trial/effort.h"
#include "oracle/query.h"

namespace touchstone::app {
namespace {

/// A scene with its answer.
struct Asked {
  PaperScene paper;
  AnyAnswer said;
  bool explained = false;
};

/// All numbers of an answer about distances, depths, boxes, masses or times, in a fixed order; none for other queries,
/// and none for a part that is absent.
struct Numbers {
  template <class T>
  std::vector<double> operator()(const T&) const {
    return {};
  }
  std::vector<double> operator()(const Distance& d) const {
    return d.distance ? std::vector{*d.distance} : std::vector<double>{};
  }
  std::vector<double> operator()(const Penetration& p) const {
    return p.depth ? std::vector{*p.depth} : std::vector<double>{};
  }
  std::vector<double> operator()(const TimeOfImpact& t) const {
    return t.time ? std::vector{*t.time} : std::vector<double>{};
  }
  std::vector<double> operator()(const Bounds& boxes) const {
    std::vector<double> all;
    for (const Aabb& box : boxes) {
      for (const Vec3& corner : {box.lo, box.hi}) all.insert(all.end(), corner.begin(), corner.end());
    }
    return all;
  }
  std::vector<double> operator()(const Masses& masses) const {
    std::vector<double> all;
    for (const auto& mass : masses) {
      if (mass) all.insert(all.end(), {mass->mass, mass->I_BBcm_B(0, 0), mass->I_BBcm_B(1, 1), mass->I_BBcm_B(2, 2)});
    }
    return all;
  }
  std::vector<double> operator()(const Impulse& impulse) const {
    std::vector<double> all;
    for (const Velocity& after : impulse.after) {
      for (const Vec3& v : {after.v_WBcm, after.w_WB}) all.insert(all.end(), v.begin(), v.end());
    }
    return all;
  }
};

/// (expected, said) of each number, if both answers have the same ones.
std::vector<std::pair<double, double>> numbers_of(const Asked& asked) {
  const std::vector<double> expected = std::visit(Numbers{}, asked.paper.expected);
  const std::vector<double> said = std::visit(Numbers{}, asked.said);
  std::vector<std::pair<double, double>> both;
  if (expected.size() != said.size()) return both;
  for (std::size_t i = 0; i < said.size(); ++i) both.emplace_back(expected[i], said[i]);
  return both;
}

std::vector<Asked*> unexplained(std::vector<Asked>& wrong) {
  std::vector<Asked*> all;
  for (Asked& one : wrong) {
    if (!one.explained) all.push_back(&one);
  }
  return all;
}

bool agrees(const std::optional<AnyAnswer>& prediction, const AnyAnswer& said) {
  return prediction && what_is_wrong(*prediction, said).empty();
}

/// How many right answers the mistake would have made wrong.
int contradictions(const Mistake& mistake, const std::string& query, const std::vector<Asked>& right) {
  return static_cast<int>(std::ranges::count_if(
      right, [&](const Asked& one) { return !agrees(predicted(mistake, query, one.paper), one.said); }));
}

/// The mistake that explains most of the answers that are not explained yet, and at least two; of several, the one that
/// contradicts the fewest right answers. It must explain more answers than it contradicts.
std::optional<Hint> best_mistake(const std::string& query, std::vector<Asked>& wrong, const std::vector<Asked>& right) {
  const std::vector<Asked*> open = unexplained(wrong);
  std::vector<Asked*> best;
  int fewest = 0;
  std::string hint;
  for (const Mistake& mistake : mistakes(query)) {
    std::vector<Asked*> explained;
    for (Asked* one : open) {
      if (agrees(predicted(mistake, query, one->paper), one->said)) explained.push_back(one);
    }
    if (explained.size() < 2 || explained.size() < best.size()) continue;
    const int against = contradictions(mistake, query, right);
    if (against >= static_cast<int>(explained.size())) continue;
    if (explained.size() == best.size() && against >= fewest) continue;
    best = explained;
    fewest = against;
    hint = mistake.hint;
  }
  if (best.empty()) return std::nullopt;
  for (Asked* one : best) one->explained = true;
  return Hint{hint, static_cast<int>(best.size())};
}

/// All numbers are too large by one factor or by one length: another unit, or a margin.
std::optional<Hint> one_factor_or_length(std::vector<Asked>& wrong) {
  std::vector<double> ratios, excesses;
  for (const Asked* one : unexplained(wrong)) {
    for (const auto& [expected, said] : numbers_of(*one)) {
      excesses.push_back(said - expected);
      if (std::abs(expected) > 0.1) ratios.push_back(said / expected);
    }
  }
  const auto all_alike = [](const std::vector<double>& values, double allowed) {
    if (values.size() < 4) return false;
    const auto [least, most] = std::ranges::minmax(values);
    return most - least <= allowed * std::max(std::abs(least), std::abs(most));
  };
  std::string hint;
  if (all_alike(ratios, 1e-3))
    hint = fmt::format("every number is {:.4g} times the right one: another unit", ratios[0]);
  if (hint.empty() && all_alike(excesses, 1e-2)) {
    hint =
        fmt::format("every number is off by the same {:+.4g}: a margin, contact offset or convex radius", excesses[0]);
  }
  if (hint.empty()) return std::nullopt;
  const std::vector<Asked*> open = unexplained(wrong);
  for (Asked* one : open) one->explained = true;
  return Hint{hint, static_cast<int>(open.size())};
}

template <class T>
bool has_shape(const Scene& scene) {
  return std::ranges::any_of(scene.bodies, [](const Body& body) { return std::holds_alternative<T>(body.shape); });
}

template <class T>
bool has_mass(const Scene& scene) {
  return std::ranges::any_of(scene.bodies, [](const Body& body) { return std::holds_alternative<T>(body.mass); });
}

/// What some scenes have and others have not.
struct Trait {
  const char* name;
  bool (*has)(const Scene&);
};

constexpr std::array<Trait, 10> traits = {{
    {"a hull", has_shape<Polytope>},
    {"a compound", has_shape<Compound>},
    {"a box", has_shape<Box>},
    {"a ball", has_shape<Sphere>},
    {"given mass properties", has_mass<MassProperties>},
    {"a fixed body", has_mass<Fixed>},
    {"a body that is turned",
     [](const Scene& scene) {
       return std::ranges::any_of(scene.bodies, [](const Body& b) { return b.X_WB.q_WB != Quaternion{}; });
     }},
    {"a centre of mass off the body's origin",
     [](const Scene& scene) {
       return std::ranges::any_of(scene.bodies, [](const Body& b) {
         const auto* known = std::get_if<MassProperties>(&b.mass);
         return known && !known->p_BBcm.isZero();
       });
     }},
    {"a body that spins",
     [](const Scene& scene) {
       return std::ranges::any_of(scene.bodies, [](const Body& b) { return !b.velocity.w_WB.isZero(); });
     }},
    {"friction", [](const Scene& scene) { return scene.contact && scene.contact->friction > 0; }},
}};

/// What all unexplained scenes have, and none that was answered rightly.
std::optional<Hint> common_trait(std::vector<Asked>& wrong, const std::vector<Asked>& right) {
  const std::vector<Asked*> open = unexplained(wrong);
  if (open.size() < 2 || right.empty()) return std::nullopt;
  for (const Trait& trait : traits) {
    const bool all = std::ranges::all_of(open, [&](const Asked* one) { return trait.has(one->paper.scene); });
    const bool others = std::ranges::any_of(right, [&](const Asked& one) { return trait.has(one.paper.scene); });
    if (all && !others) {
      return Hint{fmt::format("wrong in the scenes with {}, and in no other", trait.name),
                  static_cast<int>(open.size())};
    }
  }
  return std::nullopt;
}

std::vector<Hint> hints_for(const std::string& query, std::vector<Asked>& wrong, const std::vector<Asked>& right) {
  constexpr std::size_t most = 3;
  std::vector<Hint> hints;
  while (hints.size() < most) {
    const std::optional<Hint> hint = best_mistake(query, wrong, right);
    if (!hint) break;
    hints.push_back(*hint);
  }
  for (const auto& hint : {one_factor_or_length(wrong), common_trait(wrong, right)}) {
    if (hint && hints.size() < most) hints.push_back(*hint);
  }
  return hints;
}

bool is_float(double x) { return static_cast<double>(static_cast<float>(x)) == x; }

/// The numbers of right answers whose expected values have more than 24 bits: how many, and how many are floats.
struct Floats {
  int all = 0, floats = 0;

  void count(double expected, double said) {
    if (is_float(expected)) return;
    ++all;
    floats += is_float(said);
  }

  void count(const std::optional<Vec3>& expected, const std::optional<Vec3>& said) {
    for (int i = 0; expected && said && i < 3; ++i) count((*expected)[i], (*said)[i]);
  }

  void count(const Asked& asked) {
    for (const auto& [expected, said] : numbers_of(asked)) count(expected, said);
    const auto *expected = std::get_if<Distance>(&asked.paper.expected), *said = std::get_if<Distance>(&asked.said);
    if (!expected || !said) return;
    count(expected->p_WCa, said->p_WCa);
    count(expected->p_WCb, said->p_WCb);
  }
};

/// A part of the answer of the kind T, or why there is none, counted in `checked`.
template <class T>
std::optional<AnyAnswer> answered(const Answer<T>& answer, const PaperScene& paper, CheckedQuery& checked) {
  if (const T* said = std::get_if<T>(&answer)) return AnyAnswer(*said);
  if (std::holds_alternative<Abstains>(answer)) {
    ++checked.abstains;
    return std::nullopt;
  }
  if (checked.faults() == 0) {
    checked.scene = paper.scene.name;
    checked.complaint = std::get<Breaks>(answer).how;
  }
  ++checked.breaks;
  return std::nullopt;
}

CheckedQuery check_query(oracle::Subject& subject, const oracle::Query& query, Floats& floats,
                         const std::function<void(const std::string&)>& asked) {
  CheckedQuery checked;
  checked.query = query.name;
  std::vector<Asked> wrong, right;
  int hangs = 0;
  CountedHangs counted(subject, hangs);
  for (const PaperScene& paper : paper_scenes(query.name)) {
    if (hangs >= most_hangs) break;
    asked(query.name);
    ++checked.asked;
    const auto said = std::visit(
        [&](auto ask) { return answered((static_cast<oracle::Subject&>(counted).*ask)(paper.scene), paper, checked); },
        query.ask);
    if (!said) continue;
    const std::string complaint = what_is_wrong(paper.expected, *said);
    if (!complaint.empty() && checked.faults() == 0) {
      checked.scene = paper.scene.name;
      checked.complaint = complaint;
    }
    ++(complaint.empty() ? checked.right : checked.wrong);
    (complaint.empty() ? right : wrong).push_back({paper, *said});
  }
  for (const Asked& one : right) floats.count(one);
  if (!wrong.empty()) checked.hints = hints_for(query.name, wrong, right);
  return checked;
}

}  // namespace

bool AdapterCheck::is_fault() const {
  return !precision.empty() || std::ranges::any_of(queries, [](const CheckedQuery& query) { return query.is_fault(); });
}

AdapterCheck check_adapter(oracle::Subject& subject, const std::vector<std::string>& queries,
                           const std::function<void(const std::string& query)>& asked) {
  AdapterCheck check;
  Floats floats;
  for (const oracle::Query& query : oracle::queries()) {
    const bool claimed = std::ranges::count(subject.card().answers, query.name) > 0;
    const bool wanted = queries.empty() || std::ranges::count(queries, query.name) > 0;
    if (claimed && wanted) check.queries.push_back(check_query(subject, query, floats, asked));
  }
  if (subject.card().precision != oracle::Precision::binary32 && floats.all >= 8 && floats.floats == floats.all) {
    check.precision = fmt::format(
        "single precision: all {} numbers that need more than 24 bits were answered with 24; say \"precision\": "
        "\"binary32\" on the card, or every rounding counts as an error",
        floats.all);
  }
  return check;
}

}  // namespace touchstone::app
