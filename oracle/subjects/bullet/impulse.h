// Bullet's contact solver as an impulse query (one impact), in the precision for which this library is built.
#pragma once

#include <memory>
#include <string>

#include "oracle/subject_fwd.h"

namespace touchstone::oracle::subjects {

/// Settings "impulse": the defaults; "impulse_tuned": as Bullet's maintainers advise against lost restitution.
std::unique_ptr<Subject> make_bullet_impulse(const std::string& settings);

}  // namespace touchstone::oracle::subjects
