// SPDX-License-Identifier: MIT
//
// Which mutants does a test program reach? With EDGECASE_MUTANT=-1 each one that is asked for is
// noted, and the numbers are written to the file EDGECASE_MUTANTS_REACHED at exit, one per line.
// tools/mutate links this into each test program that it builds.
#include <cstddef>
#include <cstdlib>
#include <fstream>

#include "tests/mutation/switches.h"

namespace edgecase_mutation {
namespace {

constexpr std::size_t kMaxMutants = 1u << 20;
unsigned char bytes[kMaxMutants];

void write_reached() {
  std::ofstream file(std::getenv("EDGECASE_MUTANTS_REACHED"));
  for (std::size_t number = 0; number < kMaxMutants; ++number)
    if (bytes[number] != 0) file << number << '\n';
}

}  // namespace

unsigned char* reached_of_environment() {
  std::atexit(write_reached);
  return bytes;
}

}  // namespace edgecase_mutation
