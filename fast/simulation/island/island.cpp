#include "fast/simulation/island/island.h"

#include <algorithm>
#include <cmath>

namespace touchstone::fast::simulation {
namespace {

constexpr std::size_t impacts_of_a_pair = 4;  // at one time, on average over the contact pairs

}  // namespace

std::vector<State> Island::states_at(double time) const {
  if (!waits_ && !sleeps() && time > since_) return solve_step(graph_, time - since_, step_length_).stepped.after;
  std::vector<State> states;
  for (const IslandBody& island_body : graph_.bodies()) states.push_back(island_body.state());
  return states;
}

void Island::begin_step(double steps, double most) {
  step_length_ = step_length(graph_, steps, most);
  const double h = std::clamp(bound_.longest(), shortest_step * step_length_, step_length_);
  graph_.link_parts(h);
  plan_ = plan_step(graph_, (since_ + h) - since_, step_length_);
  until_ = std::max(since_ + plan_->h, std::nextafter(since_, never));
  deviation_ = simulation::deviation(graph_, *plan_);
  waits_ = false;
}

void Island::sleep() {
  until_ = never;
  deviation_ = {};
  waits_ = false;
}

std::optional<double> Island::end_step(double time) {
  waits_ = true;
  const double h = time - since_;
  since_ = time;
  if (sleeps() || !(h > 0)) return {};
  const StepPlan taken = plan_ && plan_->h == h ? *plan_ : solve_step(graph_, h, step_length_);
  for (std::size_t i = 0; i < graph_.bodies().size(); ++i) graph_.body(i).step_body.state = taken.stepped.after[i];
  auto constraint = taken.constraints.begin();
  for (ContactPair& contact_pair : graph_.contact_pairs()) {
    for (contact::ContactPoint& contact_point : contact_pair.contact_points)
      contact_point = (constraint++)->contact_point;
  }
  return taken.stepped.residual;
}

bool Island::shorten(double least_share, double expected) {
  bound_.limit(std::max(2 * expected, shortest_step * step_length_));
  if (!plan_) return true;
  bound_.shorten(std::max(plan_->h / 4, least_share * step_length_));
  return plan_->h > least_share * step_length_;
}

void Island::set_velocity(BodyId id, const Velocity& velocity) {
  graph_.body(graph_.index(id)).step_body.state.velocity = velocity;
  graph_.emit_again(id);
}

bool Island::allows_impact() {
  if (impacts_.time != since_) impacts_ = {since_, 0};
  return ++impacts_.count <= impacts_of_a_pair * graph_.contact_pairs().size();
}

void Island::absorb(const Island& other) {
  graph_.absorb(other.graph_);
  bound_.absorb(other.bound_);
  if (other.impacts_.time > impacts_.time) impacts_ = {other.impacts_.time, 0};
  if (other.impacts_.time == impacts_.time) impacts_.count = std::max(impacts_.count, other.impacts_.count);
}

std::vector<Island> Island::components() const {
  std::vector<Island> islands;
  for (ContactGraph& graph : graph_.components()) {
    Island& island = islands.emplace_back(std::move(graph), since_);
    island.bound_ = bound_;
    island.impacts_ = impacts_;
  }
  return islands;
}

}  // namespace touchstone::fast::simulation
