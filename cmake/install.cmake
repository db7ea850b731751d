# Installation: to the places of ROS with it, to those of any other package without.

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
if(NOT DEVO_EVO_ROS)
  #catkin_lint: skip
  set(CATKIN_PACKAGE_BIN_DESTINATION ${CMAKE_INSTALL_BINDIR})
  set(CATKIN_PACKAGE_LIB_DESTINATION ${CMAKE_INSTALL_LIBDIR})
  set(CATKIN_PACKAGE_INCLUDE_DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/${PROJECT_NAME})
  set(CATKIN_PACKAGE_SHARE_DESTINATION ${CMAKE_INSTALL_DATADIR}/${PROJECT_NAME})
endif()

install(TARGETS devo_evo_cli RUNTIME DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
install(TARGETS devo_evo_picture ARCHIVE DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION})
if(DEVO_EVO_ROS) # for rosrun above, for everybody else here
  install(TARGETS devo_evo_cli RUNTIME DESTINATION ${CATKIN_GLOBAL_BIN_DESTINATION})
endif()
if(TARGET devo_evo_manual)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/devo_evo.1 DESTINATION share/man/man1)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/devo_evo.bash
    DESTINATION share/bash-completion/completions RENAME devo_evo)
endif()

# The library, for find_package(devo_evo_core) of programs that know nothing of catkin.
set(core_config_dir ${CATKIN_PACKAGE_LIB_DESTINATION}/cmake/devo_evo_core)
install(TARGETS devo_evo_core EXPORT devo_evo_core
  ARCHIVE DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION}
  INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT devo_evo_core FILE devo_evo_core-targets.cmake NAMESPACE devo_evo:: DESTINATION ${core_config_dir})
configure_package_config_file(cmake/devo_evo_core-config.cmake.in devo_evo_core-config.cmake
  INSTALL_DESTINATION ${core_config_dir})
write_basic_package_version_file(devo_evo_core-config-version.cmake COMPATIBILITY SameMinorVersion)
#catkin_lint: ignore_once missing_file
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/devo_evo_core-config.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/devo_evo_core-config-version.cmake DESTINATION ${core_config_dir})

install(DIRECTORY include/${PROJECT_NAME}/ DESTINATION ${CATKIN_PACKAGE_INCLUDE_DESTINATION})
install(DIRECTORY config DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
if(NOT DEVO_EVO_ROS) # else catkin_python_setup installs it
  install(DIRECTORY src/${PROJECT_NAME} DESTINATION ${python_destination} FILES_MATCHING PATTERN "*.py")
endif()
install(FILES README.md LICENSE CITATION.cff DESTINATION share/doc/${PROJECT_NAME})
install(DIRECTORY docs DESTINATION share/doc/${PROJECT_NAME})
if(DEVO_EVO_ROS)
  install(TARGETS ${nodes} RUNTIME DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
  install(TARGETS devo_evo_rviz LIBRARY DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION})
  install(FILES plugin_description.xml DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
  install(DIRECTORY launch rviz DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION} USE_SOURCE_PERMISSIONS)
  install(PROGRAMS scripts/show_rviz DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
endif()
