// Bullet's narrow phase, in the precision that this library was built for.
#pragma once

#include <memory>

#include "oracle/subject.h"

namespace touchstone::oracle::subjects {

std::unique_ptr<Subject> make_bullet();

}  // namespace touchstone::oracle::subjects
