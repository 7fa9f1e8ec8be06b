// The clauses of docs/spec/mass.md as executable properties.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <functional>
#include <limits>

#include "oracle/judge/words.h"
#include "oracle/tolerance/tolerance.h"
#include "oracle/truth/truth.h"
#include "properties/judging/asking.h"
#include "properties/queries.h"
#include "properties/transforms/body.h"
#include "properties/transforms/scene.h"

namespace touchstone::properties {
namespace {

using oracle::Defect;
using oracle::Finding;
using oracle::Subject;
using oracle::tolerance::MassBound;
using reference::MassTruth;
namespace judge = oracle::judge;
namespace tolerance = oracle::tolerance;
namespace truth = oracle::truth;
namespace words = oracle::words;

// The judged quantities of a body: mass, coordinates of the centre of mass, entries of the inertia.
enum class Part { mass, centre, inertia };

std::vector<double> numbers(const MassProperties& m, Part part) {
  const Mat3& I = m.I_BBcm_B;
  if (part == Part::mass) return {m.mass};
  if (part == Part::centre) return {m.p_BBcm.x(), m.p_BBcm.y(), m.p_BBcm.z()};
  return {I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2)};
}

std::vector<Interval> enclosures(const MassTruth& m, Part part) {
  if (part == Part::mass) return {m.mass};
  if (part == Part::centre) return {m.p_BBcm.begin(), m.p_BBcm.end()};
  return {m.I_BBcm_B.begin(), m.I_BBcm_B.end()};
}

double bound(const Body& body, Part part, oracle::Precision precision) {
  const auto* given = std::get_if<MassProperties>(&body.mass);
  const MassBound all = given ? tolerance::mass_as_kept(*given, precision) : tolerance::mass(body, precision);
  return part == Part::mass ? all.mass : part == Part::centre ? all.centre : all.inertia;
}

// Measures errors in ulps of the mass, of the body's radius, or of mass times size squared.
judge::Allowance allowance(const Body& body, const MassTruth& exact, Part part, double bound,
                           oracle::Precision precision) {
  const double u = oracle::unit_roundoff(precision), m = exact.mass.hi, size = tolerance::size(body);
  const auto& I = exact.I_BBcm_B;
  const double radius = tolerance::radius(body), moment = std::max({I[0].lo, I[1].lo, I[2].lo});
  if (part == Part::mass) return {bound, u * m, "ulps of the mass", 0, exact.mass.lo};
  if (part == Part::centre) return {bound, u * radius, "ulps of the body's radius", size, radius};
  return {bound, u * m * size * size, "ulps of mass times size squared", 0, moment};
}

// The worse of two findings.
const Finding& worse(const Finding& a, const Finding& b) {
  const auto badness = [](const Finding& f) {
    return std::pair(f.outcome == oracle::Outcome::fails, f.error / (f.allowed + 1));
  };
  return badness(a) < badness(b) ? b : a;
}

// Can the subject's precision represent the exact mass properties? They must be normal numbers: a rounded subnormal is
// off by more than any bound of oracle/tolerance/tolerance.h, and an overflow is infinite in any arithmetic of that
// precision.
bool sayable(const MassTruth& exact, oracle::Precision precision) {
  const bool single = precision == oracle::Precision::binary32;
  const double least = single ? std::numeric_limits<float>::min() : std::numeric_limits<double>::min();
  const double most = single ? std::numeric_limits<float>::max() : std::numeric_limits<double>::max();
  const auto normal = [&](const Interval& i) { return i.lo >= least && i.hi <= most; };
  const auto no_overflow = [&](const Interval& i) { return i.lo >= -most && i.hi <= most; };
  return normal(exact.mass) && std::ranges::all_of(exact.p_BBcm, no_overflow) &&
         std::all_of(exact.I_BBcm_B.begin(), exact.I_BBcm_B.begin() + 3, normal);
}

// Queries the subject only if its precision can represent every exact answer.
template <std::invocable Ask>
Finding of_sayable(const Scene& scene, Subject& subject, Ask&& ask) {
  return of_scene(scene, subject, [&] {
    const auto precision = subject.card().precision;
    const bool all = std::ranges::all_of(truth::mass(scene), [&](const std::optional<MassTruth>& exact) {
      return !exact || sayable(*exact, precision);
    });
    return all ? ask() : judge::outside("the exact mass or inertia is beyond the range of the subject's precision");
  });
}

// Fails an answer that does not have one entry per body, empty exactly for the fixed bodies. Passes any other answer to
// judge_it(const Masses&).
template <class JudgeIt>
Finding given_masses(const Scene& scene, Subject& subject, JudgeIt&& judge_it) {
  return judge::given(subject.mass(scene), [&](const Masses& said) {
    const bool one_a_body = std::ranges::equal(said, scene.bodies, [](const auto& m, const Body& body) {
      return m.has_value() != std::holds_alternative<Fixed>(body.mass);
    });
    if (!one_a_body) {
      return judge::wrong(Defect::wrong_mass, "entries that do not fit the bodies",
                          "one entry per body, empty for a fixed body");
    }
    return judge_it(said);
  });
}

template <class JudgeIt>
Finding of_masses(const Scene& scene, Subject& subject, JudgeIt&& judge_it) {
  return of_sayable(scene, subject, [&] { return given_masses(scene, subject, judge_it); });
}

// Agreement with the exact answer

Finding no_mass(const MassProperties& said, const MassTruth& exact, oracle::Precision precision) {
  const double u = oracle::unit_roundoff(precision);
  return judge::wrong_by(exact.mass.hi - said.mass, {0, u * exact.mass.hi, "ulps of the mass", 0, exact.mass.lo},
                         Defect::wrong_mass, "mass " + words::text(said.mass), words::text(exact.mass));
}

Finding agrees(const Scene& scene, Subject& subject, Part part) {
  return of_masses(scene, subject, [&](const Masses& said) {
    const auto precision = subject.card().precision;
    const auto& exact = truth::mass(scene);
    Finding worst;
    for (std::size_t i = 0; i < said.size(); ++i) {
      if (!said[i]) continue;
      const std::vector<double> claimed = numbers(*said[i], part);
      const std::vector<Interval> enclosed = enclosures(*exact[i], part);
      const judge::Allowance allowed =
          allowance(scene.bodies[i], *exact[i], part, bound(scene.bodies[i], part, precision), precision);
      for (std::size_t k = 0; k < claimed.size(); ++k) {
        worst = worse(worst, judge::near(claimed[k], enclosed[k], allowed, Defect::wrong_mass, Defect::wrong_mass));
      }
    }
    return worst;
  });
}

// Physical bounds

// The inertia ∫(y² + z²), ... of any mass distribution is symmetric, its principal moments are > 0, and none exceeds
// the sum of the two others.
Finding possible(const Scene& scene, Subject& subject) {
  return of_masses(scene, subject, [&](const Masses& said) {
    const auto precision = subject.card().precision;
    const auto& exact = truth::mass(scene);
    Finding worst;
    for (std::size_t i = 0; i < said.size(); ++i) {
      if (!said[i]) continue;
      if (!(said[i]->mass > 0)) return no_mass(*said[i], *exact[i], precision);
      const Mat3& I = said[i]->I_BBcm_B;
      const Vec3 lambda = Eigen::SelfAdjointEigenSolver<Mat3>(I, Eigen::EigenvaluesOnly).eigenvalues();  // ascending
      const double impossible =
          std::max({-lambda[0], lambda[2] - lambda[1] - lambda[0], (I - I.transpose()).cwiseAbs().maxCoeff()});
      // Each eigenvalue is off by at most the norm of the matrix error, 3 times the bound of an entry, and three
      // eigenvalues are added. The solver's own error is some ulps of the norm.
      const double eigenvalues = 9 * bound(scene.bodies[i], Part::inertia, precision) + 64 * 0x1p-53 * I.stableNorm();
      worst = worse(
          worst, judge::at_most(
                     impossible, allowance(scene.bodies[i], *exact[i], Part::inertia, eigenvalues, precision),
                     Defect::wrong_mass, [&] { return "principal moments " + words::text(lambda); },
                     [] { return std::string("principal moments > 0, none greater than the sum of the other two"); }));
    }
    return worst;
  });
}

// Laws: how the answer follows a change of the scene

// Predicts the second answer from the first. `times` are the factors on (mass, centre, inertia).
struct Law {
  std::function<MassProperties(MassProperties, const Body&)> predict;
  MassBound times = {1, 1, 1};
};

double factor(const Law& law, Part part) {
  return part == Part::mass ? law.times.mass : part == Part::centre ? law.times.centre : law.times.inertia;
}

double widest(const MassTruth& m, Part part) {
  double width = 0;
  for (const Interval& i : enclosures(m, part)) width = std::max(width, i.hi - i.lo);
  return width;
}

// The truths obey the law, and each is known to the width of its enclosure. So the two answers obey it to within their
// bounds and those widths.
Finding obeys(const Scene& before, const std::optional<Scene>& moved, const Law& law, Subject& subject, Defect defect) {
  const bool uniform =
      std::ranges::all_of(before.bodies, [](const Body& b) { return std::holds_alternative<Density>(b.mass); });
  if (!uniform || before.bodies.empty())
    return judge::outside("mass properties that are given, not computed from the shape");
  return of_moved(moved, subject, [&](const Scene& after) {
    return of_masses(before, subject, [&](const Masses& first) {
      return of_masses(after, subject, [&](const Masses& second) {
        const auto precision = subject.card().precision;
        const auto& truth_before = truth::mass(before);
        const auto& truth_after = truth::mass(after);
        Finding worst;
        for (std::size_t i = 0; i < first.size(); ++i) {
          const MassProperties predicted = law.predict(*first[i], before.bodies[i]);
          for (const Part part : {Part::mass, Part::centre, Part::inertia}) {
            const double allowed =
                factor(law, part) * (bound(before.bodies[i], part, precision) + widest(*truth_before[i], part)) +
                bound(after.bodies[i], part, precision) + widest(*truth_after[i], part);
            const std::vector<double> expected = numbers(predicted, part), got = numbers(*second[i], part);
            for (std::size_t k = 0; k < got.size(); ++k) {
              worst = worse(worst, judge::near(got[k], {expected[k], expected[k]},
                                               allowance(after.bodies[i], *truth_after[i], part, allowed, precision),
                                               defect, defect));
            }
          }
        }
        return worst;
      });
    });
  });
}

const Law unchanged{[](const MassProperties& m, const Body&) { return m; }};

Finding pose_free(const Scene& scene, Subject& subject) {
  return obeys(scene, half_turned(scene), unchanged, subject, Defect::moved_with_frame);
}

Finding relabels(const Scene& scene, Subject& subject) {
  return obeys(scene, relabelled(scene), unchanged, subject, Defect::relabelled);
}

Finding turns(const Scene& scene, Subject& subject) {
  const Law law{[](MassProperties m, const Body&) {
    const Mat3 rows = (Mat3() << m.I_BBcm_B.row(2), m.I_BBcm_B.row(0), m.I_BBcm_B.row(1)).finished();
    m.I_BBcm_B << rows.col(2), rows.col(0), rows.col(1);
    m.p_BBcm = turned(m.p_BBcm);
    return m;
  }};
  return obeys(scene, turned_in_body(scene), law, subject, Defect::relabelled);
}

Finding shifts(const Scene& scene, Subject& subject) {
  const Law law{[](MassProperties m, const Body& body) {
    m.p_BBcm += shift_in_body(body);
    return m;
  }};
  return obeys(scene, shifted_in_body(scene), law, subject, Defect::moved_with_frame);
}

Law scaling(double mass, double centre, double inertia) {
  return {[=](MassProperties m, const Body&) {
            return MassProperties{mass * m.mass, centre * m.p_BBcm, inertia * m.I_BBcm_B};
          },
          {mass, centre, inertia}};
}

Finding scales(const Scene& scene, Subject& subject) {
  return obeys(scene, scaled(scene, 10), scaling(0x1p30, 0x1p10, 0x1p50), subject, Defect::scaled);
}

Finding density(const Scene& scene, Subject& subject) {
  return obeys(scene, denser(scene, 3), scaling(8, 1, 8), subject, Defect::scaled);
}

// Robustness and determinism

// Needs no entry for each body, which mass.mass asks for.
Finding lives(const Scene& scene, Subject& subject) {
  return of_sayable(scene, subject, [&] {
    return judge::given(subject.mass(scene), [&](const Masses& said) {
      const auto& exact = truth::mass(scene);
      for (std::size_t i = 0; i < std::min(said.size(), exact.size()); ++i) {
        if (said[i] && exact[i] && !(said[i]->mass > 0)) return no_mass(*said[i], *exact[i], subject.card().precision);
      }
      return judge::holds();
    });
  });
}

Finding again(const Scene& scene, Subject& subject) {
  return of_sayable(scene, subject, [&] { return repeats(&Subject::mass, scene, swapped(scene), subject); });
}

auto judging(Part part) {
  return [part](const Scene& scene, Subject& subject) { return agrees(scene, subject, part); };
}

}  // namespace

