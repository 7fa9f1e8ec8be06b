#include "app/roster.h"

#include "app/program_folder.h"
#include "model/input_error.h"
#include "oracle/subjects/touchstone_fast.h"
#include "oracle/subjects/touchstone_reference.h"

namespace touchstone::app {

std::unique_ptr<oracle::Subject> connect(const std::string& connectable, oracle::PipeLimits limits) {
  if (connectable == "inproc:reference") return oracle::subjects::make_reference();
  if (connectable == "inproc:fast") return oracle::subjects::make_fast();
  if (connectable.starts_with("inproc:")) {
    throw InputError("subject " + connectable, "only inproc:reference and inproc:fast are linked into this program");
  }
  return oracle::connect(connectable, subjects_folder(), limits);
}

std::vector<std::string> roster(const std::vector<std::string>& asked_for) {
  if (!asked_for.empty()) return asked_for;
  std::vector<std::string> all = oracle::subjects_beside(subjects_folder());
  if (all.empty()) throw InputError("subjects", "none stand beside the program in " + subjects_folder());
  return all;
}

void start_afresh(oracle::Subject& subject) {
  if (auto* pipe = dynamic_cast<oracle::PipeSubject*>(&subject)) pipe->restart();
}

}  // namespace touchstone::app
