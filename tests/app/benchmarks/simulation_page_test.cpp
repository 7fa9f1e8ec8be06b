#include "app/benchmarks/simulation_page.h"

#include "tests/catch.h"

using touchstone::app::simulation_page;

namespace {

const std::string head = "workload,size,name,whose,ns,median_error,worst_error,left_out,impacts,changes\n";

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("simulation page: a scene's row has its truth, our figures and the best of each peer") {
  const std::string page = simulation_page(head +
                                           "slide_to_roll,0,fast,ours,2000000,,1e-15,,12,3\n"
                                           "slide_to_roll,0,fast.constraint,ours,4000000,,1e-4,,5,7\n"
                                           "slide_to_roll,64,ode,peer,3000000,,0.5,,-1,-1\n"
                                           "slide_to_roll,512,ode,peer,9000000,,0.25,,-1,-1\n");
  CHECK(has(page, "`slide_to_roll`: slides, then rolls at 5/7 of its speed"));
  CHECK(has(page, "| 1.0e-15 in 2 ms | 12 | 3 |"));
  CHECK(has(page, "| 1.0e-04 in 4 ms | 5 | 7 |"));
  CHECK(has(page, "| 2.5e-01 in 9 ms at 512/s |"));
  CHECK(has(page, "Nowhere."));
}

TEST_CASE("simulation page: a truth with bars stays in its cell") {
  CHECK(has(simulation_page(head + "rough_ball,0,fast,ours,1000,,0,,4,0\n"), "m\\|u_n\\|"));
}

TEST_CASE("simulation page: who is faster or nearer to the truth is named, and who is left out says why") {
  const std::string page = simulation_page(head +
                                           "heap,0,fast,ours,2000000,,1e-3,,12,3\n"
                                           "heap,64,ode,peer,1000000,,0.5,,-1,-1\n"
                                           "heap,64,bullet,peer,3000000,,1e-4,,-1,-1\n"
                                           "arch,0,fast,ours,,,,gave up at 0 s of 2 s,,\n"
                                           "arch,64,ode,peer,1000000,,0.125,,-1,-1\n");
  CHECK(has(page, "- `heap`: `fast` 1.0e-03 in 2 ms. ode at 64/s: 5.0e-01 in 1 ms; bullet at 64/s: 1.0e-04 in 3 ms."));
  CHECK(has(page, "| gave up at 0 s of 2 s |"));
  CHECK(has(page, "- `arch`: `fast` gave up at 0 s of 2 s. ode at 64/s: 1.2e-01 in 1 ms."));
  CHECK_FALSE(has(page, "Nowhere."));
}

TEST_CASE("simulation page: what near pairs save is told where both were run") {
  const std::string page = simulation_page(head +
                                           "gas,0,fast,ours,2000000,,0,,12,3\n"
                                           "gas,0,fast.one_frame,beside,8000000,,0,,12,3\n"
                                           "heap,0,fast,ours,2000000,,0,,12,3\n");
  CHECK(has(page, "| `gas` | 2 | 8 | 4x |"));
  CHECK_FALSE(has(page, "| `heap` | 2 | "));
}
