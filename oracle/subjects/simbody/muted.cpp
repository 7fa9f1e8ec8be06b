#include "oracle/subjects/simbody/muted.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <iostream>

namespace touchstone::oracle::subjects::in_simbody {
namespace {

/// Redirects stdout to the descriptor `to`; returns a descriptor of the previous stdout.
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
