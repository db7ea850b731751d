# What "devo_evo explain" says is what the documentation says: its pages and the message definitions become part of the
# program, anew whenever one of them changes.

file(GLOB explaining CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} msg/*.msg srv/*.srv)
list(PREPEND explaining docs/measures.md docs/archive.md docs/tool.md)
set(embedded_documents ${CMAKE_CURRENT_BINARY_DIR}/documents.cpp)
add_custom_command(OUTPUT ${embedded_documents}
  COMMAND ${CMAKE_COMMAND}
    -D SOURCE_DIR=${CMAKE_CURRENT_SOURCE_DIR}
    -D OUTPUT=${embedded_documents}
    -D "FILES=${explaining}"
    -P ${CMAKE_CURRENT_SOURCE_DIR}/cmake/embed_documents.cmake
  DEPENDS ${explaining} cmake/embed_documents.cmake
  COMMENT "Embedding the documentation"
  VERBATIM)
