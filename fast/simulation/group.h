// Bodies that hold each other: who stands on whom, and how all of them move on together.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "fast/contact/step.h"
#include "fast/simulation/impact.h"

namespace touchstone::fast::world {

/// A body of a group: one that moves, or one that is fixed and carries.
struct Rider {
  BodyId id = 0;
  const Mover* body = nullptr;
  contact::Member member;

  bool fixed() const { return body->fixed(); }
};

/// Two convex parts that touch, or are near; of these, feet are where they touch.
struct Joint {
  BodyId a = 0, b = 0;  ///< a < b
  std::size_t part_a = 0, part_b = 0;
  Vec3 nhat_BA_W = Vec3::Zero();
  Vec3 p_WC = Vec3::Zero();  ///< of its first foot
  std::vector<contact::Foot> feet = {};
  bool told = false;     ///< an event has said that it holds
  bool touched = false;  ///< has had a foot; else it is watched only
};

/// A foot of a joint, as its pair would strike there.
struct Strike {
  BodyId a = 0, b = 0;
  Touch touch;
  double u_n = 0;
};

class Group {
 public:
  /// `near`: as far apart as this two parts touch; `reach`: as far apart as this they are watched together (m).
  Group(double near, double reach) : near_(near), reach_(reach) {}

  /// Requires that the body is not in it yet. In the order of ids.
  void add(const Rider& rider);
  /// Joins all parts of two of its bodies that are within reach; whether there are any.
  bool link(BodyId a, BodyId b);
  /// Bodies that hold each other by some of their parts are watched by all that may come down within h.
  void link_parts(double h);
  /// What another group of the same time has.
  void absorb(const Group& other);

  const std::vector<Rider>& riders() const { return riders_; }
  std::vector<Joint>& joints() { return joints_; }
  const std::vector<Joint>& joints() const { return joints_; }
  bool has(BodyId id) const;
  bool holds(BodyId a, BodyId b) const;
  BodyId key() const;  ///< its first body that moves
  const State& state(BodyId id) const;
  /// The body has that velocity now: its joints may part, and have to be told anew.
  void strike(BodyId id, const Velocity& velocity);
  void set_pull(BodyId id, const Vec3& pull);

  /// Where the riders are at a time of the step that is being taken: where a step as long as that would have brought
  /// them.
  std::vector<State> states_at(double time) const;
  /// Makes a step of h, or a shorter one that ends where the first other corner comes down, the one that is taken. How
  /// long it is.
  double plan(double h);
  const contact::Stepped& course() const { return plan_->stepped; }
  /// m; how deep two parts are in each other at its end.
  double deepest() const;
  /// On to `time`: for all of the step that is planned, or for a shorter one.
  void go_to(double time);

  /// Feet as the riders stand now. Whom no foot holds that parts no faster than `slow` says of its pair (m/s), or is
  /// still in the other, is let go: the joints that let go are taken out and returned.
  std::vector<Joint> part(const std::function<double(BodyId, BodyId)>& slow);
  /// The foot that approaches fastest.
  std::optional<Strike> foremost() const;
  /// Counts a strike now. False: so many came at this one time that each seems to wake the next.
  bool may_strike();
  /// Groups of riders that joints connect; riders without a joint are left out.
  std::vector<Group> components() const;

  /// Takes from the velocities what approaches at the feet.
  void land();
  /// All bodies stand still, and forces at the feet balance what pulls them: then nobody moves. `still`: m/s.
  bool stands(double still);
  /// J; kinetic, and of place under the pulls.
  double energy() const;
  /// How long a step may be (s): so many of them while a body falls by its size, turns by a radian or goes its size;
  /// `most`, where nobody does.
  double stride(double steps, double most);
  /// How far bodies come from the paths that they are said to be on within the planned step, about (m): parabolas and
  /// steady turns, where forces and spin change.
  double deviation() const;

  /// Its events have to say of this body's joints once more that they hold.
  void tell_anew(BodyId id);

  /// Its next steps are shorter, for a while; but not shorter than that share of what they may be.
  /// False: they are that short already. (Of a first step nobody knows how long it will be.)
  bool shorten(double least_share);
  /// How fast its bodies may leave their paths within the step (m/s): from where it began, and no further than
  /// `margin`.
  double drift() const { return margin > 0 ? 2 * margin / (until - since) : 0; }

  double since = 0;        ///< s; when the riders are at their states
  double longest = never;  ///< s; no step is longer, for a while
  double margin = 0;       ///< m; by how much paths within a step may be off
  double until = 0;        ///< s; the end of the step that is being taken; never: it stands
  bool waits = true;       ///< its next step has not begun

 private:
  void sort_joints();
  contact::Member& member(BodyId id);
  std::size_t index(BodyId id) const;
  std::vector<contact::Member> members() const;
  std::vector<contact::Hold> holds() const;
  contact::Part part_of(BodyId id, std::size_t part, const State& state) const;
  bool renew(Joint& joint, double reach) const;
  void link(BodyId a, BodyId b, double reach);
  double pace(BodyId id, double h) const;
  Vec3 normal(const Joint& joint, const contact::Part& A, const State& at_a, const contact::Part& B,
              const State& at_b) const;
  Strike strike_at(const Joint& joint, const contact::Foot& foot) const;
  std::vector<double> clearances(const std::vector<State>& states) const;
  double spare(const std::vector<double>& before, const std::vector<double>& after) const;

  struct Plan {
    double h = 0;
    contact::Stepped stepped;
    std::vector<contact::Hold> holds;
  };
  Plan planned(double h) const;

  double near_, reach_;
  double struck_at_ = -never;  ///< s
  std::size_t strikes_ = 0;    ///< then
  std::vector<Rider> riders_;  ///< by id
  std::vector<Joint> joints_;
  std::optional<Plan> plan_;
  double stride_ = 0;  ///< s; as long as the next step may be
};

}  // namespace touchstone::fast::world
