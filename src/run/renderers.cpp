// SPDX-License-Identifier: MIT
#include "run/renderers.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "casefile/json/text.h"
#include "processes/process_renderer.h"
#include "processes/shader_cache.h"
#include "raster/rasterizer.h"
#include "run/record.h"

namespace edgecase {
namespace {

using Environment = std::map<std::string, std::string>;

constexpr std::string_view kExecPrefix = "exec:";
constexpr std::string_view kOsmesaPrefix = "osmesa:";
constexpr std::string_view kEglPrefix = "egl:";
constexpr std::string_view kEsPrefix = "egl-es:";
constexpr std::string_view kWebPrefix = "webgl:";
constexpr std::string_view kDevice = "device";
constexpr std::string_view kNamedDevice = "device=";
constexpr std::string_view kLibrary = "lib=";

// How a worker comes by its context.
enum class FrontEnd { osmesa, egl, egl_es };

// Variables that would make Mesa use another driver.
const std::vector<std::string> kDriverVariables = {
    "GALLIUM_DRIVER",           "LIBGL_ALWAYS_SOFTWARE",      "MESA_LOADER_DRIVER_OVERRIDE",
    "MESA_GL_VERSION_OVERRIDE", "MESA_GLSL_VERSION_OVERRIDE", "MESA_GLES_VERSION_OVERRIDE",
    "MESA_EXTENSION_OVERRIDE"};

const char* surfaceless(FrontEnd front_end) {
  return front_end == FrontEnd::egl_es ? "egl-es-surfaceless" : "egl-surfaceless";
}

Environment mesa_environment(const std::string& driver, FrontEnd front_end) {
  // Without threads llvmpipe draws small scenes several times faster, and always in order.
  Environment result{{"GALLIUM_DRIVER", driver}, {"LP_NUM_THREADS", "0"}};
  if (front_end != FrontEnd::osmesa) result.emplace("LIBGL_ALWAYS_SOFTWARE", "1");
  if (driver == "softpipe" && front_end != FrontEnd::egl_es) {
    // It has shader storage blocks, but claims OpenGL 3.3, which has none. It claims OpenGL ES 3.1.
    result.emplace("MESA_GL_VERSION_OVERRIDE", "4.5");
    result.emplace("MESA_GLSL_VERSION_OVERRIDE", "450");
  }
  return result;
}

// What the worker of a driver has to know in any case.
Command worker_command(const std::string& worker, const char* context, const std::string& driver,
                       Environment environment) {
  const auto claimed = environment.find("MESA_GL_VERSION_OVERRIDE");
  environment.merge(shader_cache_variables(
      claimed == environment.end() ? driver : driver + "-" + claimed->second));
  return {{worker, context, "--expect-driver", driver}, std::move(environment), kDriverVariables};
}

Command mesa_command(const std::string& worker, FrontEnd front_end, const std::string& driver) {
  return worker_command(worker, front_end == FrontEnd::osmesa ? "osmesa" : surfaceless(front_end),
                        driver, mesa_environment(driver, front_end));
}

// A browser, which draws with SwiftShader of its own or with Mesa's llvmpipe.
Command webgl_command(const std::string& worker, const std::string& browser) {
  if (browser == "chromium") return {{worker, browser}, {}, kDriverVariables};
  return {{worker, browser}, mesa_environment("llvmpipe", FrontEnd::egl), kDriverVariables};
}

// Where Debian's packages describe Vulkan drivers to the loader.
constexpr const char* kSwiftShader = "/usr/lib/chromium/vk_swiftshader_icd.json";
constexpr const char* kVulkanDrivers = "/usr/share/vulkan/icd.d";

// Variables with which a user chooses a Vulkan driver, puts layers before it, or tunes zink.
const std::vector<std::string> kVulkanVariables = {
    "VK_ADD_DRIVER_FILES", "VK_LOADER_DRIVERS_SELECT", "VK_LOADER_DRIVERS_DISABLE",
    "VK_INSTANCE_LAYERS",  "VK_LOADER_LAYERS_ENABLE",  "MESA_VK_DEVICE_SELECT",
    "ZINK_DEBUG",          "ZINK_DESCRIPTORS"};

// lavapipe's description, whose name contains the machine's architecture. If it is not installed, a
// name for the message that says so.
std::string lavapipe_description() {
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(kVulkanDrivers, ignored))
    if (entry.path().filename().string().starts_with("lvp_icd.")) return entry.path().string();
  return std::string(kVulkanDrivers) + "/lvp_icd.json";
}

// OpenGL by zink, upon lavapipe or SwiftShader.
Command zink_command(const std::string& worker, FrontEnd front_end, const std::string& driver) {
  const std::string description = driver == "zink" ? lavapipe_description() : kSwiftShader;
  Environment environment{{"MESA_LOADER_DRIVER_OVERRIDE", "zink"},
                          // Without it Mesa looks for a graphics card, and finds none.
                          {"LIBGL_ALWAYS_SOFTWARE", "1"},
                          // Mesa's device selection layer would ask for a display.
                          {"NODEVICE_SELECT", "1"},
                          // The second is the newer name of the first; loaders know one or both.
                          {"VK_ICD_FILENAMES", description},
                          {"VK_DRIVER_FILES", description},
                          {"LP_NUM_THREADS", "0"}};
  if (driver == "zink-swiftshader") {
    // It lacks features that zink wants for OpenGL 4.3, but has all that capturing needs.
    environment.emplace("MESA_GL_VERSION_OVERRIDE", "4.3");
    environment.emplace("MESA_GLSL_VERSION_OVERRIDE", "430");
  }
  Command command = worker_command(worker, surfaceless(front_end), driver, std::move(environment));
  command.unset.insert(command.unset.end(), kVulkanVariables.begin(), kVulkanVariables.end());
  return command;
}

// A device or a library is used with the user's environment, to show what the system offers; the
// variables of a build tree of Mesa (`meson devenv`) reach it, for instance.
Command user_command(const std::string& worker, FrontEnd front_end, const std::string& context) {
  const char* const prefix = front_end == FrontEnd::egl_es ? "egl-es-" : "egl-";
  return {{worker, prefix + context}, {{"LP_NUM_THREADS", "0"}}, {}};
}

// The words of a command line; nothing if a quote is not closed.
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

bool is_file(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(path, ignored);
}

std::variant<ProcessSpec, UnknownRenderer> exec_renderer(const NamedRenderer& renderer,
                                                         const std::filesystem::path& folder) {
  const std::string text = renderer.address.substr(kExecPrefix.size());
  const auto words = is_file(folder / text) ? std::vector<std::string>{text} : split_words(text);
  if (!words)
    return UnknownRenderer{fmt::format("'{}' has a quote that is not closed", renderer.address)};
  if (words->empty())
    return UnknownRenderer{"exec: names no program; write exec:PROGRAM or exec:'PROGRAM ARGUMENT'"};
  ProcessSpec spec;
  spec.name = renderer.name;
  spec.command.argv = *words;
  spec.command.folder = folder.string();
  std::string& program = spec.command.argv.front();
  if (program.find('/') == std::string::npos && is_file(folder / program)) program = "./" + program;
  return spec;
}

bool is_number(std::string_view text) {
  return !text.empty() && text.size() <= 3 &&
         std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

// The worker of a driver, by the text after the colon; nothing if there is no such driver.
// `folder`: from which paths count.
std::optional<Command> driver_command(const std::string& worker, FrontEnd front_end,
                                      const std::string& driver,
                                      const std::filesystem::path& folder) {
  if (driver == "llvmpipe" || driver == "softpipe") return mesa_command(worker, front_end, driver);
  if (front_end == FrontEnd::osmesa) return std::nullopt;
  // SwiftShader keeps floats in depth24, and reading it through OpenGL ES does not show that.
  if (driver == "zink" || (driver == "zink-swiftshader" && front_end == FrontEnd::egl))
    return zink_command(worker, front_end, driver);
  if (driver.starts_with(kLibrary) && driver.size() > kLibrary.size())
    return user_command(
        worker, front_end,
        "lib:" + std::filesystem::absolute(folder / driver.substr(kLibrary.size())).string());
  if (driver.starts_with(kNamedDevice) && driver.size() > kNamedDevice.size())
    return user_command(worker, front_end, "device:" + driver.substr(kNamedDevice.size()));
  if (driver.starts_with(kDevice) && is_number(driver.substr(kDevice.size())))
    return user_command(worker, front_end, "device:" + driver.substr(kDevice.size()));
  return std::nullopt;
}

struct Prefix {
  std::string_view text;
  FrontEnd front_end;
};
constexpr Prefix kPrefixes[] = {
    {kOsmesaPrefix, FrontEnd::osmesa}, {kEglPrefix, FrontEnd::egl}, {kEsPrefix, FrontEnd::egl_es}};

// A question that suggests a renderer for an unknown name, with a space behind it; may be empty.
// Files are programs or recordings; a driver alone, or with a front end that lacks it, is suggested
// with a front end that has it.
std::string suggestion_for(const std::string& name) {
  if (is_file(name))
    return fmt::format("did you mean {}{}? ",
                       name.ends_with(".rec") ? kRecordingPrefix : kExecPrefix, name);
  std::vector<std::string> known = {"exact"};
  for (const auto* names :
       {&opengl_renderer_names(), &opengl_es_renderer_names(), &webgl_renderer_names()})
    known.insert(known.end(), names->begin(), names->end());
  const std::string driver = ":" + name.substr(name.rfind(':') + 1);
  const auto nearest = nearest_name(name, known);
  if (!nearest.empty()) return fmt::format("did you mean {}? ", nearest);
  for (const std::string& one : known)
    if (driver.size() > 1 && one.ends_with(driver)) return fmt::format("did you mean {}? ", one);
  return "";
}

}  // namespace

const std::vector<std::string>& opengl_renderer_names() {
  static const std::vector<std::string> names = {
      "egl:llvmpipe", "egl:softpipe",    "egl:zink",       "egl:zink-swiftshader",
      "egl:device0",  "osmesa:llvmpipe", "osmesa:softpipe"};
  return names;
}

const std::vector<std::string>& opengl_es_renderer_names() {
  static const std::vector<std::string> names = {"egl-es:llvmpipe", "egl-es:softpipe",
                                                 "egl-es:zink", "egl-es:device0"};
  return names;
}

const std::vector<std::string>& webgl_renderer_names() {
  static const std::vector<std::string> names = {"webgl:chromium", "webgl:chromium-gl",
                                                 "webgl:firefox"};
  return names;
}

std::string known_renderer_names() {
  return "exact, egl:llvmpipe, egl:softpipe, egl:zink, egl:zink-swiftshader, egl:deviceN, "
         "egl:device=NAME, egl:lib=PATH, "
         "egl-es:llvmpipe, egl-es:softpipe, egl-es:zink, egl-es:deviceN, egl-es:device=NAME, "
         "egl-es:lib=PATH, osmesa:llvmpipe, "
         "osmesa:softpipe, webgl:chromium, webgl:chromium-gl, webgl:firefox, exec:PROGRAM, "
         "recording:FILE";
}

NamedRenderer split_name(const std::string& renderer) {
  const std::size_t end = renderer.find('=');
  // Behind a colon or a slash it is part of an address.
  if (end == std::string::npos || renderer.find_first_of(":/") < end) return {renderer, renderer};
  return {renderer.substr(0, end), renderer.substr(end + 1)};
}

std::variant<ProcessSpec, UnknownRenderer> find_renderer(const std::string& renderer,
                                                         const std::string& program_directory,
                                                         const std::string& folder) {
  const NamedRenderer named = split_name(renderer);
  const std::string& name = named.address;
  if (name != renderer && !is_own_name(named.name))
    return UnknownRenderer{fmt::format(
        "'{}' is no name for a renderer of yours; write at most 64 letters, digits, '.', '-' and "
        "'_', a letter or digit first, and not exact: mine={}",
        named.name, name)};
  if (name.starts_with(kExecPrefix)) return exec_renderer(named, folder);
  if (is_recording(name))
    return UnknownRenderer{fmt::format(
        "'{}' replays what was recorded: there is no program behind it that could be asked for "
        "more; name the renderer itself",
        name)};
  const std::string worker = (std::filesystem::path(program_directory) / "edgecase-gl").string();
  ProcessSpec spec;
  spec.name = named.name;
  for (const auto& [prefix, front_end] : kPrefixes) {
    if (!name.starts_with(prefix)) continue;
    auto command = driver_command(worker, front_end, name.substr(prefix.size()), folder);
    if (!command) continue;
    spec.command = std::move(*command);
    spec.takes_messages = true;
    return spec;
  }
  if (std::ranges::find(webgl_renderer_names(), name) != webgl_renderer_names().end()) {
    const auto program = std::filesystem::path(program_directory) / "edgecase-webgl";
    spec.command = webgl_command(program.string(), name.substr(kWebPrefix.size()));
    return spec;
  }
  const std::string suggestion = suggestion_for(name);
  return UnknownRenderer{fmt::format("there is no renderer '{}'; {} are {}", name,
                                     suggestion.empty() ? "known" : suggestion + "Known",
                                     known_renderer_names())};
}

bool is_foreign_code(const std::string& renderer) {
  const std::string address = split_name(renderer).address;
  if (address != renderer) return is_foreign_code(address);
  if (address.starts_with(kExecPrefix)) return true;
  return std::ranges::any_of(kPrefixes, [&](const Prefix& prefix) {
    return address.starts_with(prefix.text) &&
           std::string_view(address).substr(prefix.text.size()).starts_with(kLibrary);
  });
}

int listed_egl_devices(const std::string& program_directory) {
  constexpr std::chrono::seconds kPatience{30};
  const std::string worker = (std::filesystem::path(program_directory) / "edgecase-gl").string();
  auto started = ChildProcess::start({{worker, "--devices"}, {}, {}});
  auto* child = std::get_if<std::unique_ptr<ChildProcess>>(&started);
  if (child == nullptr) return 0;
  std::string answer;
  const auto status =
      (*child)->exchange("", answer, 16, ChildProcess::Clock::now() + kPatience, nullptr);
  if (status != ChildProcess::Status::answered || !is_number(answer)) return 0;
  return std::stoi(answer);
}

std::string worker_directory() {
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) return ".";
  const auto folder = program.parent_path();
  const auto installed = (folder / EDGECASE_WORKERS_FROM_PROGRAM).lexically_normal();
  const bool is_beside = is_file((folder / "edgecase-gl").string());
  return !is_beside && is_file((installed / "edgecase-gl").string()) ? installed.string()
                                                                     : folder.string();
}

