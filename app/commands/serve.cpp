#include "app/commands/serve.h"

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "app/commands/ask.h"
#include "app/system/terminal.h"
#include "app/system/version.h"
#include "model/input_error.h"
#include "model/output_error.h"
#include "oracle/process/serve.h"

namespace touchstone::app {
namespace {

/// Errors name the place within the message, as those of oracle::serve itself do.
Answer<Json> exact(const oracle::Query& query, const Scene& scene) try {
  if (std::ranges::count(printed_queries(), query.name) == 0) return Abstains{"no exact answer is printed"};
  return exact_answer(query.name, scene);
} catch (const InputError& error) {
  throw InputError("", std::string("scene.") + error.what());
}

}  // namespace

int serve() try {
  oracle::Card card;
  card.name = "exact";
  card.version = version;
  card.precision = oracle::Precision::exact;
  card.answers = printed_queries();
  card.knows_touching = true;
  card.about = "the exact answers of Touchstone's reference, as `touchstone ask --json` prints them";
  oracle::serve(card,
                {exact, [](const std::string&, const Scene&, const std::string&) { return Abstains{"no snippets"}; },
                 [](const std::string&, const Scene&) { return Abstains{"does not count its work"}; }});
  return 0;
} catch (const std::system_error& error) {
  if (error.code().value() == EPIPE) return nothing_reads_exit_code;
  throw OutputError("stdout", "cannot write: " + error.code().message());
}

}  // namespace touchstone::app
