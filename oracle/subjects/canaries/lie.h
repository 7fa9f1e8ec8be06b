// How a canary lies: it asks a truthful subject and changes the answer.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "oracle/subjects/canaries/canaries.h"

namespace touchstone::oracle::subjects {

/// Changes an answer in place. It may ask the truthful subject further questions.
template <class T>
using Lie = std::function<void(Subject& truthful, const Scene& scene, T& answer)>;

/// The lies of one canary. An absent lie means that the query is answered truthfully.
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
  bool two_valued = false;                    ///< reports touching as one of the other two verdicts
  std::optional<Stepping> stepping = {};      ///< on the card
  Precision precision = Precision::binary64;  ///< on the card: a lie must exceed the tolerance that engines get
  bool overworks = false;                     ///< takes two steps for each answer, and promises to take one
  bool breaks = false;                        ///< answers every query with Breaks
};

/// The lies are made again for each subject, so that their state belongs to that subject alone.
Canary lying(const std::string& id, const std::string& says, std::function<Lies()> make_lies);

/// The canaries, grouped by what they lie about.
std::vector<Canary> canaries_about_pairs_of_bodies();
std::vector<Canary> canaries_about_closest_features();
std::vector<Canary> canaries_about_boxes();
std::vector<Canary> canaries_about_sequences();
std::vector<Canary> canaries_about_mass();
std::vector<Canary> canaries_about_impacts();
std::vector<Canary> canaries_about_pixels();
std::vector<Canary> canaries_about_motion();
std::vector<Canary> canaries_about_simulations();
std::vector<Canary> canaries_about_constraints();
std::vector<Canary> canaries_about_anything();

/// The unit in which slight lies count: 2⁻⁵³ for numbers, and for lengths of a scene 2⁻⁵³ of its scale. A slight lie is
/// a few times as great as what a property allows a subject that computes in doubles (docs/spec/allowances.md). These
/// units are not those of oracle/tolerance, so an allowance that becomes wider leaves the lie as it is.
inline constexpr double rounding = 0x1p-53;
double rounding_of_length(const Scene& scene);

/// Lies about distances alone.
Lies distances(Lie<Distance> lie);

/// Calls `f` with the answer if the subject gave one; otherwise does nothing.
template <class T, class F>
void with(const Answer<T>& answer, F&& f) {
  if (const T* said = std::get_if<T>(&answer)) f(*said);
}

/// The exact distance of the pair, from the truthful subject; 0 if it reports none.
double distance_by(Subject& truthful, const Scene& scene);

/// A shape's vertices in its body's frame, accurate enough for a lie: a sphere is replaced by its bounding cube, and a
/// compound's parts are not rotated.
std::vector<Vec3> corners(const Body& body);

}  // namespace touchstone::oracle::subjects
