# All tests run under one ctest. What they need is built by two targets: cmake --build build --target all tests.
enable_testing()
if(NOT TARGET tests) # catkin has made it already
  add_custom_target(tests)
endif()

# ---- unit tests: one executable per file of test/<module>/test_*.cpp ---------------------------------------------
find_package(GTest REQUIRED)
include(GoogleTest)

file(GLOB unit_tests CONFIGURE_DEPENDS test/soft_body/test_*.cpp test/rigid_body/test_*.cpp test/evolution/test_*.cpp
  test/bodies/test_*.cpp
  test/archive/test_*.cpp test/farm/test_*.cpp test/experiment/test_*.cpp test/study/test_*.cpp test/render/test_*.cpp
  test/verification/test_*.cpp test/interchange/test_*.cpp test/explanation/test_*.cpp test/picture/test_*.cpp
  test/cli/test_*.cpp)
foreach(source ${unit_tests})
  get_filename_component(name ${source} NAME_WE)
  add_executable(${name} EXCLUDE_FROM_ALL ${source})
  target_include_directories(${name} PRIVATE src test)
  target_compile_definitions(${name} PRIVATE
    TEST_DATA_DIR="${CMAKE_CURRENT_SOURCE_DIR}/test/data"
    PROJECT_DIR="${CMAKE_CURRENT_SOURCE_DIR}"
    DEVO_EVO_TOOL="$<TARGET_FILE:devo_evo_cli>")
  target_link_libraries(${name} PRIVATE devo_evo_core GTest::gtest GTest::gtest_main nlohmann_json::nlohmann_json
    SQLiteCpp SQLite::SQLite3 OpenSSL::Crypto ${ODE_LIBRARY})
  if(source MATCHES "/test/picture/")
    target_link_libraries(${name} PRIVATE devo_evo_picture)
  endif()
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/test)
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT 600)
  add_dependencies(tests ${name})
endforeach()

# ---- tests of the repository itself ------------------------------------------------------------------------------
find_program(PYTHON3 python3 PATHS /usr/bin NO_DEFAULT_PATH)
file(GLOB repository_tests CONFIGURE_DEPENDS test/repository/test_*.py)
if(NOT DEVO_EVO_ROS)
  list(FILTER repository_tests EXCLUDE REGEX test_run.py)
endif()
if(PYTHON3)
  foreach(source ${repository_tests})
    get_filename_component(name ${source} NAME_WE)
    string(REPLACE test_ repository. name ${name})
    add_test(NAME ${name} COMMAND ${PYTHON3} ${source})
    set_tests_properties(${name} PROPERTIES TIMEOUT 600
      ENVIRONMENT "BUILD_DIR=${CMAKE_BINARY_DIR};DEVO_EVO_TOOL=$<TARGET_FILE:devo_evo_cli>")
  endforeach()
endif()

# ---- the Python module -------------------------------------------------------------------------------------------
file(GLOB analysis_tests CONFIGURE_DEPENDS test/analysis/test_*.py)
if(PYTHON3)
  foreach(source ${analysis_tests})
    get_filename_component(name ${source} NAME_WE)
    string(REPLACE test_ analysis. name ${name})
    add_test(NAME ${name} COMMAND ${PYTHON3} -W error::RuntimeWarning ${source})
    set_tests_properties(${name} PROPERTIES TIMEOUT 600
      ENVIRONMENT "PYTHONPATH=${CMAKE_CURRENT_SOURCE_DIR}/src;DEVO_EVO_TOOL=$<TARGET_FILE:devo_evo_cli>")
  endforeach()
  # Simulates on all cores: alone, and first, so that nothing waits for it at the end.
  cmake_host_system_information(RESULT cores QUERY NUMBER_OF_LOGICAL_CORES)
  set_tests_properties(analysis.quick PROPERTIES TIMEOUT 1800 COST 1000 PROCESSORS ${cores})
endif()

find_program(CLANG_FORMAT clang-format-14)
if(CLANG_FORMAT) # not in packages.txt: large, and of use to developers only
  file(GLOB_RECURSE formatted CONFIGURE_DEPENDS include/*.h src/*.h src/*.cpp test/*.h test/*.cpp)
  add_test(NAME repository.clang_format COMMAND ${CLANG_FORMAT} --dry-run -Werror ${formatted})
endif()

# ---- with ROS ----------------------------------------------------------------------------------------------------
if(DEVO_EVO_ROS)
  # Programs with sanitizers are too slow for tests in real time that share the machine.
  set(slowed OFF)
  if(DEVO_EVO_SANITIZE)
    set(slowed ON)
  endif()
  add_test(NAME repository.catkin_lint COMMAND catkin_lint --offline --strict ${CMAKE_CURRENT_SOURCE_DIR})
  add_subdirectory(test/rostest EXCLUDE_FROM_ALL)

  # Farms that things happen to, with ROS masters and, where the machine allows it, networks of their own.
  if(PYTHON3)
    add_test(NAME chaos.hosts COMMAND ${PYTHON3} test/chaos/hosts_test.py)
    add_test(NAME chaos.master COMMAND ${PYTHON3} test/chaos/master_test.py)
    add_test(NAME chaos.short COMMAND ${PYTHON3} scripts/chaos --seconds 0 --build ${CMAKE_BINARY_DIR})
    set_tests_properties(chaos.hosts chaos.master chaos.short PROPERTIES TIMEOUT 600 SKIP_RETURN_CODE 77
      WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} ENVIRONMENT "BUILD_DIR=${CMAKE_BINARY_DIR}"
      RUN_SERIAL "${slowed}")
  endif()
endif()
