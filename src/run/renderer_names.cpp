// SPDX-License-Identifier: MIT
#include "run/renderer_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string_view>

namespace edgecase {

namespace {

using Environment = std::map<std::string, std::string>;

constexpr std::string_view kExecPrefix = "exec:";
constexpr std::string_view kDevicePrefix = "egl:device";

// Variables that would turn one Mesa driver into another behind our back.
const std::vector<std::string> kDriverVariables = {
    "GALLIUM_DRIVER",           "LIBGL_ALWAYS_SOFTWARE",      "MESA_LOADER_DRIVER_OVERRIDE",
    "MESA_GL_VERSION_OVERRIDE", "MESA_GLSL_VERSION_OVERRIDE", "MESA_EXTENSION_OVERRIDE"};

Environment mesa_environment(const std::string& driver, bool egl) {
  // Without threads llvmpipe draws small scenes several times faster, and always in order.
  Environment result{{"GALLIUM_DRIVER", driver}, {"LP_NUM_THREADS", "0"}};
  if (egl) result.emplace("LIBGL_ALWAYS_SOFTWARE", "1");
  if (driver == "softpipe") {
    // It has shader storage blocks, but claims OpenGL 3.3, which has none.
    result.emplace("MESA_GL_VERSION_OVERRIDE", "4.5");
    result.emplace("MESA_GLSL_VERSION_OVERRIDE", "450");
  }
  return result;
}

Command mesa_command(const std::string& worker, bool egl, const std::string& driver) {
  return {{worker, egl ? "egl-surfaceless" : "osmesa", "--expect-driver", driver},
          mesa_environment(driver, egl),
          kDriverVariables};
}

// A device shows what the system offers: the environment is the user's.
Command device_command(const std::string& worker, const std::string& number) {
  return {{worker, "egl-device:" + number}, {{"LP_NUM_THREADS", "0"}}, {}};
}

// The words of a command line; nothing when a quote is not closed.
std::optional<std::vector<std::string>> split_words(std::string_view text) {
  std::vector<std::string> words;
  bool in_word = false;
  char quote = 0;
  for (char c : text) {
    if (quote == 0 && c == ' ') {
      in_word = false;
      continue;
    }
    if (!in_word) words.emplace_back();
    in_word = true;
    if (quote == 0 && (c == '"' || c == '\'')) {
      quote = c;
    } else if (c == quote) {
      quote = 0;
    } else {
      words.back() += c;
    }
  }
  if (quote != 0) return std::nullopt;
  return words;
}

bool is_file(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(path, ignored);
}

std::variant<ProcessSpec, UnknownRenderer> exec_renderer(const std::string& name) {
  const std::string text = name.substr(kExecPrefix.size());
  const auto words = is_file(text) ? std::vector<std::string>{text} : split_words(text);
  if (!words) return UnknownRenderer{fmt::format("'{}' has a quote that is not closed", name)};
  if (words->empty())
    return UnknownRenderer{"exec: names no program; write exec:PROGRAM or exec:'PROGRAM ARGUMENT'"};
  ProcessSpec spec;
  spec.name = name;
  spec.command.argv = *words;
  std::string& program = spec.command.argv.front();
  if (program.find('/') == std::string::npos && is_file(program)) program = "./" + program;
  return spec;
}

bool is_number(std::string_view text) {
  return !text.empty() && text.size() <= 3 &&
         std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace

const std::vector<std::string>& opengl_renderer_names() {
  static const std::vector<std::string> names = {"osmesa:llvmpipe", "osmesa:softpipe",
                                                 "egl:llvmpipe", "egl:softpipe", "egl:device0"};
  return names;
}

std::string known_renderer_names() {
  return "exact, osmesa:llvmpipe, osmesa:softpipe, egl:llvmpipe, egl:softpipe, egl:deviceN, "
         "exec:PROGRAM";
}

std::variant<ProcessSpec, UnknownRenderer> find_renderer(const std::string& name,
                                                         const std::string& program_directory) {
  if (name.starts_with(kExecPrefix)) return exec_renderer(name);
  const std::string worker = (std::filesystem::path(program_directory) / "edgecase-gl").string();
  ProcessSpec spec;
  spec.name = name;
  if (name.starts_with(kDevicePrefix) && is_number(name.substr(kDevicePrefix.size()))) {
    spec.command = device_command(worker, name.substr(kDevicePrefix.size()));
    return spec;
  }
  for (const char* driver : {"llvmpipe", "softpipe"}) {
    for (bool egl : {false, true}) {
      if (name != fmt::format("{}:{}", egl ? "egl" : "osmesa", driver)) continue;
      spec.command = mesa_command(worker, egl, driver);
      return spec;
    }
  }
  return UnknownRenderer{
      fmt::format("there is no renderer '{}'; known are {}", name, known_renderer_names())};
}

std::string executable_directory() {
  std::error_code error;
  const auto path = std::filesystem::read_symlink("/proc/self/exe", error);
  return error ? "." : path.parent_path().string();
}

}  // namespace edgecase
