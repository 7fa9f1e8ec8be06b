#include "app/report/page/marks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <string_view>
#include <variant>

#include "app/report/wire_part.h"
#include "oracle/truth/truth.h"

namespace touchstone::app {
namespace {

using oracle::Point;
using oracle::Real;

/// The numbers of a text in their order: a finding says what its subject claims in words.
std::vector<Real> numbers_in(std::string_view text) {
  std::vector<Real> numbers;
  const char* const end = text.data() + text.size();
  for (const char* at = text.data(); at != end;) {
    double number = 0;
    const auto [rest, error] = std::from_chars(at, end, number);
    const bool is_number = error == std::errc{} && (*at == '-' || ('0' <= *at && *at <= '9'));
    if (is_number) numbers.push_back(number);
    at = is_number ? rest : at + 1;
  }
  return numbers;
}

Point point_at(const std::vector<Real>& numbers, std::size_t k) { return {numbers[k], numbers[k + 1], numbers[k + 2]}; }

std::string metres(Real length) { return fmt::format("{:.4g} m", static_cast<double>(length)); }

std::string key_of(const char* what, const std::string& exact, const std::string& claim) {
  return fmt::format("{}: <span class=\"exact\">exact{}</span>, <span class=\"claim\">claimed{}</span> (dashed)", what,
                     exact, claim);
}

Marks distance_marks(const oracle::Case& a_case) {
  Marks marks = marks_of(a_case.scene);
  if (marks.lines.empty()) return marks;
  const std::vector<Real> said = numbers_in(a_case.finding.observed);
  const Mark exact = marks.lines[0];
  const Real length = (exact.to - exact.from).norm();
  if (a_case.property == "distance.value" && said.size() == 1 && length > 0) {
    marks.lines.push_back({"claim", exact.from, exact.from + (exact.to - exact.from) * (said[0] / length)});
    marks.key = key_of("distance", " " + metres(length), " " + metres(said[0]));
  }
  if (a_case.property == "distance.witnesses_on_bodies" && said.size() == 8) {
    marks.lines.push_back({"claim", point_at(said, 0), point_at(said, 4)});
    marks.key = key_of("closest points", "", "");
  }
  return marks;
}

bool is_compound(const Body& body) { return std::holds_alternative<Compound>(body.shape); }

/// A's lowest point along the direction.
Point lowest(const WirePart& part, const Point& direction) {
  const Point& p = *std::ranges::min_element(part.points, {}, [&](const Point& q) { return q.dot(direction); });
  return p - part.radius * direction;
}

Marks depth_marks(const oracle::Case& a_case) {
  const Scene& scene = a_case.scene;
  const std::vector<Real> said = numbers_in(a_case.finding.observed);
  const bool depth = a_case.property == "penetration.depth" && said.size() == 1;
  const bool translation = a_case.property == "penetration.separates" && said.size() == 5;
  if ((!depth && !translation) || scene.bodies.size() != 2 || std::ranges::any_of(scene.bodies, is_compound)) return {};
  const reference::PenetrationTruth& truth = oracle::truth::penetration(scene);
  const Point direction = truth.nhat_BA_W.cast<Real>();
  const Point from = lowest(wire_parts(scene).front(), direction);
  const Point claimed = depth ? direction : point_at(said, 1);
  return {{{"exact", from, from + truth.depth.hi * direction, true}, {"claim", from, from + said[0] * claimed, true}},
          key_of("translation of A that separates", " " + metres(truth.depth.hi), " " + metres(said[0]))};
}

Point middle_of(const std::vector<WirePart>& parts, int body) {
  Point sum = Point::Zero();
  Real count = 0;
  for (const WirePart& part : parts) {
    if (part.body != body) continue;
    for (const Point& p : part.points) sum += p, ++count;
  }
  return sum / count;
}

Marks velocity_marks(const oracle::Case& a_case, Real extent) {
  const Scene& scene = a_case.scene;
  const std::vector<Real> said = numbers_in(a_case.finding.observed);
  if (!a_case.finding.observed.starts_with("A: v (") || said.size() != 12 || !scene.contact) return {};
  const reference::ImpulseTruth& truth = oracle::truth::impulse(scene);
  const std::vector<WirePart> parts = wire_parts(scene);
  Marks marks;
  Real longest = 0;
  const auto add = [&](const char* style, const Point& from, const Point& v) {
    longest = std::max(longest, v.norm());
    marks.lines.push_back({style, from, v, true});
  };
  for (const int i : {0, 1}) {
    const auto b = static_cast<std::size_t>(i);
    const Point from = middle_of(parts, i);
    const reference::ExactVec3& after = truth.after[b].v_WBcm;
    add("before", from, scene.bodies[b].velocity.v_WBcm.cast<Real>());
    add("exact", from, {after[0].nearest(), after[1].nearest(), after[2].nearest()});
    add("claim", from, point_at(said, 6 * b));
  }
  if (!(longest > 0)) return {};
  for (Mark& mark : marks.lines) mark.to = mark.from + mark.to * (extent / 2 / longest);
  std::erase_if(marks.lines, [](const Mark& mark) { return mark.from == mark.to; });
  marks.key =
      "velocities: <span class=\"before\">before</span> (dotted), after: <span class=\"exact\">exact</span>, "
      "<span class=\"claim\">claimed</span> (dashed)";
  return marks;
}

}  // namespace

Marks marks_of(const Scene& scene) {
  if (scene.bodies.size() != 2) return {};
  const reference::DistanceTruth& truth = oracle::truth::distance(scene);
  if (truth.verdict == Verdict::overlapping) return {};
  return {{{"exact", truth.p_WCa.cast<Real>(), truth.p_WCb.cast<Real>()}}, ""};
}

Marks marks_of(const oracle::Case& a_case, Real extent) {
  Marks marks;
  if (!a_case.changed) {
    if (a_case.property.starts_with("distance.")) marks = distance_marks(a_case);
    if (a_case.property.starts_with("penetration.")) marks = depth_marks(a_case);
    if (a_case.property.starts_with("impulse.")) marks = velocity_marks(a_case, extent);
  }
  return marks.lines.empty() ? marks_of(a_case.scene) : marks;
}

}  // namespace touchstone::app
