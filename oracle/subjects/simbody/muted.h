// Debian builds Simbody with tracing enabled: it prints some 20 kB to stdout in each step.
#pragma once

namespace touchstone::oracle::subjects::in_simbody {

/// Discards all output to stdout during its lifetime. Earlier output is still printed.
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
