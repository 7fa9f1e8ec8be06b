# Names all missing libraries at once, and what each is for. find_package would stop at the first one, and name a file
# of CMake's.
# header, or one of several | what it is | Debian's package
set(needed
  "Eigen/Core|Eigen 3.4 (vectors and matrices)|libeigen3-dev"
  "CGAL/version.h|CGAL 5 or 6 (exact geometry)|libcgal-dev"
  "gmp.h|GMP (rational numbers)|libgmp-dev"
  "mpfr.h|MPFR (numbers of many digits)|libmpfr-dev"
  "mpfi.h|MPFI (intervals)|libmpfi-dev"
  "nlohmann/json.hpp|nlohmann-json (JSON)|nlohmann-json3-dev"
  "CLI/CLI.hpp|CLI11 (the command line)|libcli11-dev"
  "fmt/core.h|fmt (text)|libfmt-dev"
  "nlopt.h|NLopt (optimisation without derivatives)|libnlopt-dev")
if(TOUCHSTONE_TESTS)
  list(APPEND needed
    "catch2/catch_all.hpp,catch2/catch.hpp|Catch2 2 or 3 (tests)|catch2"
    "rapidcheck.h|RapidCheck (tests)|librapidcheck-dev")
endif()

set(missing "")
foreach(entry IN LISTS needed)
  string(REPLACE "|" ";" entry ${entry})
  list(POP_FRONT entry headers what package)
  string(REPLACE "," ";" headers ${headers})
  unset(found)
  find_path(found NAMES ${headers} PATH_SUFFIXES eigen3 NO_CACHE)
  if(NOT found)
    string(APPEND missing "\n  ${what}; Debian's package ${package}")
  endif()
endforeach()
if(missing)
  message(FATAL_ERROR "These libraries, with their headers, are missing:${missing}")
endif()
