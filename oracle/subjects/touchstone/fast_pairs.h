// The parts of fast that follow bodies over time, as subjects: fast/collider.h (Lin and Canny's walk between prepared
// solids) and PenetrationPair of fast/penetration.h.
#pragma once

#include <memory>
#include <string>

#include "oracle/subject_fwd.h"

namespace touchstone::oracle::subjects {

/// "warm": asked in the second of two frames, so each search starts where that of another pose ended; also about the
/// near pairs of many bodies that come, move and go.
/// "cold": asked in the first frame.
std::unique_ptr<Subject> make_fast_pairs(const std::string& name);

}  // namespace touchstone::oracle::subjects