std::vector<Property> mass_properties() {
  return {
      {"mass.mass",
       "mass",
       {"TS-MASS-1"},
       "the mass is density times the exact volume within rounding",
       judging(Part::mass)},
      {"mass.centre",
       "mass",
       {"TS-MASS-2"},
       "the centre of mass is the exact centroid within rounding",
       judging(Part::centre)},
      {"mass.inertia",
       "mass",
       {"TS-MASS-3"},
       "the inertia about the centre of mass is the exact one within rounding",
       judging(Part::inertia)},
      {"mass.pose_free",
       "mass",
       {"TS-MASS-5"},
       "a body's pose does not change its mass properties in its own frame",
       pose_free},
      {"mass.turned",
       "mass",
       {"TS-MASS-6"},
       "permuting the body's axes permutes those of the centre of mass and of the inertia",
       turns},
      {"mass.shifted",
       "mass",
       {"TS-MASS-6"},
       "translating the shape in its frame translates the centre of mass and keeps the inertia about it",
       shifts},
      {"mass.scaled",
       "mass",
       {"TS-MASS-7"},
       "scaling lengths by s scales mass by s³, centre of mass by s, inertia by s⁵",
       scales},
      {"mass.density",
       "mass",
       {"TS-MASS-7"},
       "scaling density by s scales mass and inertia by s, and keeps the centre of mass",
       density},
      {"mass.relabelled", "mass", {"TS-MASS-8"}, "the order of a polytope's vertices changes nothing", relabels},
      {"mass.possible",
       "mass",
       {"TS-MASS-4"},
       "the inertia is physically possible: positive principal moments that obey the triangle inequality",
       possible},
      {"mass.survives", "mass", {"TS-MASS-9"}, "every valid body has an answer: finite, with mass > 0", lives},
      {"mass.repeats", "mass", {"TS-MASS-10"}, "the same query has the same answer, bit for bit", again},
  };
}

}  // namespace touchstone::properties
