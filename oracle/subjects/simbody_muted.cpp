#include "oracle/subjects/simbody_muted.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <iostream>

namespace touchstone::oracle::subjects::in_simbody {
namespace {

/// Takes `to`; returns what stdout was.
int redirect(int to) {
  std::fflush(stdout);
  std::cout.flush();
  const int was = dup(STDOUT_FILENO);
  dup2(to, STDOUT_FILENO);
  close(to);
  return was;
}

}  // namespace

Muted::Muted() : stdout_(redirect(open("/dev/null", O_WRONLY | O_CLOEXEC))) {}

Muted::~Muted() { close(redirect(stdout_)); }

}  // namespace touchstone::oracle::subjects::in_simbody
