// Bullet's broad phases, in the precision for which this library is built.
#pragma once

#include <memory>

#include "oracle/subject_fwd.h"

namespace touchstone::oracle::subjects {

std::unique_ptr<Subject> make_bullet_dbvt();
std::unique_ptr<Subject> make_bullet_axis_sweep();

}  // namespace touchstone::oracle::subjects
