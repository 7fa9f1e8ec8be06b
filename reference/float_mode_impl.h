// The floating-point environment that the reference's arithmetic assumes.
#pragma once

#include <cfenv>

namespace touchstone::reference {

/// Round to nearest, denormals kept. A library built with -ffast-math (even one merely loaded) flushes denormals for
/// the whole process, and then intervals no longer enclose. What was set before is set again afterwards.
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
