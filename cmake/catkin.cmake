# What catkin wants declared before any target: the packages used, our messages, and what others may use of ours.

# Where another python3 stands first on PATH, catkin would configure with one that lacks its modules.
foreach(variable PYTHON_EXECUTABLE Python3_EXECUTABLE)
  if(NOT DEFINED ${variable})
    set(${variable} /usr/bin/python3 CACHE FILEPATH "The Python that ROS is installed for")
  endif()
endforeach()
# Catkin caches the environment of its first configure, in which this folder must exist already.
file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/devel/lib/python3/dist-packages)

find_package(catkin REQUIRED COMPONENTS
  roscpp message_generation std_msgs std_srvs diagnostic_msgs)

add_message_files(DIRECTORY msg)
add_service_files(DIRECTORY srv)
generate_messages(DEPENDENCIES std_msgs)

catkin_package(
  INCLUDE_DIRS include
  LIBRARIES devo_evo_core
  CATKIN_DEPENDS roscpp message_runtime std_msgs std_srvs diagnostic_msgs)
