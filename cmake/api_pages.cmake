# cmake -D SOURCE=… -D FOLDER=… -P api_pages.cmake writes pages of the public headers to FOLDER/html, by Doxygen.
cmake_minimum_required(VERSION 3.25)

find_program(doxygen doxygen)
if(NOT doxygen)
  message(FATAL_ERROR "The API pages need Doxygen; Debian's package is doxygen.")
endif()

set(DESTINATION ${FOLDER}/include)
include(${CMAKE_CURRENT_LIST_DIR}/public_headers.cmake)
file(COPY ${SOURCE}/docs/api.md DESTINATION ${FOLDER})

# Doxygen skips // comments and fills paragraphs. So the comment on top of a header becomes that of the file, and
# indented lines (formulas and tables) become blocks of code; but not those that continue an item of a list.
file(GLOB_RECURSE headers ${FOLDER}/include/*.h)
foreach(header IN LISTS headers)
  file(READ ${header} text)
  string(FIND "${text}" "#pragma once" end)
  string(SUBSTRING "${text}" 0 ${end} top)
  string(SUBSTRING "${text}" ${end} -1 rest)
  string(REGEX REPLACE "(^|\n)//" "\\1///" top "${top}")
  set(text "/// @file\n${top}${rest}")
  set(before)
  while(NOT text STREQUAL before)
    set(before "${text}")
    string(REGEX REPLACE "(\n */// - [^\n]*)\n *///  +([^ ])" "\\1 \\2" text "${text}")
  endwhile()
  string(REGEX REPLACE "((\n *///   [^\n]*)+)" "\n/// @code{.unparsed}\\1\n/// @endcode" text "${text}")
  file(WRITE ${header} "${text}")
endforeach()

execute_process(COMMAND ${doxygen} ${SOURCE}/docs/Doxyfile WORKING_DIRECTORY ${FOLDER} COMMAND_ERROR_IS_FATAL ANY)
message(STATUS "API pages: ${FOLDER}/html/index.html")
