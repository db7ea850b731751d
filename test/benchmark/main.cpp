// Benchmarks of whole lives, of experiments on threads, and of the kernel's parts. docs/benchmarks.md has the results;
// scripts/benchmark runs them and writes its tables.

#include "benchmark/experiment_benchmarks.h"
#include "benchmark/life_benchmarks.h"
#include "benchmark/part_benchmarks.h"
#include "devo_evo/experiment/build_info.h"

#include <benchmark/benchmark.h>

#include <cstring>
#include <exception>
#include <iostream>

namespace
{
void printHashes()
{
  devo_evo::printLifeHashes();
  devo_evo::printExperimentHashes();
}

void runBenchmarks()
{
  devo_evo::registerLifeBenchmarks();
  devo_evo::registerExperimentBenchmarks();
  devo_evo::registerPartBenchmarks();
  benchmark::AddCustomContext("devo_evo", devo_evo::versionText());
  benchmark::AddCustomContext("compiler", devo_evo::buildInfo().compiler);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
}  // namespace

/// Usage: devo_evo_benchmark [--print-hashes | --benchmark_...]
int main(int argc, char** argv)
{
  try
  {
    if (argc == 2 && std::strcmp(argv[1], "--print-hashes") == 0)
    {
      printHashes();
      return 0;
    }
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv))
    {
      return 2;
    }
    runBenchmarks();
    return 0;
  }
  catch (const std::exception& error)
  {
    std::cerr << "devo_evo_benchmark: " << error.what() << std::endl;
    return 1;
  }
}
