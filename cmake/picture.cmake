# Pictures and films (docs/pictures.md): OSMesa draws without a display, Cairo writes and draws lines upon it.
find_path(OSMESA_INCLUDE_DIR GL/osmesa.h REQUIRED)
find_library(OSMESA_LIBRARY OSMesa REQUIRED)
find_path(CAIRO_INCLUDE_DIR cairo.h PATH_SUFFIXES cairo REQUIRED)
find_library(CAIRO_LIBRARY cairo REQUIRED)

file(GLOB picture_sources CONFIGURE_DEPENDS src/picture/*.cpp)
add_library(devo_evo_picture STATIC ${picture_sources})
target_include_directories(devo_evo_picture PRIVATE src)
target_include_directories(devo_evo_picture SYSTEM PRIVATE ${OSMESA_INCLUDE_DIR} ${CAIRO_INCLUDE_DIR})
target_link_libraries(devo_evo_picture PUBLIC devo_evo_core PRIVATE ${OSMESA_LIBRARY} ${CAIRO_LIBRARY})
