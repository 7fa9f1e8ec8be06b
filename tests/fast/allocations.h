// Counts the program's heap allocations and the memory it holds, for tests that a steady frame allocates nothing and
// that a body costs little.
#pragma once

#include <cstddef>

namespace touchstone::tests {

std::size_t allocations();

/// In bytes, as the heap rounds them.
std::size_t bytes_held();

}  // namespace touchstone::tests
