# What the program is built from: writes the source that defines devo_evo::buildInfo().
#
# Runs as a script at every build, since a commit or an edit can happen between two builds; the file is only touched when
# something changed, so that nothing is compiled again otherwise.
#   cmake -D SOURCE_DIR= -D TEMPLATE= -D OUTPUT= -D VERSION= -D COMPILER= -P build_info.cmake

set(COMMIT "")
find_program(GIT git)
if(GIT AND EXISTS ${SOURCE_DIR}/.git)
  execute_process(COMMAND ${GIT} describe --always --dirty --abbrev=12 --exclude=*
    WORKING_DIRECTORY ${SOURCE_DIR} OUTPUT_VARIABLE description OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET
    RESULT_VARIABLE failed)
  if(NOT failed)
    set(COMMIT ${description})
  endif()
endif()

# Not configure_file(): it sets permissions even of a file that stays as it is, which only the owner may (Dockerfile).
file(READ ${TEMPLATE} template)
string(CONFIGURE "${template}" wanted @ONLY)
set(present "")
if(EXISTS ${OUTPUT})
  file(READ ${OUTPUT} present)
endif()
if(NOT wanted STREQUAL present)
  file(WRITE ${OUTPUT} "${wanted}")
endif()