namespace {

using Made = std::variant<std::unique_ptr<Renderer>, std::string>;

// A renderer with a name other than its address.
class RenamedRenderer final : public Renderer {
 public:
  RenamedRenderer(std::unique_ptr<Renderer> inner, NamedRenderer named)
      : inner_(std::move(inner)), named_(std::move(named)) {}

  const RendererInfo& info() const override {
    info_ = inner_->info();
    info_.name = named_.name;
    info_.traits[kAddressTrait] = named_.address;
    return info_;
  }
  void render(std::span<const Task> tasks, const OutcomeSink& sink) override {
    inner_->render(tasks, sink);
  }
  std::uint64_t outcome_digest() const override { return inner_->outcome_digest(); }

 private:
  std::unique_ptr<Renderer> inner_;
  NamedRenderer named_;
  mutable RendererInfo info_;  // the last result of info()
};

Made make_unnamed(const NamedRenderer& named, const RendererOptions& options) {
  if (named.address == "exact") return std::make_unique<ExactRenderer>(options.policy);
  if (is_recording(named.address)) return open_recording(named.address);
  const auto folder = options.folders.find(named.name);
  auto found = find_renderer(named.address, options.program_directory,
                             folder == options.folders.end() ? "" : folder->second);
  if (auto* unknown = std::get_if<UnknownRenderer>(&found)) return std::move(unknown->message);
  auto& spec = std::get<ProcessSpec>(found);
  spec.timeout = options.timeout;
  spec.startup_timeout = startup_patience(options.timeout);
  spec.stop = options.stop;
  return std::make_unique<ProcessRenderer>(std::move(spec));
}

}  // namespace

Made make_renderer(const std::string& renderer, const RendererOptions& options) {
  NamedRenderer named = split_name(renderer);
  if (named.address == renderer) return make_unnamed(named, options);
  // find_renderer says what is wrong with the name.
  if (!is_own_name(named.name))
    return std::get<UnknownRenderer>(find_renderer(renderer, options.program_directory)).message;
  Made made = make_unnamed(named, options);
  if (auto* inner = std::get_if<std::unique_ptr<Renderer>>(&made))
    return std::make_unique<RenamedRenderer>(std::move(*inner), std::move(named));
  return made;
}

}  // namespace edgecase
