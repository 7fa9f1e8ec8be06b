// The operators are replaced for the whole program. The non-throwing one is replaced too: a sanitizer's own version
// would not match this operator delete.
#include "tests/fast/allocations.h"

#include <malloc.h>

#include <cstdlib>
#include <new>

namespace {
std::size_t count = 0;
std::size_t held = 0;

void give_back(void* memory) {
  held -= malloc_usable_size(memory);
  std::free(memory);
}
}  // namespace

void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++count;
  void* memory = std::malloc(size == 0 ? 1 : size);
  held += malloc_usable_size(memory);
  return memory;
}

void* operator new(std::size_t size) {
  void* memory = operator new(size, std::nothrow);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

void operator delete(void* memory) noexcept { give_back(memory); }
void operator delete(void* memory, std::size_t) noexcept { give_back(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { give_back(memory); }

namespace touchstone::tests {

std::size_t allocations() { return count; }
std::size_t bytes_held() { return held; }

}  // namespace touchstone::tests
