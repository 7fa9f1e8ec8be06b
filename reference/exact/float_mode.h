// The floating-point environment that the reference's arithmetic assumes.
#pragma once

#include <cfenv>

namespace touchstone::reference {

/// Sets rounding to nearest and keeps denormals; restores the previous mode at the end. A library built with
/// -ffast-math, even if only loaded, makes the whole process flush denormals, and then intervals no longer enclose.
class DefaultFloatMode {
 public:
  DefaultFloatMode() {
    std::fegetenv(&before_);
    std::fesetenv(FE_DFL_ENV);
  }
  ~DefaultFloatMode() { std::fesetenv(&before_); }
  DefaultFloatMode(const DefaultFloatMode&) = delete;
  DefaultFloatMode& operator=(const DefaultFloatMode&) = delete;

 private:
  std::fenv_t before_;
};

}  // namespace touchstone::reference
