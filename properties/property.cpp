#include "properties/property.h"

#include <algorithm>

#include "model/input_error.h"
#include "model/near_names.h"
#include "oracle/query.h"
#include "oracle/with_card.h"
#include "properties/cases/time_of_impact_case.h"
#include "properties/cases/timeline.h"
#include "properties/queries.h"

namespace touchstone::properties {
namespace {

/// Of sequences broad_phase asks another query, of which a card may declare another precision.
std::string asked_query(const Property& property) {
  return property.id.starts_with("broad_phase.film.") ? "pair_history" : property.query;
}

/// The same property; it judges by the precision that the card declares for the query and the scene's shapes.
Property in_its_precision(Property property) {
  property.check = [check = property.check, query = asked_query(property)](const Scene& scene,
                                                                           oracle::Subject& subject) {
    const oracle::Precision precision = oracle::precision_for(subject.card(), query, scene);
    if (precision == subject.card().precision) return check(scene, subject);
    oracle::Card card = subject.card();
    card.precision = precision;
    oracle::WithCard seen(subject, std::move(card));
    return check(scene, seen);
  };
  return property;
}

/// The same property where bodies do not overlap at the start. That is bad input, which a subject may refuse; only the
/// form, survival and repetition of an answer are asked there.
Property of_valid_start(Property property) {
  const bool is_of_pair = property.query == "time_of_impact";
  if (!is_of_pair && property.query != "simulation" && property.query != "constraint") return property;
  const auto is_named = [&](const char* law) { return property.id == property.query + "." + law; };
  const bool is_of_any_answer = is_named("survives") || is_named("repeats") || is_named("ordered");
  property.check = [check = property.check, is_of_pair, is_of_any_answer](const Scene& scene,
                                                                          oracle::Subject& subject) {
    const bool is_motion = scene.motion && (!is_of_pair || scene.bodies.size() == 2);
    if (!is_motion || !(is_of_pair ? is_refused(scene) : overlap_at_start(scene))) return check(scene, subject);
    const oracle::Finding outside = oracle::judge::outside("the bodies overlap at the start");
    if (!is_of_any_answer) return outside;
    const oracle::Finding found = check(scene, subject);
    const bool is_refusal = found.defect == oracle::Defect::threw || found.defect == oracle::Defect::refused;
    return is_refusal ? outside : found;
  };
  return property;
}

std::vector<Property> join() {
  std::vector<Property> joined;
  for (const auto& query : {mass_properties,
                            bounds_properties,
                            broad_phase_properties,
                            broad_phase_sequence_properties,
                            distance_properties,
                            penetration_properties,
                            pixel_properties,
                            impulse_properties,
                            impulse_law_properties,
                            time_of_impact_properties,
                            simulation_properties,
                            simulation_lockstep_properties,
                            simulation_meeting_properties,
                            simulation_law_properties,
                            simulation_scene_properties,
                            simulation_causality_properties,
                            simulation_face_properties,
                            simulation_carrier_properties,
                            simulation_together_properties,
                            simulation_instant_properties,
                            simulation_same_run_properties,
                            simulation_exact_ball_properties,
                            simulation_impulse_properties,
                            simulation_completed_properties,
                            simulation_lasting_contact_properties,
                            simulation_face_impulse_properties,
                            constraint_properties,
                            constraint_event_properties,
                            constraint_motion_properties,
                            work_properties}) {
    for (Property& property : query()) joined.push_back(in_its_precision(of_valid_start(std::move(property))));
  }
  std::ranges::stable_sort(joined, {}, [names = oracle::query_names()](const Property& property) {
    return std::ranges::find(names, property.query) - names.begin();
  });
  return joined;
}

std::string unknown(const std::string& id) {
  std::vector<std::string> ids;
  for (const Property& property : all()) ids.push_back(property.id);
  const std::string suggestion = did_you_mean(id, ids);
  return "unknown; " + (suggestion.empty() ? "`touchstone list properties` names them" : suggestion);
}

}  // namespace

const std::vector<Property>& all() {
  static const std::vector<Property> properties = join();
  return properties;
}

const std::vector<std::string>& tested_queries() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> tested = oracle::query_names();
    std::erase_if(tested,
                  [](const std::string& name) { return std::ranges::count(all(), name, &Property::query) == 0; });
    return tested;
  }();
  return names;
}

const Property& find(const std::string& id) {
  const auto found = std::ranges::find(all(), id, &Property::id);
  if (found == all().end()) throw InputError("property " + id, unknown(id));
  return *found;
}

}  // namespace touchstone::properties
