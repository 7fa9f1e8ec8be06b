// The properties of each query, in the order of the five families: agrees, laws, bounds, survives, repeats.
#pragma once

#include <vector>

#include "properties/property.h"

namespace touchstone::properties {

/// The lists that properties::all() is made of.
std::vector<Property> mass_properties();
std::vector<Property> bounds_properties();
std::vector<Property> broad_phase_properties();
std::vector<Property> broad_phase_sequence_properties();
std::vector<Property> distance_properties();
std::vector<Property> penetration_properties();
std::vector<Property> pixel_properties();
std::vector<Property> impulse_properties();
std::vector<Property> impulse_law_properties();
std::vector<Property> time_of_impact_properties();
std::vector<Property> simulation_properties();
std::vector<Property> simulation_lockstep_properties();
std::vector<Property> simulation_meeting_properties();
std::vector<Property> simulation_law_properties();
std::vector<Property> simulation_scene_properties();
std::vector<Property> simulation_causality_properties();
std::vector<Property> simulation_face_properties();
std::vector<Property> simulation_carrier_properties();
std::vector<Property> simulation_together_properties();
std::vector<Property> simulation_instant_properties();
std::vector<Property> simulation_same_run_properties();
std::vector<Property> simulation_exact_ball_properties();
std::vector<Property> simulation_impulse_properties();
std::vector<Property> simulation_lasting_contact_properties();
std::vector<Property> simulation_completed_properties();
std::vector<Property> simulation_face_impulse_properties();
std::vector<Property> constraint_properties();
std::vector<Property> constraint_event_properties();
std::vector<Property> constraint_motion_properties();
std::vector<Property> work_properties();

}  // namespace touchstone::properties
