// Debian builds Simbody with its tracing on: some 20 kB of stdout a step.
#pragma once

namespace touchstone::oracle::subjects::in_simbody {

/// As long as it lives, what is printed to stdout goes nowhere. What was printed before still comes out.
class Muted {
 public:
  Muted();
  ~Muted();
  Muted(const Muted&) = delete;
  Muted& operator=(const Muted&) = delete;

 private:
  int stdout_;
};

}  // namespace touchstone::oracle::subjects::in_simbody
