// The other end of the pipe: lets a Subject in this process answer JSON lines on stdin and stdout (docs/protocol.md).
#pragma once

#include "oracle/subject.h"

namespace touchstone::oracle {

/// Answers until `stop` or the end of stdin, then returns the exit code: 0, or 2 for a message that it cannot read.
/// Takes stdout for itself: whatever else prints there is sent to stderr. Each question is asked in the default
/// floating-point environment, whatever a library may have set. An exception is an answer: breaks, threw.
int serve(Subject& subject);

}  // namespace touchstone::oracle
