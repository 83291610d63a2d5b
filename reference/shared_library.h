// SPDX-License-Identifier: MIT
//
// A shared library that is opened at run time, so that a missing one gives a message.
#pragma once

#include <initializer_list>
#include <string>

namespace edgecase {

class SharedLibrary {
 public:
  // Opens the first of `names` that can be opened. It stays open until the process ends: drivers
  // leave threads and exit handlers behind that outlive a context.
  explicit SharedLibrary(std::initializer_list<const char*> names);

  bool is_open() const { return handle_ != nullptr; }
  // The dynamic linker's message about the last name, if none could be opened.
  const std::string& error() const { return error_; }

  // Sets `function` to the symbol of this name; false, and null, if there is none.
  template <class Function>
  bool load(const char* name, Function*& function) const {
    function = reinterpret_cast<Function*>(symbol(name));
    return function != nullptr;
  }

 private:
  void* symbol(const char* name) const;

  void* handle_ = nullptr;
  std::string error_;
};

}  // namespace edgecase
