#include "app/adapter/proven.h"

#include "app/adapter/adapter_check.h"
#include "app/system/interruption.h"
#include "app/system/progress.h"
#include "app/system/terminal.h"
#include "app/trial/subject_list.h"
#include "model/input_error.h"

namespace touchstone::app {
namespace {

void complain_of(const CheckedQuery& query) {
  if (!query.is_fault()) return;
  complain("{}: {} of {} plain questions answered wrongly; e.g. \"{}\": {}", query.query, query.faults(),
           query.asked - query.abstains, query.scene, query.complaint);
  if (!query.hints.empty()) complain("{}: hint: {}", query.query, query.hints.front().text);
}

void require_proven(const std::string& connectable, const std::vector<std::string>& queries,
                    const oracle::PipeLimits& limits) {
  const auto subject = connect(connectable, limits);
  Progress progress("checking the adapter", 0);
  const AdapterCheck check = check_adapter(*subject, queries, [&](const std::string& query) { progress.step(query); });
  if (interrupted() || !check.is_fault()) return;
  for (const CheckedQuery& query : check.queries) complain_of(query);
  if (!check.precision.empty()) complain("hint: {}", check.precision);
  throw InputError("subject \"" + connectable + '"',
                   "its adapter does not pass, so the engine is not judged; `touchstone adapter check` says more, and "
                   "--skip-adapter-check judges it as it is");
}

}  // namespace

void require_proven_adapters(const std::vector<std::string>& connectables, const std::vector<std::string>& queries,
                             const oracle::PipeLimits& limits) {
  for (const std::string& connectable : connectables) {
    if (connectable.starts_with("exec:")) require_proven(connectable, queries, limits);
  }
}

}  // namespace touchstone::app
