// Which precision counts where a card declares several.
#include <algorithm>
#include <variant>

#include "oracle/subject.h"

namespace touchstone::oracle {
namespace {

const char* name_of(const Sphere&) { return "sphere"; }
const char* name_of(const Box&) { return "box"; }
const char* name_of(const Polytope&) { return "polytope"; }
const char* name_of(const Compound&) { return "compound"; }

bool has(const std::string& name, const Body& body) {
  const auto is = [&](const auto& shape) { return name == name_of(shape); };
  const Compound* compound = std::get_if<Compound>(&body.shape);
  if (compound == nullptr) return std::visit(is, body.shape);
  return is(*compound) || std::ranges::any_of(compound->parts, [&](const Part& p) { return std::visit(is, p.shape); });
}

}  // namespace

Precision precision_for(const Card& card, const std::string& query, const Scene& scene) {
  Precision found = card.precision;
  for (const auto& [part, precision] : card.precision_of) {
    const auto has_part = [&name = part](const Body& body) { return has(name, body); };
    const bool counts = part == query || std::ranges::any_of(scene.bodies, has_part);
    if (counts) found = std::max(found, precision);
  }
  return found;
}

}  // namespace touchstone::oracle
