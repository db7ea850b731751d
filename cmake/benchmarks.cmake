# Benchmarks: docs/benchmarks.md. scripts/benchmark builds and runs them.
find_package(benchmark REQUIRED)

add_executable(devo_evo_benchmark
  test/benchmark/counted_parts.cpp
  test/benchmark/experiment_benchmarks.cpp
  test/benchmark/fastest_slices.cpp
  test/benchmark/kernel_parts_avx2.cpp
  test/benchmark/kernel_parts_avx512.cpp
  test/benchmark/kernel_parts_scalar.cpp
  test/benchmark/kernel_parts_scalar_fma.cpp
  test/benchmark/known_results.cpp
  test/benchmark/life_benchmarks.cpp
  test/benchmark/life_scenes.cpp
  test/benchmark/living_batch.cpp
  test/benchmark/main.cpp
  test/benchmark/part_benchmarks.cpp)
target_link_libraries(devo_evo_benchmark PRIVATE devo_evo_core benchmark::benchmark nlohmann_json::nlohmann_json)

add_executable(devo_evo_archive_benchmark test/benchmark/archive_growth.cpp)
target_link_libraries(devo_evo_archive_benchmark PRIVATE devo_evo_core nlohmann_json::nlohmann_json)

foreach(target devo_evo_benchmark devo_evo_archive_benchmark)
  target_include_directories(${target} PRIVATE src test)
  target_compile_definitions(${target} PRIVATE
    BENCHMARK_DIR="${CMAKE_CURRENT_SOURCE_DIR}/test/benchmark"
    TEST_DATA_DIR="${CMAKE_CURRENT_SOURCE_DIR}/test/data")
  set_target_properties(${target} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/benchmark)
endforeach()

# The parts of a kernel are compiled as the kernel is.
foreach(kernel scalar scalar_fma avx2 avx512)
  get_source_file_property(options src/soft_body/kernel_${kernel}.cpp COMPILE_OPTIONS)
  if(options)
    set_source_files_properties(test/benchmark/kernel_parts_${kernel}.cpp PROPERTIES COMPILE_OPTIONS "${options}")
  endif()
endforeach()
