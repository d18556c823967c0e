# The manual page and bash's completion: the program writes them of what it knows of itself, so that they cannot fall behind
# it. Run with -P it writes one: PROGRAM, WORD (behind `tdbd help`), FILE.

if(CMAKE_SCRIPT_MODE_FILE)
  execute_process(COMMAND "${PROGRAM}" help "${WORD}" OUTPUT_FILE "${FILE}" COMMAND_ERROR_IS_FATAL ANY)
  return()
endif()

include(GNUInstallDirs)

function(tdbd_page word folder name)
  set(file "${PROJECT_BINARY_DIR}/${folder}/${name}")
  file(MAKE_DIRECTORY "${PROJECT_BINARY_DIR}/${folder}")
  add_custom_command(OUTPUT "${file}"
    COMMAND "${CMAKE_COMMAND}" "-DPROGRAM=$<TARGET_FILE:tdbd>" "-DWORD=${word}" "-DFILE=${file}"
            -P "${PROJECT_SOURCE_DIR}/cmake/TdbdPages.cmake"
    DEPENDS tdbd VERBATIM COMMENT "Writing ${folder}/${name}")
  install(FILES "${file}" DESTINATION "${CMAKE_INSTALL_DATADIR}/${folder}")
  set_property(GLOBAL APPEND PROPERTY TDBD_PAGES "${file}")
endfunction()

tdbd_page(--man man/man1 tdbd.1)
tdbd_page(--completion bash-completion/completions tdbd)
get_property(TDBD_PAGES GLOBAL PROPERTY TDBD_PAGES)
add_custom_target(tdbd_pages ALL DEPENDS ${TDBD_PAGES})
