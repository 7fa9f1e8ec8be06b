# What `cmake --install` copies: the program, its subjects, and the libraries with their headers for find_package(touchstone).

# Everything that ./touchstone needs to run, and nothing that only tests need.
add_custom_target(program)

function(touchstone_install target layer is_executable)
  if(NOT is_executable AND layer IN_LIST TOUCHSTONE_INSTALLED_LAYERS)
    install(TARGETS ${target} EXPORT touchstone ARCHIVE DESTINATION lib)
  elseif(is_executable AND layer STREQUAL "app")
    install(TARGETS ${target} RUNTIME DESTINATION bin)
    add_dependencies(program ${target})
  elseif(is_executable AND layer STREQUAL "subject")
    install(TARGETS ${target} RUNTIME DESTINATION libexec/touchstone)
    add_dependencies(program ${target})
  endif()
endfunction()

set(TOUCHSTONE_INSTALLED_LAYERS model reference oracle properties fast)

foreach(folder IN LISTS TOUCHSTONE_INSTALLED_LAYERS)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder} DESTINATION include/touchstone FILES_MATCHING PATTERN "*.h"
    PATTERN "*_impl.h" EXCLUDE PATTERN "subjects" EXCLUDE PATTERN "corpus" EXCLUDE)
endforeach()

include(CMakePackageConfigHelpers)
set(package ${CMAKE_CURRENT_BINARY_DIR}/package)
configure_file(${PROJECT_SOURCE_DIR}/cmake/TouchstoneConfig.cmake.in ${package}/touchstone-config.cmake @ONLY)
write_basic_package_version_file(${package}/touchstone-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${package}/touchstone-config.cmake ${package}/touchstone-config-version.cmake DESTINATION lib/cmake/touchstone)
install(EXPORT touchstone NAMESPACE touchstone:: DESTINATION lib/cmake/touchstone FILE touchstone-targets.cmake)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION share/doc/touchstone)
