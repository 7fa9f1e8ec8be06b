#include "app/trial/subject_list.h"

#include <algorithm>

#include "app/system/interruption.h"
#include "app/system/program_folder.h"
#include "model/input_error.h"
#include "model/near_names.h"
#include "oracle/subject.h"
#include "oracle/subjects/touchstone/fast.h"
#include "oracle/subjects/touchstone/fast_pairs.h"
#include "oracle/subjects/touchstone/reference.h"

namespace touchstone::app {

namespace {

void add_names(const std::string& words, std::vector<std::string>& names) {
  const std::size_t comma = words.starts_with("exec:") ? std::string::npos : words.find(',');
  names.push_back(words.substr(0, comma));
  if (comma != std::string::npos) add_names(words.substr(comma + 1), names);
}

}  // namespace

oracle::PipeLimits limits_of(double time_limit, double simulation_factor) {
  oracle::PipeLimits limits;
  limits.cpu_seconds = time_limit;
  limits.wall_seconds = std::max(10.0, 10 * time_limit);  // on a busy machine a program takes seconds to start
  limits.simulation_factor = simulation_factor;
  limits.given_up = interrupted;
  return limits;
}

std::unique_ptr<oracle::Subject> connect(const std::string& connectable, oracle::PipeLimits limits) {
  if (connectable == "inproc:reference") return oracle::subjects::make_reference();
  if (connectable == "inproc:fast") return oracle::subjects::make_fast();
  if (connectable == "inproc:fast.warm") return oracle::subjects::make_fast_pairs("warm");
  if (is_in_process(connectable)) {
    throw InputError("subject \"" + connectable + '"',
                     unknown_among(connectable, {"inproc:reference", "inproc:fast", "inproc:fast.warm"}));
  }
  return oracle::connect(connectable, subjects_folder(), limits);
}

std::vector<std::string> subject_list(const std::vector<std::string>& asked_for) {
  std::vector<std::string> names;
  for (const std::string& words : asked_for) add_names(words, names);
  if (asked_for.empty()) names = oracle::subjects_beside(subjects_folder());
  if (names.empty()) throw InputError("subjects", "no subject was built; expected programs in " + subjects_folder());
  return names;
}

std::vector<std::string> answering(const std::string& query) {
  std::vector<std::string> names = subject_list({});
  std::erase_if(names, [&](const std::string& name) {
    return std::ranges::count(connect(name, {})->card().answers, query) == 0;
  });
  return names;
}

void start_afresh(oracle::Subject& subject) {
  if (auto* pipe = dynamic_cast<oracle::PipeSubject*>(&subject)) pipe->restart();
}

}  // namespace touchstone::app
