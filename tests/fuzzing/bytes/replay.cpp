// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a target of libFuzzer on files, and on bytes drawn with each of some seeds: replay FILE... [--drawn N]
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "bytes/data.hpp"
#include "dice.hpp"

namespace {

void run(const std::vector<std::uint8_t>& bytes) {
  LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
}

std::vector<std::uint8_t> read(const char* path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    std::printf("there is no file %s\n", path);
    std::exit(1);
  }
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::uint8_t> drawn(std::uint64_t seed) {
  ffcontact::fuzz::Dice dice(seed, 0);
  std::vector<std::uint8_t> bytes(dice.integer(0, 200));
  for (std::uint8_t& byte : bytes)
    byte = static_cast<std::uint8_t>(dice.integer(0, 255));
  return bytes;
}

}  // namespace

int main(int count, char** words) {
  int files = 0, draws = 0;
  for (int k = 1; k < count; ++k)
    if (std::string(words[k]) == "--drawn" && k + 1 < count) {
      draws = std::atoi(words[++k]);
    } else {
      run(read(words[k]));
      ++files;
    }
  for (int seed = 0; seed < draws; ++seed) {
    if (std::getenv("FFCONTACT_SAY")) std::fprintf(stderr, "%d\n", seed);
    run(drawn(static_cast<std::uint64_t>(seed)));
  }
  std::printf("%d files and %d drawn inputs\n", files, draws);
}
