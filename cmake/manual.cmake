# The manual page and the completion for bash, written by the tool itself. (Another processor's tool cannot be run here.)
if(NOT CMAKE_CROSSCOMPILING)
  set(manual_files ${CMAKE_CURRENT_BINARY_DIR}/devo_evo.1 ${CMAKE_CURRENT_BINARY_DIR}/devo_evo.bash)
  add_custom_command(OUTPUT ${manual_files}
    COMMAND devo_evo_cli manual > devo_evo.1
    COMMAND devo_evo_cli manual --bash > devo_evo.bash
    DEPENDS devo_evo_cli
    WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}
    COMMENT "Writing the manual page")
  add_custom_target(devo_evo_manual ALL DEPENDS ${manual_files})
endif()
