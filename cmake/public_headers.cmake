# cmake -D SOURCE=… -D DESTINATION=… -P public_headers.cmake copies the public headers to DESTINATION/touchstone: those
# on top of each layer, and the private ones that they include. The copies include each other by the paths that users
# write, "touchstone/model/json.h". So a project may have folders of its own that are named model or fast.
cmake_minimum_required(VERSION 3.25)

set(headers)
foreach(layer model reference fast oracle properties)
  file(GLOB top_headers RELATIVE ${SOURCE} ${SOURCE}/${layer}/*.h)
  list(APPEND headers ${top_headers})
endforeach()

file(REMOVE_RECURSE ${DESTINATION}/touchstone)
set(copied)
while(headers)
  list(POP_FRONT headers header)
  if(header IN_LIST copied)
    continue()
  endif()
  list(APPEND copied ${header})
  file(READ ${SOURCE}/${header} text)
  string(REGEX MATCHALL "#include \"[^\"]+" includes "${text}")
  list(TRANSFORM includes REPLACE "#include \"" "")
  list(APPEND headers ${includes})
  string(REPLACE "#include \"" "#include \"touchstone/" text "${text}")
  file(WRITE ${DESTINATION}/touchstone/${header} "${text}")
endwhile()
