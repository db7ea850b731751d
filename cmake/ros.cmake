# The nodes: everything that links ROS.

file(GLOB ros_sources CONFIGURE_DEPENDS src/ros/*.cpp)
add_library(devo_evo_ros STATIC ${ros_sources})
add_dependencies(devo_evo_ros ${PROJECT_NAME}_generate_messages_cpp)
target_include_directories(devo_evo_ros PUBLIC include src)
target_link_libraries(devo_evo_ros PUBLIC devo_evo_core ${catkin_LIBRARIES})

set(nodes evolver simulator simulators player recorder study)
foreach(node ${nodes})
  add_executable(${node} src/nodes/${node}.cpp)
  target_link_libraries(${node} PRIVATE devo_evo_ros)
endforeach()
foreach(target devo_evo_ros ${nodes})
  target_include_directories(${target} SYSTEM PRIVATE ${catkin_INCLUDE_DIRS})
endforeach()

# Those that draw are apart, so that the others need not load OSMesa.
file(GLOB ros_picture_sources CONFIGURE_DEPENDS src/ros/picture/*.cpp)
add_library(devo_evo_ros_picture STATIC ${ros_picture_sources})
add_dependencies(devo_evo_ros_picture ${PROJECT_NAME}_generate_messages_cpp)
target_link_libraries(devo_evo_ros_picture PUBLIC devo_evo_picture devo_evo_ros)
set(picture_nodes lineage renderer)
foreach(node ${picture_nodes})
  add_executable(${node} src/nodes/${node}.cpp)
  target_link_libraries(${node} PRIVATE devo_evo_ros_picture)
endforeach()
foreach(target devo_evo_ros_picture ${picture_nodes})
  target_include_directories(${target} SYSTEM PRIVATE ${catkin_INCLUDE_DIRS})
endforeach()
list(APPEND nodes ${picture_nodes})
target_link_libraries(devo_evo_cli PRIVATE devo_evo_ros_picture) # for bags

# Where rosrun and roslaunch look for programs.
set_target_properties(${nodes} devo_evo_cli PROPERTIES
  RUNTIME_OUTPUT_DIRECTORY ${CATKIN_DEVEL_PREFIX}/lib/${PROJECT_NAME})

# What run.sh preloads. A sanitizer's runtime must come first, so a build with one goes without.
if(NOT DEVO_EVO_SANITIZE)
  add_library(devo_evo_loopback MODULE src/nodes/loopback.cpp)
  target_link_libraries(devo_evo_loopback PRIVATE ${CMAKE_DL_LIBS})
  set_target_properties(devo_evo_loopback PROPERTIES LIBRARY_OUTPUT_DIRECTORY ${CATKIN_DEVEL_PREFIX}/lib)
endif()
