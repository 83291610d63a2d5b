// SPDX-License-Identifier: MIT
#include "tools/edgecase/default_suite.h"

#include <system_error>

namespace edgecase {

namespace fs = std::filesystem;

fs::path installed_suite() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (error) return {};
  const fs::path suite = (program.parent_path() / EDGECASE_SUITE_FROM_PROGRAM).lexically_normal();
  return fs::is_directory(suite, error) ? suite : fs::path();
}

std::string default_suite() {
  constexpr const char* kHere = "cases";
  std::error_code error;
  if (fs::is_directory(kHere, error)) return kHere;
  const fs::path installed = installed_suite();
  return installed.empty() ? kHere : installed.string();
}

}  // namespace edgecase
