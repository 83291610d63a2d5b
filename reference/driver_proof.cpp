// SPDX-License-Identifier: MIT
#include "reference/driver_proof.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace edgecase {

namespace {

struct Driver {
  const char* name;         // on the worker's command line
  const char* gl_renderer;  // the start of GL_RENDERER
  const char* device;       // what GL_RENDERER also contains: the Vulkan device; empty: nothing
  const char* library;      // the Vulkan driver that must be executable; empty: none
  const char* package;      // the Debian package with the library
  const char* stack;
};

// zink's GL_RENDERER names the Vulkan device in brackets: "zink (llvmpipe (...))" in Mesa 22.3,
// "zink Vulkan 1.4(llvmpipe (...) (...))" in Mesa 25.0. lavapipe's device is called llvmpipe.
constexpr Driver kDrivers[] = {
    {"llvmpipe", "llvmpipe", "", "", "", ""},
    {"softpipe", "softpipe", "", "", "", ""},
    {"zink", "zink", "(llvmpipe", "libvulkan_lvp.so", "mesa-vulkan-drivers", "zink over lavapipe"},
    {"zink-swiftshader", "zink", "(SwiftShader", "libvk_swiftshader.so", "chromium",
     "unofficial: zink over the SwiftShader of Debian's chromium, which lacks what zink requires, "
     "and versions of OpenGL overridden"},
};

const Driver* find_driver(const std::string& name) {
  const auto* found = std::find_if(std::begin(kDrivers), std::end(kDrivers),
                                   [&](const Driver& driver) { return name == driver.name; });
  return found == std::end(kDrivers) ? nullptr : found;
}

// A line of /proc/self/maps: addresses, permissions, offset, device, inode, path.
bool can_execute(const std::string& library) {
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);) {
    const std::size_t permissions = line.find(' ') + 1;
    if (line.substr(permissions, 4).find('x') != std::string::npos &&
        line.find("/" + library) != std::string::npos)
      return true;
  }
  return false;
}

}  // namespace

std::string missing_for_driver(const std::string& driver) {
  const Driver* known = find_driver(driver);
  if (known == nullptr || *known->library == '\0') return "";
  const char* description = std::getenv("VK_ICD_FILENAMES");
  if (description == nullptr) return "VK_ICD_FILENAMES names no Vulkan driver for " + driver;
  std::error_code ignored;
  if (std::filesystem::is_regular_file(description, ignored)) return "";
  return fmt::format(
      "the Vulkan driver {} cannot be opened: there is no such file; Debian has it in the "
      "package {}",
      description, known->package);
}

std::string doubt_of_driver(const std::string& driver, const std::string& gl_renderer) {
  const Driver* known = find_driver(driver);
  const bool is_requested = known == nullptr
                                ? gl_renderer.starts_with(driver)
                                : gl_renderer.starts_with(known->gl_renderer) &&
                                      gl_renderer.find(known->device) != std::string::npos;
  if (!is_requested) return fmt::format("the driver is '{}', not {}", gl_renderer, driver);
  if (known != nullptr && *known->library != '\0' && !can_execute(known->library))
    return fmt::format("the driver is '{}', but {} is not what this process executes", gl_renderer,
                       known->library);
  return "";
}

std::string stack_of_driver(const std::string& driver) {
  const Driver* known = find_driver(driver);
  return known == nullptr ? "" : known->stack;
}

}  // namespace edgecase
