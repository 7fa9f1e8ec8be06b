// A canary as a program: `touchstone-subject-canary ID` answers like the reference, but for one lie.
#include <iostream>

#include "model/input_error.h"
#include "oracle/process/serve.h"
#include "oracle/subjects/canaries/canaries.h"
#include "oracle/subjects/touchstone/reference.h"

int main(int argc, char** argv) {
  namespace subjects = touchstone::oracle::subjects;
  if (argc != 2) {
    std::cerr << "usage: touchstone-subject-canary ID\n";
    for (const subjects::Canary& canary : subjects::canaries())
      std::cerr << "  " << canary.id << ": " << canary.says << '\n';
    return 2;
  }
  try {
    return touchstone::oracle::serve(*subjects::canary(argv[1]).make(subjects::make_reference()));
  } catch (const touchstone::InputError& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
