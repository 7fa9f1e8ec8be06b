// Bullet's contact solver, in the precision that this library was built for, asked for one impact.
#pragma once

#include <memory>
#include <string>

#include "oracle/subject.h"

namespace touchstone::oracle::subjects {

/// Settings "impulse": as shipped; "impulse_tuned": as its maintainers advise against lost restitution.
std::unique_ptr<Subject> make_bullet_impulse(const std::string& settings);

}  // namespace touchstone::oracle::subjects
