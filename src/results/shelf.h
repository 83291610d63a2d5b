// SPDX-License-Identifier: MIT
//
// Keeps bytes that are seldom needed, packed, in a file without a name, so that memory does not
// grow with them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

namespace edgecase {

// The file has no room, or cannot be read. The message names the folder and the remedy.
struct ShelfError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Safe to use from several threads. The first megabyte stays in memory; the rest goes to a file in
// the folder that TMPDIR names, or /tmp, which disappears with the shelf.
class Shelf {
 public:
  struct Place {
    std::uint64_t begin = 0;     // of the packed bytes
    std::uint32_t packed = 0;    // their number
    std::uint32_t unpacked = 0;  // what they are unpacked
  };

  Shelf();
  ~Shelf();

  // Throws a ShelfError where they cannot be written, and std::runtime_error where they are 2 GiB
  // or more.
  Place put(std::string_view bytes);
  // The same for bytes that were perhaps put a moment ago: then their place is that of before.
  Place put_repeated(const std::string& bytes);
  // The stored bytes. Throws a ShelfError if they cannot be read.
  std::string at(const Place& place) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace edgecase
