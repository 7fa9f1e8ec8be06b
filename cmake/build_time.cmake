# Keeps a clean build short: code is optimised where time is spent at run time, headers that nearly every source
# includes are precompiled once for each set of flags, and several sources are compiled as one unit. Sources still
# include what they use (a build with -D CMAKE_UNITY_BUILD=OFF -D CMAKE_DISABLE_PRECOMPILE_HEADERS=ON checks it). The
# bits of answers do not depend on the level (tests/fast/fingerprint).

# The compiler collects its garbage once it has 512 MB, not from 128 MB on: a sixth less time, 130 MB more memory for a
# unit. Such a unit takes 0.6 to 1.1 GB.
add_compile_options($<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=524288>)

# In a Release build, code that computes answers has the level of the build type, code that judges answers a lower one,
# and code that only prints them, and tests, the lowest: a seventh less time to compile than -O1.
function(touchstone_optimise target layer)
  set(level)
  get_target_property(links ${target} LINK_LIBRARIES)
  if(layer STREQUAL "app" OR links MATCHES "Catch2")
    set(level -Og)
  elseif(layer MATCHES "^(reference|oracle|properties|subject)$")
    set(level -O2)
  endif()
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:${level}>)
  # Below -O3, g++ 12 warns wrongly of uninitialised values in a std::variant's moves; clang and the sanitizers find
  # real ones.
  if(level)
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  endif()
  touchstone_precompile(${target} "${level}")
endfunction()

function(touchstone_precompile target level)
  set(headers <algorithm> <array> <cmath> <cstdint> <functional> <limits> <map> <memory> <optional> <span> <string> <utility> <variant>
    <vector> <Eigen/Geometry>)
  get_target_property(links ${target} LINK_LIBRARIES)
  get_target_property(type ${target} TYPE)
  if(target MATCHES "^touchstone-subject-" AND NOT target MATCHES "canary")  # a line each
    return()
  endif()
  if(links MATCHES "CGAL|fcl|simbody|dart")  # these libraries add flags of their own
    if(target STREQUAL "touchstone_reference")
      target_precompile_headers(${target} PRIVATE ${headers} <CGAL/Interval_nt.h> <boost/multiprecision/mpfi.hpp>
        <boost/multiprecision/mpfr.hpp> <gmpxx.h>)
    endif()
    return()
  endif()
  set(kind ${type})
  if(target STREQUAL "touchstone_app")  # nearly all of it formats text, half of it reads or writes JSON
    target_precompile_headers(${target} PRIVATE ${headers} <filesystem> <fmt/format.h> <fmt/ranges.h> <nlohmann/json.hpp>)
    return()
  endif()
  if(links MATCHES "Catch2")
    set(kind tests)
    list(APPEND headers ${PROJECT_SOURCE_DIR}/tests/catch.h)
  endif()
  set(owner touchstone_headers_${kind}${level})
  if(NOT TARGET ${owner})
    touchstone_headers(${owner} ${type} "${level}" ${headers})
  endif()
  target_precompile_headers(${target} REUSE_FROM ${owner})
endfunction()

# A target that only precompiles headers. It defines no macro that one of its users may lack.
function(touchstone_headers owner type level)
  set(source ${PROJECT_BINARY_DIR}/headers/${type}.cpp)
  if(type STREQUAL "EXECUTABLE")
    file(CONFIGURE OUTPUT ${source} CONTENT "int main() {}\n")
    add_executable(${owner} EXCLUDE_FROM_ALL ${source})
  else()
    file(CONFIGURE OUTPUT ${source} CONTENT "\n")
    add_library(${owner} STATIC EXCLUDE_FROM_ALL ${source})
  endif()
  target_compile_features(${owner} PRIVATE cxx_std_20)
  target_compile_options(${owner} PRIVATE $<$<CONFIG:Release>:${level}>)
  target_link_libraries(${owner} PRIVATE touchstone_flags Eigen3::Eigen)
  if(owner MATCHES "tests")
    target_link_libraries(${owner} PRIVATE Catch2::Catch2)
  endif()
  target_precompile_headers(${owner} PRIVATE ${ARGN})
endfunction()

# touchstone_units(<target> <units> [SALT <number>] [APART <sources> …]): compiles the sources of a target in so many
# units. A source's unit depends on its own name and the salt alone, so a new source changes one unit. Sources of one
# unit share an unnamed namespace, so they may not clash in local names. A salt is any number with which they do not, and
# with which the units are of like size. Where a new source clashes, rename the local name, or let the source stand APART.
function(touchstone_units target units)
  cmake_parse_arguments(ARG "" "SALT" "APART" ${ARGN})
  if(DEFINED CMAKE_UNITY_BUILD)
    return()
  endif()
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    cmake_path(IS_ABSOLUTE source generated)
    if(NOT generated AND NOT source IN_LIST ARG_APART)
      string(MD5 hash ${ARG_SALT}${source})
      string(SUBSTRING ${hash} 0 6 hash)
      math(EXPR unit "0x${hash} % ${units}")
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${unit})
    endif()
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()
