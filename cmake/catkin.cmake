# What catkin wants declared before any target: the packages used, our messages, and what others may use of ours.

# Where another python3 stands first on PATH, catkin would configure with one that lacks its modules.
foreach(variable PYTHON_EXECUTABLE Python3_EXECUTABLE)
  if(NOT DEFINED ${variable})
    set(${variable} /usr/bin/python3 CACHE FILEPATH "The Python that ROS is installed for")
  endif()
endforeach()
# Outside of a workspace, catkin caches the environment of its first configure, in which this folder must exist already.
if(NOT CATKIN_DEVEL_PREFIX)
  file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/devel/lib/python3/dist-packages)
endif()

# catkin installs its set-up files and the Python module to the prefix that was configured, whatever cmake --install is told.
install(CODE "
  if(NOT CMAKE_INSTALL_PREFIX STREQUAL [==[${CMAKE_INSTALL_PREFIX}]==])
    message(FATAL_ERROR \"This build installs to ${CMAKE_INSTALL_PREFIX} only: configure it with \"
      \"-DCMAKE_INSTALL_PREFIX=\${CMAKE_INSTALL_PREFIX}, or set DESTDIR.\")
  endif()")

find_package(catkin REQUIRED COMPONENTS
  diagnostic_msgs geometry_msgs message_generation rosbag_storage roscpp sensor_msgs std_msgs std_srvs tf2_msgs
  tf2_ros topic_tools visualization_msgs)

catkin_python_setup()
add_message_files(DIRECTORY msg)
add_service_files(DIRECTORY srv)
generate_messages(DEPENDENCIES std_msgs)

# Whoever links our static library from elsewhere needs what it links.
find_library(SQLITECPP_LIBRARIES SQLiteCpp REQUIRED)
catkin_package(
  INCLUDE_DIRS include
  LIBRARIES ${PROJECT_NAME}_core
  CATKIN_DEPENDS diagnostic_msgs geometry_msgs message_runtime rosbag_storage roscpp sensor_msgs std_msgs std_srvs
    tf2_msgs tf2_ros topic_tools visualization_msgs
  DEPENDS EIGEN3 OPENSSL SQLITECPP SQLite3 YAML_CPP)
