// How a canary lies: it asks a truthful subject and changes the answer.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "oracle/subjects/canaries.h"

namespace touchstone::oracle::subjects {

/// Changes an answer in place; may ask the truthful subject more.
template <class T>
using Lie = std::function<void(Subject& truthful, const Scene& scene, T& answer)>;

/// Absent: the truth.
struct Lies {
  Lie<Masses> mass;
  Lie<Bounds> bounds;
  Lie<PairSet> broad_phase;
  Lie<PairHistory> pair_history;
  Lie<Distance> distance;
  Lie<Penetration> penetration;
  Lie<Impulse> impulse;
  Lie<Pixels> pixel;
  Lie<TimeOfImpact> time_of_impact;
  Lie<Trajectory> simulation;
  Lie<Trajectory> constraint;
  bool two_valued = false;  ///< does not know touching
  bool breaks = false;      ///< answers every query by Breaks
};

/// The lies are made anew for each subject, so that what they remember is that subject's own.
Canary lying(const std::string& id, const std::string& says, std::function<Lies()> make_lies);

/// The canaries by what they lie about.
std::vector<Canary> canaries_about_pairs_of_bodies();
std::vector<Canary> canaries_about_closest_features();
std::vector<Canary> canaries_about_boxes();
std::vector<Canary> canaries_about_films();
std::vector<Canary> canaries_about_mass();
std::vector<Canary> canaries_about_impacts();
std::vector<Canary> canaries_about_pixels();
std::vector<Canary> canaries_about_flights();
std::vector<Canary> canaries_about_simulations();
std::vector<Canary> canaries_about_constraints();
std::vector<Canary> canaries_about_anything();

/// Calls f on a query's plain answer; nothing if there is none.
template <class T, class F>
void with(const Answer<T>& answer, F&& f) {
  if (const T* said = std::get_if<T>(&answer)) f(*said);
}

/// The exact distance of the pair, by the truthful subject; 0 if it says none.
double distance_by(Subject& truthful, const Scene& scene);

/// A shape's vertices in its body's frame: enough for a lie, so a sphere has those of its cube, a compound its parts'
/// unturned.
std::vector<Vec3> corners(const Body& body);

}  // namespace touchstone::oracle::subjects
