// The distances of fast/collider.h as a subject: Lin and Canny's walk between prepared solids.
#pragma once

#include <memory>
#include <string>

#include "oracle/subject_fwd.h"

namespace touchstone::oracle::subjects {

/// "collider": asked in the second of two frames, so that each walk starts where that of another pose ended.
/// "collider_first": asked in the first frame, without a memory.
std::unique_ptr<Subject> make_fast_collider(const std::string& name);

}  // namespace touchstone::oracle::subjects
