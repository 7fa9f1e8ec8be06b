#include "tests/properties/fixed_subject.h"

namespace touchstone::tests {

FixedSubject::FixedSubject() = default;
FixedSubject::~FixedSubject() = default;

}  // namespace touchstone::tests
