// SPDX-License-Identifier: MIT
#include "tests/support/share.h"

#include <cstdio>
#include <cstdlib>

namespace edgecase {
namespace {

// The finalizer of SplitMix64, a bijection: Steele, Lea, Flood, "Fast Splittable Pseudorandom
// Number Generators", 2014.
std::uint64_t mixed(std::uint64_t word) {
  word += 0x9e3779b97f4a7c15u;
  word = (word ^ (word >> 30)) * 0xbf58476d1ce4e5b9u;
  word = (word ^ (word >> 27)) * 0x94d049bb133111ebu;
  return word ^ (word >> 31);
}

Share share_of_environment() {
  const char* text = std::getenv("EDGECASE_SHARE");
  if (!text || !*text) return {};
  unsigned long number = 0, count = 0;
  char rest = 0;
  if (std::sscanf(text, "%lu/%lu%c", &number, &count, &rest) != 2 || number < 1 || number > count) {
    std::fprintf(stderr, "EDGECASE_SHARE is '%s'; it has to be I/N with 1 <= I <= N, as in 1/8\n",
                 text);
    std::exit(2);
  }
  std::printf("share %lu of %lu; to ask it again: EDGECASE_SHARE=%lu/%lu\n", number, count, number,
              count);
  return {number - 1, count};
}

}  // namespace

const Share& share() {
  static const Share of_process = share_of_environment();
  return of_process;
}

std::uint64_t share_seed(std::uint64_t seed) {
  return share().number == 0 ? seed : mixed(seed ^ mixed(share().number));
}

bool is_in_share(std::uint64_t item) {
  return share().count == 1 || mixed(item) % share().count == share().number;
}

int kernel_scene_factor() {
  const char* text = std::getenv("EDGECASE_KERNEL_SCENES");
  return std::max(1, text ? std::atoi(text) : 1);
}

int kernel_scenes(int count) {
  return share_of(count * kernel_scene_factor());
}

}  // namespace edgecase
