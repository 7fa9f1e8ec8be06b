// The other end of the pipe: lets a Subject in this process answer JSON lines on stdin and stdout (docs/protocol.md).
#pragma once

#include "oracle/subject.h"

namespace touchstone::oracle {

/// Answers until `stop` or the end of stdin, then returns the exit code: 0, or 2 if stdout cannot be written.
/// Takes stdout for itself: whatever else prints there is sent to stderr. Each question is asked in the default
/// floating-point environment, whatever a library may have set. The subject sees valid scenes with all their faces only
/// (oracle/received_scene.h). An exception is an answer: breaks, threw; so is a line that cannot be read or a scene
/// that is refused, and the next line is read.
int serve(Subject& subject);

}  // namespace touchstone::oracle
