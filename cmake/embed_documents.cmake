# Writes the source that defines devo_evo::documents(): what "devo_evo explain" knows, from the documentation itself.
#   cmake -D SOURCE_DIR= -D OUTPUT= -D FILES=a;b -P embed_documents.cmake

set(source "#include \"explanation/documents.h\"\n\nnamespace devo_evo\n{\nconst std::vector<Document>& documents()\n{\n")
string(APPEND source "  static const std::vector<Document> all = {\n")
foreach(file ${FILES})
  # As bytes, since lists of CMake would swallow semicolons and brackets.
  file(READ ${SOURCE_DIR}/${file} hexadecimal HEX)
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "\\\\x\\1" literal "${hexadecimal}")
  string(APPEND source "    { \"${file}\", \"${literal}\" },\n")
endforeach()
string(APPEND source "  };\n  return all;\n}\n}  // namespace devo_evo\n")
file(WRITE ${OUTPUT} "${source}")
