// How often this program has asked the heap for memory, and how much it holds: for tests that promise a steady frame
// asks for none, and that a body costs little.
#pragma once

#include <cstddef>

namespace touchstone::tests {

std::size_t allocations();

/// Bytes, as the heap rounds them.
std::size_t bytes_held();

}  // namespace touchstone::tests
