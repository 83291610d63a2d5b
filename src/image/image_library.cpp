// SPDX-License-Identifier: MIT
#include "image/image_library.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <filesystem>

#include "image/image_io.h"

namespace edgecase {

void* find_image_function(const char* symbol, std::string& error) {
  std::error_code code;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", code);
  const auto path = program.parent_path() / kImageLibrary;
  void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  // An installed program, and one linked with the installed libraries, say by their run path where
  // it lies. What lies beside the program and cannot be opened is an error, and not passed over.
  if (library == nullptr && !std::filesystem::exists(path, code))
    library = dlopen(kImageLibrary, RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    error = fmt::format("cannot open the image library {}: {}; install libopenimageio2.4",
                        path.string(), dlerror());
    return nullptr;
  }
  void* function = dlsym(library, symbol);
  if (function == nullptr) error = fmt::format("{} lacks {}", path.string(), symbol);
  return function;
}

}  // namespace edgecase
