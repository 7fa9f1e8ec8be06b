// Messages of engines inside XML: nothing in them is taken for markup.
#include "app/report/report_junit.h"
#include "app/report/xml.h"
#include "tests/catch.h"

namespace touchstone::app {
namespace {

TEST_CASE("Markup and characters that XML does not know") {
  CHECK(escaped("a<b>&\"c\"") == "a&lt;b&gt;&amp;&quot;c&quot;");
  CHECK(escaped(std::string("\x1b[31m\0\n\t\xff", 9)) == "\\u001b[31m\\u0000\n\\t\\xff");
  CHECK(escaped("\ufffe\u202e") == "\\ufffe\\u202e");
  CHECK(escaped("d ≤ ½") == "d ≤ ½");
}

TEST_CASE("Abstaining is skipped, failing fails, holding is neither") {
  TestedSubject engine;
  engine.card.name = "<engine>";
  Ledger ledger({&properties::all()[0], &properties::all()[1], &properties::all()[2]}, {engine});
  Row& holding = ledger.results.all()[0];
  Row& abstaining = ledger.results.all()[1];
  Row& failing = ledger.results.all()[2];
  holding.counts.holds = 1;
  abstaining.counts.abstains = 1;
  abstaining.why_abstains = "a & b";
  failing.counts.fails = 1;
  failing.examples.worst.emplace();
  failing.examples.worst->finding = {
      oracle::Outcome::fails, oracle::Defect::wrong_mass, "<1>", "2", 1, 0.5, "kg", 0, {}, {}, {}, "", ""};
  const std::string xml = report_junit(ledger);
  CHECK_THAT(xml, Catch::Contains("name=\"&lt;engine&gt;\" tests=\"3\" failures=\"1\" errors=\"0\" skipped=\"1\""));
  CHECK_THAT(xml, Catch::Contains("<skipped message=\"a &amp; b\"/>"));
  CHECK_THAT(xml, Catch::Contains("&lt;1&gt;"));

  failing.baseline.known = "wrong_mass, in the baseline";
  holding.baseline.departures = {"passes, though a failure is expected"};
  const std::string with_baseline = report_junit(ledger);
  CHECK_THAT(with_baseline, Catch::Contains("failures=\"1\" errors=\"0\" skipped=\"2\""));
  CHECK_THAT(with_baseline, Catch::Contains("<skipped message=\"known: wrong_mass, in the baseline\"/>"));
  CHECK_THAT(with_baseline, Catch::Contains("<failure type=\"passes\""));
}

}  // namespace
}  // namespace touchstone::app
