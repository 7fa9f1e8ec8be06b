#include <cmath>

#include "app/bench_plot.h"
#include "app/bench_table.h"
#include "tests/catch.h"

namespace touchstone::app {
namespace {

// Made up: 10 ns and 40 ns a body at 10 times as many, so that a frame costs n^(1 + log10 4).
const std::string csv =
    "workload,bodies,name,whose,law,ns_per_body_and_frame,pairs_per_body,left_out\n"
    "coherent,100,wrapped_grid,ours,n,10,0.1,\n"
    "coherent,1000,wrapped_grid,ours,n,40,0.1,\n"
    "coherent,100,engine.tree,peer,,5,0.1,\n"
    "coherent,1000,engine.tree,peer,,,,too slow\n"
    "coherent,100,engine.hash,peer,,30,0.1,\n"
    "swaps.settled,100,sweep_and_prune,ours,n^2/2,,50,\n"
    "swaps.settled,1000,sweep_and_prune,ours,n^2/2,,500,\n";

TEST_CASE("bench: the exponent of a power law is found") {
  std::vector<std::pair<double, double>> points;
  for (const double x : {1.0, 3.0, 10.0, 70.0}) points.emplace_back(x, 5 * std::pow(x, 5.0 / 3));
  CHECK(fitted_exponent(points) == Approx(5.0 / 3));
}

TEST_CASE("bench: the table has growth, the law, losses and who was left out") {
  const std::string table = bench_table(bench_rows(csv));
  CHECK_THAT(table, Catch::Contains("4.00x    n^1.60  n"));
  CHECK_THAT(table, Catch::Contains("0.50 engine.tree  3.00 engine.hash"));
  CHECK_THAT(table, Catch::Contains("1000  no peer kept to the budget"));
  CHECK_THAT(table, Catch::Contains("1000  engine.tree: too slow"));
  CHECK_THAT(table, Catch::Contains("100: 50.0 n  1000: 500.0 n  = n^2.000, derived n^2/2"));
}

TEST_CASE("bench: the plot has a line and a name for all that were measured, and none for what was counted") {
  const std::string plot = bench_plot(bench_rows(csv));
  for (const char* name : {">wrapped_grid<", ">engine.tree<", ">engine.hash<", ">coherent<"})
    CHECK_THAT(plot, Catch::Contains(name));
  CHECK_THAT(plot, !Catch::Contains("sweep_and_prune"));
}

}  // namespace
}  // namespace touchstone::app
