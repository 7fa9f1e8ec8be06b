// Bullet's broad phases, in the precision that this library was built for.
#pragma once

#include <memory>

#include "oracle/subject.h"

namespace touchstone::oracle::subjects {

std::unique_ptr<Subject> make_bullet_dbvt();
std::unique_ptr<Subject> make_bullet_axis_sweep();

}  // namespace touchstone::oracle::subjects
