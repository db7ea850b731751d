# The panel for rviz, which is found by plugin_description.xml.
find_package(Qt5 REQUIRED COMPONENTS Test Widgets) # Test: for panel_rostest
find_package(rviz REQUIRED)
find_package(pluginlib REQUIRED)

file(GLOB rviz_plugin_sources CONFIGURE_DEPENDS src/rviz_plugin/*.cpp)
add_library(devo_evo_rviz SHARED ${rviz_plugin_sources})
target_compile_definitions(devo_evo_rviz PUBLIC QT_NO_KEYWORDS)
target_include_directories(devo_evo_rviz SYSTEM PRIVATE ${catkin_INCLUDE_DIRS} ${rviz_INCLUDE_DIRS})
target_link_libraries(devo_evo_rviz PUBLIC Qt5::Widgets PRIVATE devo_evo_ros ${CMAKE_DL_LIBS})
set_target_properties(devo_evo_rviz PROPERTIES LIBRARY_OUTPUT_DIRECTORY ${CATKIN_DEVEL_PREFIX}/lib)
