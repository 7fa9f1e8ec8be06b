#include "oracle/subjects/canaries/lie.h"

#include <algorithm>
#include <utility>

#include "model/box_vertices.h"
#include "oracle/query.h"

namespace touchstone::oracle::subjects {
namespace {

Card introduced_as(Card card, const std::string& id, const std::string& says, const Lies& lies) {
  card.name = id;
  card.about = says;
  card.precision = lies.precision;
  card.knows_touching = card.knows_touching && !lies.two_valued;
  card.stepping = lies.stepping;
  card.work_limits.clear();
  if (lies.overworks) {
    for (const std::string& query : query_names()) card.work_limits.push_back({query, "step", 1});
  }
  return card;
}

class Liar : public Subject {
 public:
  Liar(std::unique_ptr<Subject> truthful, const std::string& id, const std::string& says, Lies lies)
      : truthful_(std::move(truthful)),
        lies_(std::move(lies)),
        card_(introduced_as(truthful_->card(), id, says, lies_)) {}

  const Card& card() const override { return card_; }
  Answer<Masses> mass(const Scene& scene) override { return falsified(scene, &Subject::mass, lies_.mass); }
  Answer<Bounds> bounds(const Scene& scene) override { return falsified(scene, &Subject::bounds, lies_.bounds); }
  Answer<PairSet> broad_phase(const Scene& scene) override {
    return falsified(scene, &Subject::broad_phase, lies_.broad_phase);
  }
  Answer<PairHistory> pair_history(const Scene& scene) override {
    return falsified(scene, &Subject::pair_history, lies_.pair_history);
  }
  Answer<Distance> distance(const Scene& scene) override {
    return falsified(scene, &Subject::distance, lies_.distance);
  }
  Answer<Penetration> penetration(const Scene& scene) override {
    return falsified(scene, &Subject::penetration, lies_.penetration);
  }
  Answer<Impulse> impulse(const Scene& scene) override { return falsified(scene, &Subject::impulse, lies_.impulse); }
  Answer<Pixels> pixel(const Scene& scene) override { return falsified(scene, &Subject::pixel, lies_.pixel); }
  Answer<TimeOfImpact> time_of_impact(const Scene& scene) override {
    return falsified(scene, &Subject::time_of_impact, lies_.time_of_impact);
  }
  Answer<Trajectory> simulation(const Scene& scene) override {
    return falsified(scene, &Subject::simulation, lies_.simulation);
  }
  Answer<Work> work(const std::string& query, const Scene& scene) override {
    if (lies_.overworks) return Work{{"step", 2}};
    return Subject::work(query, scene);
  }
  Answer<Trajectory> constraint(const Scene& scene) override {
    return falsified(scene, &Subject::constraint, lies_.constraint);
  }

 private:
  template <class T>
  Answer<T> falsified(const Scene& scene, QueryFunction<T> query, const Lie<T>& lie) {
    if (lies_.breaks) return Breaks{Breaks::Kind::threw, "this canary breaks on purpose"};
    Answer<T> answer = (*truthful_.*query)(scene);
    T* said = std::get_if<T>(&answer);
    if (said != nullptr && lie) lie(*truthful_, scene, *said);
    return answer;
  }

  std::unique_ptr<Subject> truthful_;
  Lies lies_;
  Card card_;
};

std::vector<Vec3> corners_of(const Box& box) { return vertices_of(box); }
std::vector<Vec3> corners_of(const Sphere& sphere) { return corners_of(Box{Vec3::Constant(sphere.radius)}); }
std::vector<Vec3> corners_of(const Polytope& polytope) { return polytope.vertices; }
std::vector<Vec3> corners_of(const Compound& compound) {
  std::vector<Vec3> points;
  for (const Part& part : compound.parts) {
    for (const Vec3& v : std::visit([](const auto& shape) { return corners_of(shape); }, part.shape)) {
      points.emplace_back(v + part.X_BP.p_WB);
    }
  }
  return points;
}

std::vector<std::string> queries_of(const Lies& lies) {
  if (lies.breaks || lies.overworks) return query_names();
  const std::pair<const char*, bool> all[] = {
      {"mass", lies.mass != nullptr},
      {"bounds", lies.bounds != nullptr},
      {"broad_phase", lies.broad_phase != nullptr},
      {"pair_history", lies.pair_history != nullptr},
      {"distance", lies.distance != nullptr || lies.two_valued},
      {"penetration", lies.penetration != nullptr || lies.two_valued},
      {"impulse", lies.impulse != nullptr},
      {"pixel", lies.pixel != nullptr},
      {"time_of_impact", lies.time_of_impact != nullptr},
      {"simulation", lies.simulation != nullptr},
      {"constraint", lies.constraint != nullptr},
  };
  std::vector<std::string> queries;
  for (const auto& [query, lied] : all) {
    if (lied) queries.emplace_back(query);
  }
  return queries;
}

}  // namespace

Canary lying(const std::string& id, const std::string& says, std::function<Lies()> make_lies) {
  return {id, says,
          [=](std::unique_ptr<Subject> truthful) -> std::unique_ptr<Subject> {
            return std::make_unique<Liar>(std::move(truthful), id, says, make_lies());
          },
          queries_of(make_lies())};
}

Lies distances(Lie<Distance> lie) {
  Lies lies;
  lies.distance = std::move(lie);
  return lies;
}

double rounding_of_length(const Scene& scene) {
  double scale = 0;
  for (const Body& body : scene.bodies) {
    double radius = 0;
    for (const Vec3& corner : corners(body)) radius = std::max(radius, corner.norm());
    scale = std::max(scale, body.X_WB.p_WB.cwiseAbs().maxCoeff() + radius);
  }
  return rounding * scale;
}

double distance_by(Subject& truthful, const Scene& scene) {
  double distance = 0;
  with(truthful.distance(scene), [&](const Distance& said) { distance = said.distance.value_or(0); });
  return distance;
}

std::vector<Vec3> corners(const Body& body) {
  return std::visit([](const auto& shape) { return corners_of(shape); }, body.shape);
}

}  // namespace touchstone::oracle::subjects
