// The subject's end of the pipe: answers JSON lines on stdin and stdout (docs/protocol.md) with a Subject of this
// process.
#pragma once

#include <functional>

#include "model/json.h"
#include "oracle/query.h"
#include "oracle/subject.h"

namespace touchstone::oracle {

/// Answers until `stop` or the end of stdin, then returns the exit code: 0, or 2 if stdout cannot be written. It
/// reserves stdout for answers and sends anything else that is printed there to stderr. Each query runs in the default
/// floating-point environment, whatever a library may have set. The subject gets only valid scenes with all their faces
/// (oracle/process/received_scene.h). An exception becomes the answer Breaks::Kind::threw; so does a line that cannot
/// be read or a scene that is refused. Then the next line is read.
int serve(Subject& subject);

/// The result of an answer as JSON.
using AnswerFunction = std::function<Answer<Json>(const Query&, const Scene&)>;

/// A program in the engine's own API that prints a text and asks the query (Subject::reproduce).
using SnippetFunction = std::function<Answer<std::string>(const std::string&, const Scene&, const std::string&)>;

/// What the answer takes (Subject::work).
using WorkFunction = std::function<Answer<Work>(const std::string&, const Scene&)>;

struct Functions {
  AnswerFunction answer;
  SnippetFunction snippet;
  WorkFunction work;
};

/// The same with any functions. Throws std::system_error if stdout cannot be written.
void serve(const Card& card, const Functions& functions);

}  // namespace touchstone::oracle
