// SPDX-License-Identifier: MIT
#include "reference/shared_library.h"

#include <dlfcn.h>

namespace edgecase {

SharedLibrary::SharedLibrary(std::initializer_list<const char*> names) {
  for (const char* name : names) {
    handle_ = dlopen(name, RTLD_NOW | RTLD_LOCAL);
    if (handle_ != nullptr) return;
    const char* message = dlerror();
    error_ = message != nullptr ? message : name;
  }
}

void* SharedLibrary::symbol(const char* name) const {
  return dlsym(handle_, name);
}

}  // namespace edgecase
