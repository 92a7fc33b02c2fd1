// SPDX-License-Identifier: GPL-3.0-or-later
// fuzz: random problems for some seconds, plane or solid ones, or those that are in files.
#include <omp.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <sstream>

#include "generator.hpp"
#include "solid_checks.hpp"
#include "trial.hpp"

namespace ffcontact::fuzz {
namespace {

struct Options {
  double seconds = 30;
  std::uint64_t seed = 0, first = 0,
                problems = std::numeric_limits<std::uint64_t>::max();
  std::string finds = "finds";  ///< folder
  std::vector<std::string> files;
  bool solids = false;
};

constexpr int files_per_cause = 3;
constexpr const char* solid_file = "ffcontact-fuzz-solid-1";

/// A problem, what became of it, and the file that replays it.
struct Tried {
  std::string kind, size;
  Outcome outcome;
  /// @param shrink  as much as keeps the find
  std::function<std::string(const Find&, bool shrink)> text;
};

Tried tried(const Case& problem) {
  return {kind(problem), std::to_string(problem.cell_count()) + " triangles",
          outcome_of(problem), [problem](const Find& found, bool shrink) {
            return text_of(shrink ? shrunk(problem, found) : problem);
          }};
}

/// A solid is drawn again: its file has its numbers alone.
Tried tried_solid(std::uint64_t seed, std::uint64_t index) {
  Tried result;
  result.text = [=](const Find&, bool) {
    return std::string(solid_file) + " " + std::to_string(seed) + " " +
           std::to_string(index) + "\n";
  };
  try {
    const SolidCase problem = random_solid(seed, index);
    result.kind = problem.kind;
    result.size = std::to_string(problem.mesh.cell_count()) + " tetrahedra";
    result.outcome = outcome_of(problem);
  } catch (const std::exception& thrown) {
    result.kind = "solid that is not stated";
    result.outcome.answer = without_numbers(thrown.what());
    result.outcome.finds.push_back({"stated", thrown.what()});
  }
  return result;
}

/// Counts of what was tried and found; finds of one cause have the same name and sentence
/// but for its numbers.
class Tally {
 public:
  explicit Tally(std::string folder) : folder_(std::move(folder)) {}

  void add(const Tried& tried, const std::string& name) {
    ++kinds_[tried.kind];
    ++answers_[tried.outcome.answer];
    ++(tried.outcome.finds.empty() ? passed_ : failed_);
    std::map<std::string, const Find*> causes;
    for (const Find& found : tried.outcome.finds)
      causes.emplace(found.check + ": " + without_numbers(found.detail),
                     &found);
    for (const auto& [cause, found] : causes) {
      if (causes_[cause]++ >= files_per_cause) continue;
      std::cout << "find " << name << " (" << tried.kind << ", " << tried.size
                << ") " << found->check << ": " << found->detail << std::endl;
      if (!folder_.empty()) keep(tried, *found, name, causes_[cause] == 1);
    }
  }

  int report() const {
    print("problems", kinds_);
    print("answers", answers_);
    print("finds", causes_);
    std::cout << passed_ << " passed, " << failed_ << " failed" << std::endl;
    return failed_ == 0 ? 0 : 1;
  }

 private:
  void keep(const Tried& tried, const Find& found, const std::string& name,
            bool shrink) const {
    std::filesystem::create_directories(folder_);
    const std::string path = folder_ + "/" + found.check + "-" + name + ".txt";
    std::ofstream(path) << tried.text(found, shrink);
    std::cout << "  kept in " << path << std::endl;
  }
  static void print(const char* title,
                    const std::map<std::string, int>& counts) {
    if (!counts.empty()) std::cout << title << '\n';
    for (const auto& [name, count] : counts)
      std::printf("%9d  %s\n", count, name.c_str());
    std::fflush(stdout);
  }

  std::string folder_;
  std::map<std::string, int> kinds_, answers_, causes_;
  int passed_ = 0, failed_ = 0;
};

Tried tried_file(const std::string& text) {
  std::istringstream words(text);
  std::string format;
  std::uint64_t seed = 0, index = 0;
  words >> format >> seed >> index;
  return format == solid_file ? tried_solid(seed, index) : tried(case_of(text));
}

int replay(const Options& options) {
  Tally tally("");
  for (const std::string& path : options.files) {
    std::ifstream file(path);
    std::stringstream text;
    text << file.rdbuf();
    tally.add(tried_file(text.str()), path);
  }
  return tally.report();
}

int explore(const Options& options) {
  Tally tally(options.finds);
  std::cout << "seed " << options.seed << std::endl;
  const auto start = std::chrono::steady_clock::now();
  const auto elapsed = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() -
                                         start)
        .count();
  };
  for (std::uint64_t k = 0; k < options.problems && elapsed() < options.seconds;
       ++k) {
    const std::uint64_t index = options.first + k;
    tally.add(options.solids ? tried_solid(options.seed, index)
                             : tried(random_case(options.seed, index)),
              std::to_string(options.seed) + "-" + std::to_string(index));
  }
  return tally.report();
}

Options options_of(int count, char** words) {
  Options options;
  for (int k = 1; k < count; ++k) {
    const std::string word = words[k];
    const bool has_value = k + 1 < count;
    if (word == "--solids")
      options.solids = true;
    else if (word == "--seconds" && has_value)
      options.seconds = std::atof(words[++k]);
    else if (word == "--seed" && has_value)
      options.seed = std::strtoull(words[++k], nullptr, 10);
    else if (word == "--first" && has_value)
      options.first = std::strtoull(words[++k], nullptr, 10);
    else if (word == "--problems" && has_value)
      options.problems = std::strtoull(words[++k], nullptr, 10);
    else if (word == "--finds" && has_value)
      options.finds = words[++k];
    else
      options.files.push_back(word);
  }
  if (options.seed == 0)
    options.seed = std::chrono::system_clock::now().time_since_epoch() /
                   std::chrono::seconds(1);
  return options;
}

}  // namespace
}  // namespace ffcontact::fuzz

int main(int count, char** words) {
  omp_set_num_threads(1);  // the problems are small
  const ffcontact::fuzz::Options options =
      ffcontact::fuzz::options_of(count, words);
  return options.files.empty() ? ffcontact::fuzz::explore(options)
                               : ffcontact::fuzz::replay(options);
}
