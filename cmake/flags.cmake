# All compiler flags. -ffp-contract=off: a fused multiply-add rounds once where the source rounds twice, so the same
# source would give different bits on different machines. Never -ffast-math: it breaks enclosures and flushes denormals
# for the whole process. EIGEN_DONT_VECTORIZE: with -march=native, a vectorised sum of three numbers adds in another
# order (tests/fast/fingerprint).
add_library(touchstone_flags INTERFACE)
target_compile_definitions(touchstone_flags INTERFACE EIGEN_DONT_VECTORIZE)
target_compile_options(touchstone_flags INTERFACE -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow -Wconversion
  -Wno-sign-conversion $<$<BOOL:${TOUCHSTONE_WERROR}>:-Werror>)

# g++ 12 vectorises straight-line code wrongly in two ways: it omits a rounding to float and back
# (`x.cast<float>().cast<double>()` of a vector; found by tests/oracle/tolerance_test.cpp), and it fuses products and
# sums (vfmaddsub, with -march=native) in spite of -ffp-contract=off (found by tests/fast/fingerprint). Vectorised loops
# are not affected.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(touchstone_flags INTERFACE -fno-tree-slp-vectorize)
  # From version 13 on, g++ suspects references that a function of a temporary returns. Ours refer to tables and caches
  # that live on; the sanitizers find those that do not.
  if(CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 13)
    target_compile_options(touchstone_flags INTERFACE -Wno-dangling-reference)
  endif()
endif()

# Coverage counters for libFuzzer in all sources; the targets of tests/fuzz link its main function too.
if(TOUCHSTONE_FUZZERS)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    message(FATAL_ERROR "TOUCHSTONE_FUZZERS needs clang++ (-DCMAKE_CXX_COMPILER=clang++) and its runtime (Debian: libclang-rt-14-dev)")
  endif()
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()

if(TOUCHSTONE_SANITIZE)
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
  # The sanitizers do not see a vector that nobody initialised; as NaN it shows.
  target_compile_definitions(touchstone_flags INTERFACE EIGEN_INITIALIZE_MATRICES_BY_NAN)
  # g++ warns wrongly of uninitialised values in code that the sanitizers insert (CGAL's filtered predicates); the
  # sanitizers find the real ones.
  target_compile_options(touchstone_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
endif()
