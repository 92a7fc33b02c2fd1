// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <benchmark/benchmark.h>
#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/problems.hpp"

/// Times and memory of some cases beside each other, in one run, as a Markdown table.
namespace ffcontact::bench {

/// Prepares a case on example 1 of [CHH01] with 2 n x n squares and returns what is
/// measured.
using Case = std::function<std::function<void()>(int n)>;

struct NamedCase {
  std::string name;
  Case prepare;
};

inline int dof_count(int n) { return 2 * (2 * n + 1) * (n + 1); }

/// The problem of each size, made once.
inline const test::Problem& problem(int n) {
  static std::map<int, test::Problem> problems;
  const auto found = problems.find(n);
  return found != problems.end()
             ? found->second
             : problems.emplace(n, test::example_1(Multiplier::force, n))
                   .first->second;
}

inline const ElasticSystem& elastic_system_of(int n) {
  static std::map<int, ElasticSystem> systems;
  const auto found = systems.find(n);
  return found != systems.end()
             ? found->second
             : systems.emplace(n, problem(n).system()).first->second;
}

/// A line of /proc/self/status [MB].
inline double own_memory(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.rfind(name + ":", 0) == 0)
      return std::stod(line.substr(name.size() + 1)) / 1024;
  return 0;
}

/// Peak memory of a case on top of what the process held before [MB]. Right only once in
/// a process.
inline double peak_memory(const Case& prepare, int n) {
  const std::function<void()> run = prepare(n);
  std::ofstream("/proc/self/clear_refs") << 5;  // the peak starts anew
  const double before = own_memory("VmRSS");
  run();
  return own_memory("VmHWM") - before;
}

/// Keeps the shortest time of every case and size; the console output goes to the error
/// stream.
class ShortestTimes : public benchmark::ConsoleReporter {
 public:
  ShortestTimes() {
    SetOutputStream(&std::cerr);
    SetErrorStream(&std::cerr);
  }
  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
      const auto key = std::make_pair(std::stoi(run.run_name.args),
                                      run.run_name.function_name);
      const double seconds =
          run.real_accumulated_time / static_cast<double>(run.iterations);
      const auto [place, is_new] = shortest.emplace(key, seconds);
      if (!is_new) place->second = std::min(place->second, seconds);
    }
  }
  std::map<std::pair<int, std::string>, double> shortest;
};

/// Nothing where the linear solve was not run.
inline std::string ratio(double own, double first) {
  if (first == 0) return "";
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", own / first);
  return text;
}

inline void print_table(const ShortestTimes& times,
                        const std::vector<NamedCase>& cases,
                        const std::vector<int>& sizes,
                        const std::function<int(int)>& dofs,
                        const std::function<double(std::size_t, int)>& memory) {
  std::printf(
      "| dofs | problem | seconds | / linear solve | peak memory [MB] | / "
      "linear solve "
      "|\n|---|---|---|---|---|---|\n");
  for (int n : sizes) {
    double first_seconds = 0, first_memory = 0;
    for (std::size_t k = 0; k < cases.size(); ++k) {
      const auto seconds = times.shortest.find({n, cases[k].name});
      if (seconds == times.shortest.end()) continue;
      const double megabytes = memory(k, n);
      if (k == 0) {
        first_seconds = seconds->second;
        first_memory = megabytes;
      }
      std::printf("| %d | %s | %.3f | %s | %.0f | %s |\n", dofs(n),
                  cases[k].name.c_str(), seconds->second,
                  ratio(seconds->second, first_seconds).c_str(), megabytes,
                  ratio(megabytes, first_memory).c_str());
    }
  }
}

/// Memory that is freed stays with the process. The first touch of a page takes from 1 to 5
/// microseconds on a virtual machine, as its host has the page at hand or not: without
/// this it is measured again in every run of a large case.
inline void keep_memory() {
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, -1);
}

/// Runs all cases in random order, five times each, and prints the table of their
/// shortest times. Each case's memory is that of a process of its own: this program,
/// called as `PROGRAM --peak CASE SIZE`.
/// @param cases  the first is the linear solve
/// @param dofs   of a size
inline int compare(int argc, char** argv, const std::vector<NamedCase>& cases,
                   const std::vector<int>& sizes,
                   const std::function<int(int)>& dofs = dof_count) {
  if (argc == 4 && std::string(argv[1]) == "--peak") {
    std::printf("%g\n", peak_memory(cases.at(std::stoul(argv[2])).prepare,
                                    std::stoi(argv[3])));
    return 0;
  }
  std::vector<std::string> arguments(argv, argv + argc);
  arguments.insert(arguments.begin() + 1,
                   {"--benchmark_enable_random_interleaving=true",
                    "--benchmark_repetitions=5"});
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  int count = static_cast<int>(pointers.size());
  benchmark::Initialize(&count, pointers.data());
  if (benchmark::ReportUnrecognizedArguments(count, pointers.data())) return 1;

  for (const NamedCase& named : cases)
    for (int n : sizes)
      benchmark::RegisterBenchmark(
          named.name.c_str(),
          [&named](benchmark::State& state) {
            const std::function<void()> run =
                named.prepare(static_cast<int>(state.range(0)));
            for (auto _ : state) run();
          })
          ->Arg(n)
          ->Iterations(1)
          ->UseRealTime()
          ->Unit(benchmark::kSecond);
  keep_memory();
  ShortestTimes times;
  benchmark::RunSpecifiedBenchmarks(&times);

  char program[4096] = {};
  if (readlink("/proc/self/exe", program, sizeof program - 1) < 0) return 1;
  print_table(times, cases, sizes, dofs, [&program](std::size_t k, int n) {
    std::ostringstream command;
    command << '\'' << program << "' --peak " << k << ' ' << n;
    double megabytes = 0;
    FILE* answer = popen(command.str().c_str(), "r");
    if (!answer || std::fscanf(answer, "%lf", &megabytes) != 1)
      throw std::runtime_error("no answer from " + command.str());
    pclose(answer);
    return megabytes;
  });
  return 0;
}

}  // namespace ffcontact::bench
