// SPDX-License-Identifier: MIT
//
// The bytes of a fuzz target's input as decisions: what a structured input is made of.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace edgecase {

class ByteChoices {
 public:
  explicit ByteChoices(std::span<const std::uint8_t> bytes) : left_(bytes) {}

  bool empty() const { return left_.empty(); }
  // 0 once all bytes are used.
  std::uint8_t byte() {
    if (left_.empty()) return 0;
    const std::uint8_t first = left_.front();
    left_ = left_.subspan(1);
    return first;
  }
  // 0 to count - 1, by as many bytes as `count` needs, at most four; `count` is at least 1.
  std::size_t below(std::size_t count) {
    std::size_t number = 0;
    for (std::size_t most = 1; most < count && most < std::size_t{1} << 32; most <<= 8)
      number = number << 8 | byte();
    return number % count;
  }
  bool flag() { return (byte() & 1) != 0; }
  template <class List>
  const auto& one_of(const List& list) {
    return list[below(std::size(list))];
  }

 private:
  std::span<const std::uint8_t> left_;
};

}  // namespace edgecase
