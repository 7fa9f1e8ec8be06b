// How often this program has asked the heap for memory: for tests that promise a steady frame asks for none.
#pragma once

#include <cstddef>

namespace touchstone::tests {

std::size_t allocations();

}  // namespace touchstone::tests
