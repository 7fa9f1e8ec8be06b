// What parallel faces of two moving cores have in common, in plain numbers.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "reference/time_of_impact/moving_core.h"

namespace touchstone::reference {

/// A point of a core: Σ weights·vertices / Σ weights, weights > 0. Empty: none.
template <class P>
using WeightedVertices = std::vector<std::pair<int, P>>;

template <class P>
using Polygon = std::vector<Coordinates<P>>;

/// Twice the area, as a vector along the outward normal.
template <class P>
Coordinates<P> area(const Polygon<P>& polygon) {
  return twice_area<P>(polygon.size(), [&](std::size_t k) -> const Coordinates<P>& { return polygon[k]; });
}

template <class P>
Polygon<P> polygon(const std::vector<int>& face, const std::vector<Coordinates<P>>& places) {
  Polygon<P> all;
  for (const int i : face) all.push_back(places[static_cast<std::size_t>(i)]);
  return all;
}

/// The part of a polygon above the prism on another one (Sutherland & Hodgman 1974).
template <class P>
Polygon<P> clipped(Polygon<P> subject, const Polygon<P>& clip) {
  const Coordinates<P> normal = area(clip);
  for (std::size_t k = 0; k < clip.size(); ++k) {
    const Coordinates<P> inward = cross(normal, Coordinates<P>(clip[(k + 1) % clip.size()] - clip[k]));
    const auto height = [&](const Coordinates<P>& p) { return dot(inward, Coordinates<P>(p - clip[k])); };
    Polygon<P> kept;
    for (std::size_t i = 0; i < subject.size(); ++i) {
      const Coordinates<P>&p = subject[i], &q = subject[(i + 1) % subject.size()];
      const P from = height(p), to = height(q);
      if (from >= 0) kept.push_back(p);
      if ((from > 0 && to < 0) || (from < 0 && to > 0)) kept.push_back(p + P(from / (from - to)) * (q - p));
    }
    subject = std::move(kept);
  }
  return subject;
}

/// The weights of the face's vertices that make a point of the face: those of the triangle of the face in which it is
/// the farthest inside.
template <class P>
WeightedVertices<P> weights(const std::vector<int>& face, const Polygon<P>& corners, const Coordinates<P>& point) {
  const Coordinates<P> normal = area(corners);
  WeightedVertices<P> best;
  P most = -dot(normal, normal);
  for (std::size_t k = 2; k < corners.size(); ++k) {
    const std::size_t members[] = {0, k - 1, k};
    WeightedVertices<P> shares;
    P least = dot(normal, normal);
    for (int i = 0; i < 3; ++i) {
      const Polygon<P> opposite = {point, corners[members[(i + 1) % 3]], corners[members[(i + 2) % 3]]};
      const P share = dot(normal, area(opposite));
      least = std::min(least, share);
      if (share > 0) shares.emplace_back(face[members[i]], share);
    }
    if (least > most) {
      most = least;
      best = std::move(shares);
    }
  }
  return best;
}

/// The middle of the greatest part that a face of A shares with a face of B, as a point of A, if such faces are
/// parallel within 2^-20 and face each other along n, which points from B to A. Empty if none share an area.
template <class P>
WeightedVertices<P> middle_of_common_face(const std::vector<std::vector<int>>& faces_A,
                                          const std::vector<Coordinates<P>>& places_A,
                                          const std::vector<std::vector<int>>& faces_B,
                                          const std::vector<Coordinates<P>>& places_B, const Coordinates<P>& n) {
  constexpr double parallel = 1 - 0x1p-40;  // the square of a cosine
  const auto along = [&](const Coordinates<P>& normal, int sign) {
    const P height = dot(normal, n);
    return P(sign * height) > 0 && height * height >= P(parallel) * dot(normal, normal) * dot(n, n);
  };
  WeightedVertices<P> best;
  P most = 0;
  for (const std::vector<int>& face_A : faces_A) {
    const Polygon<P> corners = polygon(face_A, places_A);
    if (!along(area(corners), -1)) continue;
    for (const std::vector<int>& face_B : faces_B) {
      const Polygon<P> below = polygon(face_B, places_B);
      if (!along(area(below), 1)) continue;
      const Polygon<P> common = clipped(corners, below);
      const Coordinates<P> shared = area(common);
      if (!(dot(shared, shared) > most)) continue;
      most = dot(shared, shared);
      Coordinates<P> sum = {P(0), P(0), P(0)};
      for (const Coordinates<P>& corner : common) sum = sum + corner;
      best = weights(face_A, corners, Coordinates<P>(P(1 / P(static_cast<double>(common.size()))) * sum));
    }
  }
  return best;
}

}  // namespace touchstone::reference
