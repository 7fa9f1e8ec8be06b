# What `cmake --install` copies: the program, its subjects, and the libraries with their headers for
# find_package(touchstone). The target `api` makes pages of those headers.

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

set(package ${CMAKE_CURRENT_BINARY_DIR}/package)
install(CODE "execute_process(COMMAND_ERROR_IS_FATAL ANY COMMAND \"${CMAKE_COMMAND}\" -D \"SOURCE=${PROJECT_SOURCE_DIR}\"
  -D \"DESTINATION=${package}/include\" -P \"${PROJECT_SOURCE_DIR}/cmake/public_headers.cmake\")")
install(DIRECTORY ${package}/include/touchstone DESTINATION include)

add_custom_target(api COMMAND ${CMAKE_COMMAND} -D SOURCE=${PROJECT_SOURCE_DIR} -D FOLDER=${PROJECT_BINARY_DIR}/api
  -P ${PROJECT_SOURCE_DIR}/cmake/api_pages.cmake USES_TERMINAL VERBATIM)

include(CMakePackageConfigHelpers)
configure_file(${PROJECT_SOURCE_DIR}/cmake/TouchstoneConfig.cmake.in ${package}/touchstone-config.cmake @ONLY)
write_basic_package_version_file(${package}/touchstone-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${package}/touchstone-config.cmake ${package}/touchstone-config-version.cmake DESTINATION lib/cmake/touchstone)
install(EXPORT touchstone NAMESPACE touchstone:: DESTINATION lib/cmake/touchstone FILE touchstone-targets.cmake)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/cmake/copyright DESTINATION share/doc/touchstone
  COMPONENT program)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs/ DESTINATION share/doc/touchstone COMPONENT program)
install(FILES ${PROJECT_SOURCE_DIR}/adapters/python/touchstone_exact.py DESTINATION share/touchstone/python
  COMPONENT program)
