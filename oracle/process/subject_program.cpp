#include "oracle/process/subject_program.h"

#include "oracle/process/serve.h"

namespace touchstone::oracle {

int subject_program(std::unique_ptr<Subject> (*make)()) { return serve(*make()); }

int subject_program(std::unique_ptr<Subject> (*make)(const std::string&), const std::string& name) {
  return serve(*make(name));
}

}  // namespace touchstone::oracle
