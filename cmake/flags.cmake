# One place for every flag. -ffp-contract=off: a fused multiply-add rounds once where the source rounds twice, so the same
# source would give other bits on other machines. Never -ffast-math: it breaks enclosures and flushes denormals for the process.
# EIGEN_DONT_VECTORIZE: a vectorised sum of three adds in another order with -march=native (tests/fast/fingerprint).
add_library(touchstone_flags INTERFACE)
target_compile_definitions(touchstone_flags INTERFACE EIGEN_DONT_VECTORIZE)
target_compile_options(touchstone_flags INTERFACE -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow -Wconversion
  -Wno-sign-conversion $<$<BOOL:${TOUCHSTONE_WERROR}>:-Werror>)

# g++ 12 vectorises straight code wrongly, two ways: a rounding to float and back (`x.cast<float>().cast<double>()` of a vector)
# is left out (tests/oracle/tolerance_test.cpp met it), and products and sums are fused (vfmaddsub, with -march=native) in spite
# of -ffp-contract=off (tests/fast/fingerprint met it). Plain vectorised loops are not concerned.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(touchstone_flags INTERFACE -fno-tree-slp-vectorize)
  # From g++ 13 on: suspects what a function of a temporary name refers to. Ours refer to tables and memories that stay; the
  # sanitizers find what does not.
  if(CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 13)
    target_compile_options(touchstone_flags INTERFACE -Wno-dangling-reference)
  endif()
endif()

if(TOUCHSTONE_SANITIZE)
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
  # g++ sees uninitialised values in what the sanitizers insert (CGAL's filtered predicates); they find the real ones.
  target_compile_options(touchstone_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
endif()
