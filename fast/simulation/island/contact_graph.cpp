#include "fast/simulation/island/contact_graph.h"

#include <algorithm>
#include <span>
#include <tuple>

#include "fast/simulation/island/shared_normal.h"
#include "fast/simulation/prediction/length.h"

namespace touchstone::fast::simulation {
namespace {

constexpr double overlap_tolerance = 0x1p-10;  // of `near`: contact steps are as accurate as that (island_step.cpp)

/// Of sorted pairs those of the same two bodies as the pair at `first`, which is the first of them.
std::span<ContactPair> of_same_bodies(std::vector<ContactPair>& pairs, std::size_t first) {
  std::size_t end = first;
  while (end < pairs.size() && pairs[end].a == pairs[first].a && pairs[end].b == pairs[first].b) ++end;
  return {pairs.data() + first, end - first};
}

void sort(std::vector<ContactPair>& pairs) {
  std::ranges::stable_sort(pairs, {}, [](const ContactPair& j) { return std::tuple(j.a, j.b, j.part_a, j.part_b); });
}

}  // namespace

void ContactGraph::add(const IslandBody& island_body) {
  const auto place = static_cast<std::ptrdiff_t>(index(island_body.id));
  bodies_.insert(bodies_.begin() + place, island_body);
  ids_.insert(ids_.begin() + place, island_body.id);
}

std::size_t ContactGraph::index(BodyId id) const {
  return static_cast<std::size_t>(std::ranges::lower_bound(ids_, id) - ids_.begin());
}

bool ContactGraph::has(BodyId id) const {
  const std::size_t i = index(id);
  return i < ids_.size() && ids_[i] == id;
}

bool ContactGraph::connects(BodyId a, BodyId b) const {
  return std::ranges::any_of(contact_pairs_,
                             [=](const ContactPair& j) { return j.a == std::min(a, b) && j.b == std::max(a, b); });
}

BodyId ContactGraph::key() const {
  return std::ranges::find_if(bodies_, [](const IslandBody& island_body) { return !island_body.fixed(); })->id;
}

void ContactGraph::absorb(const ContactGraph& other) {
  near_ = std::max(near_, other.near_);
  reach_ = std::max(reach_, other.reach_);
  for (const IslandBody& island_body : other.bodies_) {
    if (!has(island_body.id)) add(island_body);
  }
  contact_pairs_.insert(contact_pairs_.end(), other.contact_pairs_.begin(), other.contact_pairs_.end());
  sort(contact_pairs_);
}

bool ContactGraph::link(BodyId id_a, BodyId id_b) {
  const BodyId a = std::min(id_a, id_b), b = std::max(id_a, id_b);
  link(a, b, reach_);
  return connects(a, b);
}

/// Requires a < b.
void ContactGraph::link(BodyId a, BodyId b, double reach) {
  const IslandBody &A = bodies_[index(a)], &B = bodies_[index(b)];
  const std::size_t before = contact_pairs_.size();
  const std::size_t parts_a = A.body->model().solid.parts().size(), parts_b = B.body->model().solid.parts().size();
  for (std::size_t i = 0; i < parts_a; ++i) {
    for (std::size_t j = 0; j < parts_b; ++j) {
      const auto same = [&](const ContactPair& k) { return k.a == a && k.b == b && k.part_a == i && k.part_b == j; };
      if (std::ranges::any_of(contact_pairs_, same)) continue;
      ContactPair contact_pair{a, b, i, j};
      if (update(contact_pair, A, B, near_, reach)) contact_pairs_.push_back(std::move(contact_pair));
    }
  }
  if (contact_pairs_.size() == before) return;
  sort(contact_pairs_);
  std::size_t first = 0;
  while (contact_pairs_[first].a != a || contact_pairs_[first].b != b) ++first;
  share_normals(of_same_bodies(contact_pairs_, first), A, B, near_);
}

void ContactGraph::link_parts(double h) {
  std::vector<BodyPair> pairs;
  for (const ContactPair& contact_pair : contact_pairs_) pairs.push_back({contact_pair.a, contact_pair.b});
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  for (const BodyPair& pair : pairs)
    link(pair.a, pair.b,
         reach_ + h * (speed_bound(bodies_[index(pair.a)], h) + speed_bound(bodies_[index(pair.b)], h)));
}

std::vector<ContactPair> ContactGraph::take_out_separating(const std::function<double(BodyId, BodyId)>& release_speed) {
  std::vector<bool> held(bodies_.size());
  for (std::size_t i = 0; i < bodies_.size(); ++i) held[i] = bodies_[i].fixed();
  std::vector<ContactPair> near, kept, out;
  for (ContactPair& contact_pair : contact_pairs_) {
    const ContactPair before = contact_pair;
    const std::size_t a = index(contact_pair.a), b = index(contact_pair.b);
    if (!update(contact_pair, bodies_[a], bodies_[b], near_, reach_)) {
      out.push_back(before);
      continue;
    }
    near.push_back(contact_pair);
  }
  for (std::size_t i = 0; i < near.size();) {
    const std::span<ContactPair> of_bodies = of_same_bodies(near, i);
    share_normals(of_bodies, bodies_[index(near[i].a)], bodies_[index(near[i].b)], near_);
    i += of_bodies.size();
  }
  for (const ContactPair& contact_pair : near) {
    const std::size_t a = index(contact_pair.a), b = index(contact_pair.b);
    for (const contact::ContactPoint& contact_point : contact_pair.contact_points) {
      const ImpactCandidate at = candidate_at(contact_pair, contact_point, bodies_[a], bodies_[b]);
      if (at.u_n <= release_speed(contact_pair.a, contact_pair.b) || at.touch.gap < -near_ * overlap_tolerance)
        held[a] = held[b] = true;
    }
  }
  const auto holds = [&](const ContactPair& contact_pair) {
    return held[index(contact_pair.a)] && held[index(contact_pair.b)];
  };
  const auto moves_in_contact = [&](BodyId id) { return held[index(id)] && !bodies_[index(id)].fixed(); };
  for (bool grows = true; grows;) {
    grows = false;
    for (const ContactPair& contact_pair : near) {
      const BodyId a = contact_pair.a, b = contact_pair.b;
      if (contact_pair.touched || holds(contact_pair) || (!moves_in_contact(a) && !moves_in_contact(b))) continue;
      held[index(a)] = held[index(b)] = grows = true;
    }
  }
  for (ContactPair& contact_pair : near) (holds(contact_pair) ? kept : out).push_back(std::move(contact_pair));
  contact_pairs_ = std::move(kept);
  std::erase_if(out, [](const ContactPair& contact_pair) { return !contact_pair.touched; });
  return out;
}

std::vector<PairPoints> ContactGraph::points() const {
  std::vector<PairPoints> all;
  for (const ContactPair& pair : contact_pairs_) {
    PairPoints points;
    for (const contact::ContactPoint& point : pair.contact_points)
      points.push_back(candidate_at(pair, point, bodies_[index(pair.a)], bodies_[index(pair.b)]));
    if (!points.empty()) all.push_back(std::move(points));
  }
  return all;
}

void ContactGraph::emit_again(BodyId id) {
  for (ContactPair& contact_pair : contact_pairs_) contact_pair.emitted = contact_pair.emitted && !contact_pair.has(id);
}

std::vector<ContactGraph> ContactGraph::components() const {
  std::vector<std::size_t> root(bodies_.size());
  for (std::size_t i = 0; i < root.size(); ++i) root[i] = i;
  const auto find = [&](std::size_t i) {
    while (root[i] != i) i = root[i];
    return i;
  };
  for (const ContactPair& contact_pair : contact_pairs_) {
    const std::size_t a = index(contact_pair.a), b = index(contact_pair.b);
    if (bodies_[a].fixed() || bodies_[b].fixed()) continue;
    const std::size_t root_a = find(a), root_b = find(b);
    root[std::max(root_a, root_b)] = std::min(root_a, root_b);
  }
  std::vector<std::optional<ContactGraph>> of_root(bodies_.size());
  for (const ContactPair& contact_pair : contact_pairs_) {
    const std::size_t a = index(contact_pair.a), b = index(contact_pair.b);
    std::optional<ContactGraph>& graph = of_root[find(bodies_[a].fixed() ? b : a)];
    if (!graph) graph.emplace(near_, reach_);
    for (const std::size_t body : {a, b}) {
      if (!graph->has(bodies_[body].id)) graph->add(bodies_[body]);
    }
    graph->contact_pairs_.push_back(contact_pair);
  }
  std::vector<ContactGraph> graphs;
  for (std::optional<ContactGraph>& graph : of_root) {
    if (graph) graphs.push_back(std::move(*graph));
  }
  return graphs;
}

std::optional<ImpactCandidate> fastest_approach(const std::vector<PairPoints>& contacts) {
  std::optional<ImpactCandidate> most;
  for (const PairPoints& points : contacts) {
    for (const ImpactCandidate& found : points) {
      if (!most || found.u_n < most->u_n) most = found;
    }
  }
  return most;
}

}  // namespace touchstone::fast::simulation
