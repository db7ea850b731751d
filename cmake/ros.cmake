# Messages, nodes and launch files: everything that needs ROS.

# Where another python3 stands first on PATH, catkin would configure with one that lacks its modules.
foreach(variable PYTHON_EXECUTABLE Python3_EXECUTABLE)
  if(NOT DEFINED ${variable})
    set(${variable} /usr/bin/python3 CACHE FILEPATH "The Python that ROS is installed for")
  endif()
endforeach()
# Catkin caches the environment of its first configure, in which this folder must exist already.
file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/devel/lib/python3/dist-packages)

find_package(catkin REQUIRED COMPONENTS
  roscpp message_generation std_msgs std_srvs geometry_msgs visualization_msgs diagnostic_msgs)

add_message_files(DIRECTORY msg)
add_service_files(DIRECTORY srv)
generate_messages(DEPENDENCIES std_msgs geometry_msgs)

catkin_package(
  INCLUDE_DIRS include
  LIBRARIES devo_evo_core
  CATKIN_DEPENDS roscpp message_runtime std_msgs std_srvs geometry_msgs visualization_msgs diagnostic_msgs)

file(GLOB ros_sources CONFIGURE_DEPENDS src/ros/*.cpp)
add_library(devo_evo_ros STATIC ${ros_sources})
add_dependencies(devo_evo_ros ${PROJECT_NAME}_generate_messages_cpp)
target_include_directories(devo_evo_ros PUBLIC include src SYSTEM PUBLIC ${catkin_INCLUDE_DIRS})
target_link_libraries(devo_evo_ros PUBLIC devo_evo_core ${catkin_LIBRARIES})

foreach(node evolver simulator)
  add_executable(${node} src/nodes/${node}.cpp)
  target_link_libraries(${node} PRIVATE devo_evo_ros)
endforeach()

set(ROS_LIBEXEC ${CATKIN_DEVEL_PREFIX}/lib/${PROJECT_NAME})
set_target_properties(evolver simulator devo_evo_cli PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${ROS_LIBEXEC})

install(TARGETS evolver simulator devo_evo_cli RUNTIME DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
install(TARGETS devo_evo_core ARCHIVE DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION})
install(DIRECTORY include/${PROJECT_NAME}/ DESTINATION ${CATKIN_PACKAGE_INCLUDE_DESTINATION})
install(DIRECTORY launch config DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
