# What `tdbd new` writes: shipped cases with the files that they name, embedded in the program as they are.

# Files below ROOT, of one kind; the first is the one that COMMAND runs.
function(tdbd_template kind command root)
  foreach(file ${ARGN})
    set(source "${PROJECT_SOURCE_DIR}/${root}/${file}")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${source}")
    file(READ "${source}" text)
    set_property(GLOBAL APPEND_STRING PROPERTY TDBD_TEMPLATE_ROWS "    {\"${kind}\", \"${command}\", \"${file}\", R\"tdbd(${text})tdbd\"},\n")
  endforeach()
endfunction()

# Adds them to a program.
function(tdbd_add_templates target)
  get_property(TDBD_TEMPLATE_ROWS GLOBAL PROPERTY TDBD_TEMPLATE_ROWS)
  configure_file("${PROJECT_SOURCE_DIR}/src/app/templates.cpp.in" "${CMAKE_CURRENT_BINARY_DIR}/generated/templates.cpp" @ONLY)
  target_sources(${target} PRIVATE "${CMAKE_CURRENT_BINARY_DIR}/generated/templates.cpp")
endfunction()
