# What `cmake --install` copies: the program, its subjects, and the libraries with their headers for
# find_package(touchstone).

function(touchstone_install target layer is_executable)
  if(NOT is_executable AND layer IN_LIST TOUCHSTONE_INSTALLED_LAYERS)
    install(TARGETS ${target} EXPORT touchstone ARCHIVE DESTINATION lib)
  elseif(is_executable AND layer STREQUAL "app")
    set_property(GLOBAL APPEND PROPERTY TOUCHSTONE_PROGRAMS ${target})
  endif()
endfunction()

# A target that builds everything that ./touchstone needs to run, and nothing that only tests need. (Each program
# installs itself.)
function(touchstone_program_target)
  add_custom_target(program)
  foreach(property TOUCHSTONE_PROGRAMS TOUCHSTONE_SUBJECT_PROGRAMS)
    get_property(programs GLOBAL PROPERTY ${property})
    if(programs)
      add_dependencies(program ${programs})
    endif()
  endforeach()
endfunction()

set(TOUCHSTONE_INSTALLED_LAYERS model reference oracle properties fast)

# The sub-folders of reference/ are private: only its headers on top are installed.
foreach(folder IN LISTS TOUCHSTONE_INSTALLED_LAYERS)
  if(folder STREQUAL "reference")
    file(GLOB public_headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/reference/*.h)
    install(FILES ${public_headers} DESTINATION include/touchstone/reference)
  else()
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder} DESTINATION include/touchstone FILES_MATCHING PATTERN "*.h"
      PATTERN "subjects" EXCLUDE PATTERN "corpus" EXCLUDE)
  endif()
endforeach()

include(CMakePackageConfigHelpers)
set(package ${CMAKE_CURRENT_BINARY_DIR}/package)
configure_file(${PROJECT_SOURCE_DIR}/cmake/TouchstoneConfig.cmake.in ${package}/touchstone-config.cmake @ONLY)
write_basic_package_version_file(${package}/touchstone-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${package}/touchstone-config.cmake ${package}/touchstone-config-version.cmake DESTINATION lib/cmake/touchstone)
install(EXPORT touchstone NAMESPACE touchstone:: DESTINATION lib/cmake/touchstone FILE touchstone-targets.cmake)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION share/doc/touchstone)
