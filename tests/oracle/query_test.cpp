// The registry of queries: each name belongs to the function of that name.
#include "oracle/query.h"

#include <set>

#include "tests/catch.h"

namespace touchstone::oracle {
namespace {

/// Abstains from every query, with the name of the function that was called.
class Named : public Subject {
 public:
  const Card& card() const override { return card_; }
  Answer<Masses> mass(const Scene&) override { return Abstains{"mass"}; }
  Answer<Bounds> bounds(const Scene&) override { return Abstains{"bounds"}; }
  Answer<PairSet> broad_phase(const Scene&) override { return Abstains{"broad_phase"}; }
  Answer<PairHistory> pair_history(const Scene&) override { return Abstains{"pair_history"}; }
  Answer<Distance> distance(const Scene&) override { return Abstains{"distance"}; }
  Answer<Penetration> penetration(const Scene&) override { return Abstains{"penetration"}; }
  Answer<Impulse> impulse(const Scene&) override { return Abstains{"impulse"}; }
  Answer<Pixels> pixel(const Scene&) override { return Abstains{"pixel"}; }
  Answer<TimeOfImpact> time_of_impact(const Scene&) override { return Abstains{"time_of_impact"}; }
  Answer<Trajectory> simulation(const Scene&) override { return Abstains{"simulation"}; }
  Answer<Trajectory> constraint(const Scene&) override { return Abstains{"constraint"}; }

 private:
  Card card_;
};

TEST_CASE("Each query is named once, after the function that answers it") {
  Named subject;
  std::set<std::string> names;
  for (const Query& query : queries()) {
    CAPTURE(query.name);
    CHECK(names.insert(query.name).second);
    CHECK(find_query(query.name) == &query);
    const std::string called =
        std::visit([&](auto ask) { return std::get<Abstains>((subject.*ask)(Scene{})).why; }, query.ask);
    CHECK(called == query.name);
  }
  CHECK(names.size() == 11);
  CHECK(find_query("depth") == nullptr);
}

}  // namespace
}  // namespace touchstone::oracle
