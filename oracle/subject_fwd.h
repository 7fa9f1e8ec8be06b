// Declares Subject (oracle/subject.h), for headers that only make one: the text of all queries stays out of them.
#pragma once

#include <memory>

namespace touchstone::oracle {

class Subject;

}  // namespace touchstone::oracle
