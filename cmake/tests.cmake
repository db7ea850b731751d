# Unit tests by GoogleTest, one executable per file of test/<module>/test_*.cpp; rostests by test/rostest/CMakeLists.txt.
find_package(GTest REQUIRED)
include(GoogleTest)
enable_testing()

file(GLOB unit_tests CONFIGURE_DEPENDS test/soft_body/test_*.cpp test/evolution/test_*.cpp test/archive/test_*.cpp
  test/farm/test_*.cpp test/experiment/test_*.cpp test/cli/test_*.cpp)
foreach(source ${unit_tests})
  get_filename_component(name ${source} NAME_WE)
  add_executable(${name} ${source})
  target_include_directories(${name} PRIVATE src test)
  target_compile_definitions(${name} PRIVATE
    TEST_DATA_DIR="${CMAKE_CURRENT_SOURCE_DIR}/test/data"
    PROJECT_DIR="${CMAKE_CURRENT_SOURCE_DIR}"
    DEVO_EVO_TOOL="$<TARGET_FILE:devo_evo_cli>")
  target_link_libraries(${name} PRIVATE devo_evo_core GTest::gtest GTest::gtest_main nlohmann_json::nlohmann_json
    SQLiteCpp SQLite::SQLite3 OpenSSL::Crypto)
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/test)
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT 600)
endforeach()

if(DEVO_EVO_ROS)
  add_subdirectory(test/rostest)
endif()
