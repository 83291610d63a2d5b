// SPDX-License-Identifier: MIT
//
// Bytes as a regular file in memory, for readers that open files themselves.
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <string>
#include <string_view>

#include "tests/fuzz/target.h"

namespace edgecase {

class ByteFile {
 public:
  explicit ByteFile(std::string_view bytes) : descriptor_(memfd_create("input", 0)) {
    promise(descriptor_ >= 0, "there are files in memory");
    while (!bytes.empty()) {
      const ssize_t written = write(descriptor_, bytes.data(), bytes.size());
      promise(written > 0, "there is room for the input");
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
  }
  ByteFile(const ByteFile&) = delete;
  ByteFile& operator=(const ByteFile&) = delete;
  ~ByteFile() { close(descriptor_); }

  std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_;
};

}  // namespace edgecase
