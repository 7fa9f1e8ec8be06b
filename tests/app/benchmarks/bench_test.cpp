#include <cmath>

#include "app/benchmarks/bench_plot.h"
#include "app/benchmarks/bench_table.h"
#include "app/benchmarks/first_call_table.h"
#include "app/benchmarks/work_precision.h"
#include "tests/catch.h"

namespace touchstone::app {
namespace {

// Invented figures: 10 ns and 40 ns per body at 10 times as many bodies, so that a frame costs n^(1 + log10 4).
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

// Invented figures: ours is exact, one peer is faster and has errors, another peer gives no error to judge.
const std::string work_precision_csv =
    "workload,size,name,whose,ns,median_error,worst_error,left_out\n"
    "coherent,8,fast,ours,100,0,0,\n"
    "coherent,20,fast,ours,150,0.5,2,\n"
    "coherent,8,engine.gjk,peer,50,10,1000,\n"
    "coherent,20,engine.gjk,peer,,,,hung\n"
    "coherent,8,other,peer,300,nan,nan,\n";

TEST_CASE("bench: error against time as a table, losses and who was left out with it") {
  const std::string table = work_precision_table(work_precision_rows(work_precision_csv), {"vertices a body", "ulps"});
  CHECK_THAT(table, Catch::Contains("coherent, by vertices a body"));
  CHECK_THAT(table, Catch::Contains("1.50x"));
  CHECK_THAT(table, Catch::Contains("0.50 engine.gjk  3.00 other"));
  CHECK_THAT(table, Catch::Contains("20  engine.gjk: hung"));
  const WorkPrecisionWords efforts{"effort", "ulps", false};
  CHECK_THAT(work_precision_table(work_precision_rows(work_precision_csv), efforts), !Catch::Contains("times faster"));
}

TEST_CASE("bench: error against time as a plot, an exact answer below the axis") {
  const std::string plot = work_precision_plot(work_precision_rows(work_precision_csv), {"vertices a body", "ulps"});
  CHECK_THAT(plot, Catch::Contains("<title>fast, 8: 100 ns, 0</title>"));
  CHECK_THAT(plot, Catch::Contains(">engine.gjk<"));
  CHECK_THAT(plot, !Catch::Contains(">other<"));
  CHECK_THAT(plot, !Catch::Contains("nan"));
}

// Invented figures: one row is slower than the reference, one has a scene that is, and one has no scene at all.
const std::string first_call_csv =
    "query,scenes,questions,fast_ns,reference_ns,worst_ratio,left_out\n"
    "mass,8,boxes.dyadic_gap,100,2000,0.1,\n"
    "mass,8,hulls of 20 vertices: apart,4000,2000,2.5,of 8 scenes fast leaves 1 and the reference 0\n"
    "impulse,8,contact.rods,500,1000,1.5,\n"
    "impulse,8,contact.levers,,,,of 8 scenes fast leaves 0 and the reference 8\n";

TEST_CASE("bench: questions asked once, and each row in which fast is slower than the reference") {
  const std::string table = first_call_table(first_call_rows(first_call_csv));
  CHECK_THAT(table, Catch::Contains("0.10       2.00     0.05     0.10"));
  const auto above = table.find("Rows above 1"), near = table.find("with a scene above 1"),
             out = table.find("Left out");
  REQUIRE(above < near);
  REQUIRE(near < out);
  const std::string slower = table.substr(above, near - above), one_scene = table.substr(near, out - near);
  CHECK_THAT(slower, Catch::Contains("hulls of 20 vertices: apart"));
  CHECK_THAT(slower, !Catch::Contains("contact.rods"));
  CHECK_THAT(one_scene, Catch::Contains("contact.rods"));
  CHECK_THAT(one_scene, !Catch::Contains("boxes.dyadic_gap"));
  CHECK_THAT(table.substr(out), Catch::Contains("contact.levers"));
  CHECK_THAT(first_call_table({}), Catch::Contains("slower than the exact reference\nnone"));
}

}  // namespace
}  // namespace touchstone::app
