// What an answer of fast cost: how often each mark is reached.
#pragma once

#include <string>

#include "oracle/subject.h"

namespace touchstone::oracle::subjects {

/// Asks the subject, which answers by functions of fast in this thread.
Answer<Work> fast_work(Subject& subject, const std::string& query, const Scene& scene);

}  // namespace touchstone::oracle::subjects
