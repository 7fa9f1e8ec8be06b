// The clauses of docs/spec/constraint.md about bodies of any number and shape, as executable properties. They are laws
// of docs/spec/simulation.md, asked of a trajectory in steps.
#include <algorithm>
#include <iterator>
#include <string>

#include "oracle/judge/judge.h"
#include "oracle/tolerance/constraint.h"
#include "properties/queries.h"

namespace touchstone::properties {
namespace {

using oracle::Finding;
using oracle::Subject;

/// Answers `simulation` about a scene with its answer to `constraint`, as of a method of order 1 whose steps are those
/// that are granted. Which events are due differs between the two queries, so none are passed on.
class InSteps final : public Subject {
 public:
  InSteps(const Scene& scene, Subject& subject) : subject_(subject), card_(subject.card()) {
    card_.stepping = oracle::Stepping{oracle::tolerance::granted_step(scene), 1};
  }

  const oracle::Card& card() const override { return card_; }

  Answer<Trajectory> simulation(const Scene& scene) override {
    Answer<Trajectory> answer = subject_.constraint(scene);
    if (auto* said = std::get_if<Trajectory>(&answer)) said->events.reset();
    return answer;
  }

 private:
  Subject& subject_;
  oracle::Card card_;
};

/// A law of simulations that holds for `constraint` too, and the clause that says so.
struct Shared {
  const char* law;     ///< "slides", of `simulation.slides`
  const char* clause;  ///< the number of TS-CONSTRAINT
};

constexpr Shared shared[] = {
    {"alone", "14"},          {"slides", "15"},      {"turns", "15"},   {"carried", "16"},
    {"rests", "17"},          {"supported", "17"},   {"bounces", "18"}, {"angular_momentum", "19"},
    {"level_momentum", "20"}, {"face_impulse", "21"}};

Property in_steps(Property law, const Shared& as) {
  law.id = std::string("constraint.") + as.law;
  law.query = "constraint";
  law.clauses = {std::string("TS-CONSTRAINT-") + as.clause};
  law.check = [check = law.check](const Scene& scene, Subject& subject) {
    if (!scene.motion) return oracle::judge::outside("no motion");
    InSteps stepper(scene, subject);
    return check(scene, stepper);
  };
  return law;
}

}  // namespace

std::vector<Property> constraint_motion_properties() {
  std::vector<Property> of_simulation;
  for (const auto& part : {simulation_law_properties, simulation_scene_properties, simulation_face_properties,
                           simulation_carrier_properties, simulation_face_impulse_properties}) {
    std::ranges::move(part(), std::back_inserter(of_simulation));
  }
  std::vector<Property> properties;
  for (const Shared& as : shared) {
    const auto law = std::ranges::find(of_simulation, std::string("simulation.") + as.law, &Property::id);
    properties.push_back(in_steps(*law, as));
  }
  return properties;
}

}  // namespace touchstone::properties
