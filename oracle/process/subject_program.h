// The whole program of a subject. This header declares the little that such a program needs: there are some 60 of
// them, and each would compile the text of all queries.
#pragma once

#include <memory>
#include <string>

#include "oracle/subject_fwd.h"

namespace touchstone::oracle {

/// Makes the subject and serves it on stdin and stdout (oracle/process/serve.h); returns the exit code.
int subject_program(std::unique_ptr<Subject> (*make)());

/// The same for one of several subjects of a library.
int subject_program(std::unique_ptr<Subject> (*make)(const std::string& name), const std::string& name);

}  // namespace touchstone::oracle
