// Canaries whose fault shows in every query: a violated law, hidden state, no answer at all.
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <tuple>

#include "model/infinity.h"
#include "oracle/subjects/canaries/lie.h"

namespace touchstone::oracle::subjects {
namespace {

// Changes an answer by the least possible amount.
double nudged(double x) { return std::nextafter(x, infinity); }
void nudge(Masses& said) {
  for (auto& m : said) {
    if (m) m->mass = nudged(m->mass);
  }
}
void nudge(Bounds& said) {
  for (Aabb& box : said) box.hi.x() = nudged(box.hi.x());
}
void nudge(PairSet& said) {
  if (!said.empty()) said.pop_back();
}
void nudge(PairHistory& said) {
  for (PairFrame& frame : said) {
    if (!frame.pairs.empty()) frame.pairs.pop_back();
  }
}
void nudge(Distance& said) { said.distance = nudged(said.distance.value_or(0)); }
void nudge(Pixels& said) { ++said.overlap.count; }
void nudge(Penetration& said) { said.depth = nudged(said.depth.value_or(0)); }
void nudge(Impulse& said) { said.after[0].v_WBcm.x() = nudged(said.after[0].v_WBcm.x()); }
void nudge(TimeOfImpact& said) { said.time = nudged(said.time.value_or(0)); }
void nudge(Trajectory& said) {
  for (std::vector<State>& bodies : said.states) {
    for (State& state : bodies) state.velocity.v_WBcm.x() = nudged(state.velocity.v_WBcm.x());
  }
}

// The same lie for all queries.
template <class Rule>
Lies all_queries(Rule rule) {
  Lies lies;
  lies.mass = rule;
  lies.bounds = rule;
  lies.broad_phase = rule;
  lies.pair_history = rule;
  lies.distance = rule;
  lies.penetration = rule;
  lies.pixel = rule;
  lies.time_of_impact = rule;
  lies.simulation = rule;
  lies.constraint = rule;
  lies.impulse = rule;
  return lies;
}

Lies counter() {
  const auto asked = std::make_shared<int>(0);
  return all_queries([asked](Subject&, const Scene&, auto& said) {
    if (++*asked % 2 == 0) nudge(said);
  });
}

Lies remembers() {
  struct Memory {
    std::unique_ptr<Scene> first;
    bool another = false;
  };
  const auto memory = std::make_shared<Memory>();
  return all_queries([memory](Subject&, const Scene& scene, auto& said) {
    if (!memory->first) memory->first = std::make_unique<Scene>(scene);
    memory->another = memory->another || !(*memory->first == scene);
    if (memory->another) nudge(said);
  });
}

// Lies by a few times what two answers may differ by, in each answer but its first.
Lies slightly_fickle() {
  const auto asked = std::make_shared<int>(0);
  const auto later = [asked](const auto& lie) {
    return [asked, lie](Subject&, const Scene& scene, auto& said) {
      if (++*asked > 1) lie(scene, said);
    };
  };
  Lies lies;
  lies.mass = later([](const Scene& scene, Masses& said) {
    for (std::size_t i = 0; i < said.size(); ++i) {
      if (!said[i]) continue;
      double arm = 0;
      for (const Vec3& corner : corners(scene.bodies[i])) arm = std::max(arm, corner.norm());
      said[i]->mass *= 1 + 66 * rounding;
      said[i]->p_BBcm.x() += 144 * rounding * arm;
      said[i]->I_BBcm_B(0, 0) += 480 * rounding * said[i]->mass * arm * arm;
    }
  });
  lies.bounds = later([](const Scene& scene, Bounds& said) {
    for (Aabb& box : said) box.hi.x() += 1250 * rounding_of_length(scene);
  });
  lies.distance = later([](const Scene& scene, Distance& said) {
    if (said.distance > 0) *said.distance += 1500 * rounding_of_length(scene);
  });
  lies.penetration = later([](const Scene& scene, Penetration& said) {
    if (said.depth > 0) *said.depth += 1500 * rounding_of_length(scene);
  });
  lies.impulse = later([](const Scene& scene, Impulse& said) {
    for (std::size_t i = 0; i < 2; ++i) {
      const Velocity& before = scene.bodies[i].velocity;
      Velocity& after = said.after[i];
      after.v_WBcm += 6000 * rounding * (after.v_WBcm - before.v_WBcm);
      after.w_WB += 6000 * rounding * (after.w_WB - before.w_WB);
    }
  });
  lies.time_of_impact = later([](const Scene& scene, TimeOfImpact& said) {
    const double speed = (scene.bodies[0].velocity.v_WBcm - scene.bodies[1].velocity.v_WBcm).norm();
    Scene at_origin = scene;  // translating the world makes the lie no greater
    at_origin.bodies[1].X_WB.p_WB -= at_origin.bodies[0].X_WB.p_WB;
    at_origin.bodies[0].X_WB.p_WB.setZero();
    if (said.time && speed > 0) *said.time += 16000 * rounding_of_length(at_origin) / speed;
  });
  return lies;
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Lies not_a_number() {
  Lies lies;
  lies.mass = [](Subject&, const Scene&, Masses& said) {
    for (auto& m : said) {
      if (m) m->mass = nan;
    }
  };
  lies.bounds = [](Subject&, const Scene&, Bounds& said) {
    for (Aabb& box : said) box.lo.x() = nan;
  };
  lies.distance = [](Subject&, const Scene&, Distance& said) { said.distance = nan; };
  lies.penetration = [](Subject&, const Scene&, Penetration& said) { said.depth = nan; };
  lies.impulse = [](Subject&, const Scene&, Impulse& said) { said.after[0].w_WB.x() = nan; };
  lies.time_of_impact = [](Subject&, const Scene&, TimeOfImpact& said) { said.time = nan; };
  lies.simulation = [](Subject&, const Scene&, Trajectory& said) {
    for (std::vector<State>& bodies : said.states) bodies.front().velocity.w_WB.x() = nan;
  };
  return lies;
}

// Multiplies a time by a factor.
void stretch(TimeOfImpact& said, double factor) {
  if (said.time) *said.time *= factor;
}

// Multiplies every length and time in a pair's answer by a factor that depends on the scene.
Lies lengths_times(const std::function<double(const Scene&)>& factor) {
  Lies lies;
  lies.distance = [factor](Subject&, const Scene& scene, Distance& said) {
    if (said.distance) *said.distance *= factor(scene);
  };
  lies.penetration = [factor](Subject&, const Scene& scene, Penetration& said) {
    if (said.depth) *said.depth *= factor(scene);
  };
  lies.time_of_impact = [factor](Subject&, const Scene& scene, TimeOfImpact& said) { stretch(said, factor(scene)); };
  return lies;
}

Lies asymmetric() {
  return lengths_times([](const Scene& scene) {
    const Vec3 a = scene.bodies[0].X_WB.p_WB, b = scene.bodies[1].X_WB.p_WB;
    return std::tuple(a.x(), a.y(), a.z()) < std::tuple(b.x(), b.y(), b.z()) ? 1 + 1e-6 : 1;
  });
}

// The fault of an engine that was tested along x and z, but not along −y.
Lies one_axis() {
  Lies lies = lengths_times([](const Scene& scene) {
    const Vec3 p_AB = scene.bodies[1].X_WB.p_WB - scene.bodies[0].X_WB.p_WB;
    return p_AB.y() > 0 && p_AB.y() == p_AB.cwiseAbs().maxCoeff() ? 1 + 1e-6 : 1;
  });
  lies.bounds = [](Subject&, const Scene&, Bounds& said) {
    for (Aabb& box : said) box.hi.y() += 1e-6 * (box.hi.y() - box.lo.y());
  };
  lies.mass = [](Subject&, const Scene&, Masses& said) {
    for (auto& m : said) {
      if (m) m->I_BBcm_B(1, 1) *= 1 + 1e-6;
    }
  };
  lies.impulse = [](Subject&, const Scene&, Impulse& said) { said.after[0].v_WBcm.y() *= 1 + 1e-6; };
  return lies;
}

double place(const Scene& scene) { return scene.bodies.front().X_WB.p_WB.cwiseAbs().maxCoeff(); }

Lies world_frame() {
  Lies lies = lengths_times([](const Scene& scene) { return 1 + 1e-6 * place(scene); });
  lies.bounds = [](Subject&, const Scene& scene, Bounds& said) {
    for (Aabb& box : said) box.hi.x() += 1e-6 * place(scene);
  };
  lies.broad_phase = [](Subject&, const Scene& scene, PairSet& said) {
    if (place(scene) > 3 * corners(scene.bodies.front()).front().norm()) said.clear();
  };
  return lies;
}

constexpr double epsilon = 1e-4;

Lies absolute_epsilon() {
  Lies lies;
  lies.distance = [](Subject&, const Scene&, Distance& said) {
    if (said.verdict != Verdict::separated || said.distance >= epsilon) return;
    said.verdict = Verdict::touching;
    said.distance = 0;
  };
  lies.penetration = [](Subject& truthful, const Scene& scene, Penetration& said) {
    if (said.verdict == Verdict::separated && distance_by(truthful, scene) < epsilon) said.verdict = Verdict::touching;
    if (said.verdict == Verdict::overlapping && said.depth < epsilon) said = {Verdict::touching, 0, {}};
  };
  lies.bounds = [](Subject&, const Scene&, Bounds& said) {
    for (Aabb& box : said) box = {box.lo - Vec3::Constant(epsilon), box.hi + Vec3::Constant(epsilon)};
  };
  lies.broad_phase = [](Subject& truthful, const Scene& scene, PairSet& said) {
    with(truthful.bounds(scene), [&](const Bounds& box) {
      said.clear();
      for (std::size_t i = 0; i < box.size(); ++i) {
        for (std::size_t j = i + 1; j < box.size(); ++j) {
          const double gap = std::max((box[i].lo - box[j].hi).maxCoeff(), (box[j].lo - box[i].hi).maxCoeff());
          if (gap <= epsilon) said.emplace_back(static_cast<int>(i), static_cast<int>(j));
        }
      }
    });
  };
  lies.mass = [](Subject&, const Scene&, Masses& said) {
    for (auto& m : said) {
      if (m) m->mass += epsilon;
    }
  };
  lies.time_of_impact = [](Subject&, const Scene& scene, TimeOfImpact& said) {
    stretch(said, 1 - epsilon / corners(scene.bodies.front()).front().norm());
  };
  return lies;
}

// A number that depends on which vertex is listed first.
double trace_of_first_vertex(const Body& body) { return 1e-9 * corners(body).front().dot(Vec3(1, 2, 4)); }

Lies first_vertex() {
  Lies lies = lengths_times([](const Scene& scene) { return 1 + trace_of_first_vertex(scene.bodies[0]); });
  lies.bounds = [](Subject&, const Scene& scene, Bounds& said) {
    for (std::size_t i = 0; i < said.size(); ++i) said[i].hi.x() += std::abs(trace_of_first_vertex(scene.bodies[i]));
  };
  lies.mass = [](Subject&, const Scene& scene, Masses& said) {
    for (std::size_t i = 0; i < said.size(); ++i) {
      if (said[i]) said[i]->mass *= 1 + trace_of_first_vertex(scene.bodies[i]);
    }
  };
  return lies;
}

Lies overworks() {
  Lies lies;
  lies.overworks = true;
  return lies;
}

Lies breaks() {
  Lies lies;
  lies.breaks = true;
  return lies;
}

}  // namespace

std::vector<Canary> canaries_about_anything() {
  return {
      lying("canary.asymmetric", "answers otherwise when the bodies are swapped", asymmetric),
      lying("canary.world_frame", "answers otherwise away from the world's origin", world_frame),
      lying("canary.one_axis", "is wrong along +y only", one_axis),
      lying("canary.absolute_epsilon", "takes 1e-4 m, or kg, for nothing whatever the scene's size", absolute_epsilon),
      lying("canary.first_vertex", "lets the first vertex in the list leak into the answer", first_vertex),
      lying("canary.counter", "changes every second answer by one bit", counter),
      lying("canary.remembers", "answers otherwise once another scene was asked", remembers),
      lying("canary.slightly_fickle", "is off by a few times what rounding explains, in each answer but its first",
            slightly_fickle),
      lying("canary.nan", "answers NaN", not_a_number),
      lying("canary.works_twice", "takes two steps for each answer where it promises one", overworks),
      lying("canary.throws", "throws", breaks),
  };
}

}  // namespace touchstone::oracle::subjects
