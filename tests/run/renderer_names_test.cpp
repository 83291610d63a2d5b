// SPDX-License-Identifier: MIT
#include "run/renderers.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace edgecase {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::Pair;

Command command_of(const std::string& name) {
  const auto found = find_renderer(name, "/opt/bin");
  const auto* spec = std::get_if<ProcessSpec>(&found);
  EXPECT_NE(spec, nullptr) << name;
  if (spec == nullptr) return {};
  EXPECT_EQ(spec->name, name);
  return spec->command;
}

std::string message_of(const std::string& name) {
  const auto found = find_renderer(name, "/opt/bin");
  const auto* unknown = std::get_if<UnknownRenderer>(&found);
  return unknown == nullptr ? "" : unknown->message;
}

TEST(RendererNames, MesaDriversComeFromTheWorkerProgram) {
  const Command osmesa = command_of("osmesa:llvmpipe");
  EXPECT_THAT(osmesa.argv,
              ElementsAre("/opt/bin/edgecase-gl", "osmesa", "--expect-driver", "llvmpipe"));
  EXPECT_EQ(osmesa.environment.at("GALLIUM_DRIVER"), "llvmpipe");
  EXPECT_EQ(osmesa.environment.count("LIBGL_ALWAYS_SOFTWARE"), 0u);
  const Command egl = command_of("egl:softpipe");
  EXPECT_THAT(egl.argv, ElementsAre("/opt/bin/edgecase-gl", "egl-surfaceless", "--expect-driver",
                                    "softpipe"));
  EXPECT_EQ(egl.environment.at("LIBGL_ALWAYS_SOFTWARE"), "1");
  EXPECT_EQ(egl.environment.at("MESA_GL_VERSION_OVERRIDE"), "4.5");
  EXPECT_THAT(command_of("egl:device12").argv,
              ElementsAre("/opt/bin/edgecase-gl", "egl-device:12"));
  for (const std::string& name : opengl_renderer_names()) command_of(name);
}

// Sets variables for the time of a test; null unsets one.
class Variables {
 public:
  Variables(std::initializer_list<std::pair<std::string, const char*>> values) {
    for (const auto& [name, value] : values) {
      const char* const before = std::getenv(name.c_str());
      before_[name] = before == nullptr ? std::optional<std::string>() : before;
      set(name, value);
    }
  }
  ~Variables() {
    for (const auto& [name, value] : before_) set(name, value ? value->c_str() : nullptr);
  }
  Variables(const Variables&) = delete;
  Variables& operator=(const Variables&) = delete;

 private:
  static void set(const std::string& name, const char* value) {
    if (value == nullptr)
      unsetenv(name.c_str());
    else
      setenv(name.c_str(), value, 1);
  }
  std::map<std::string, std::optional<std::string>> before_;
};

TEST(RendererNames, MesaKeepsProgramsInAFolderOfOurs) {
  constexpr const char* kDir = "MESA_SHADER_CACHE_DIR";
  const auto folder_of = [&](const std::string& name) {
    const auto environment = command_of(name).environment;
    const auto found = environment.find(kDir);
    return found == environment.end() ? "none" : found->second;
  };
  const Variables clean{{kDir, nullptr},
                        {"MESA_SHADER_CACHE_DISABLE", nullptr},
                        {"XDG_CACHE_HOME", "/caches"},
                        {"HOME", "/home/a"}};
  EXPECT_EQ(folder_of("egl:llvmpipe"), "/caches/edgecase/mesa/llvmpipe");
  // A driver that claims another version is another driver.
  EXPECT_EQ(folder_of("egl:softpipe"), "/caches/edgecase/mesa/softpipe-4.5");
  EXPECT_EQ(folder_of("egl-es:softpipe"), "/caches/edgecase/mesa/softpipe");
  EXPECT_EQ(folder_of("egl:zink"), "/caches/edgecase/mesa/zink");
  EXPECT_EQ(folder_of("egl:zink-swiftshader"), "/caches/edgecase/mesa/zink-swiftshader-4.3");
  // What the system offers is used as it is.
  EXPECT_EQ(folder_of("egl:device0"), "none");
  {
    // A relative path counts as none.
    const Variables home{{"XDG_CACHE_HOME", "here"}};
    EXPECT_EQ(folder_of("egl:llvmpipe"), "/home/a/.cache/edgecase/mesa/llvmpipe");
    const Variables homeless{{"HOME", nullptr}};
    EXPECT_EQ(folder_of("egl:llvmpipe"), "none");
  }
  const Variables chosen{{"MESA_SHADER_CACHE_DISABLE", "true"}};
  EXPECT_EQ(folder_of("egl:llvmpipe"), "none") << "the user has chosen";
}

TEST(RendererNames, OpenGlEsIsAnotherContextOfTheSameDriver) {
  const Command softpipe = command_of("egl-es:softpipe");
  EXPECT_THAT(softpipe.argv, ElementsAre("/opt/bin/edgecase-gl", "egl-es-surfaceless",
                                         "--expect-driver", "softpipe"));
  EXPECT_EQ(softpipe.environment.at("GALLIUM_DRIVER"), "softpipe");
  EXPECT_EQ(softpipe.environment.at("LIBGL_ALWAYS_SOFTWARE"), "1");
  // It claims OpenGL ES 3.1 by itself.
  EXPECT_EQ(softpipe.environment.count("MESA_GL_VERSION_OVERRIDE"), 0u);
  EXPECT_THAT(softpipe.unset, IsSupersetOf({"MESA_GLES_VERSION_OVERRIDE"}));
  EXPECT_EQ(command_of("egl-es:zink").argv[1], "egl-es-surfaceless");
  EXPECT_THAT(command_of("egl-es:device3").argv,
              ElementsAre("/opt/bin/edgecase-gl", "egl-es-device:3"));
  for (const std::string& name : opengl_es_renderer_names()) command_of(name);
  EXPECT_THAT(message_of("egl-es:zink-swiftshader"), HasSubstr("there is no renderer"));
}

TEST(RendererNames, BrowsersHaveAWorkerOfTheirOwn) {
  const Command own = command_of("webgl:chromium");
  EXPECT_THAT(own.argv, ElementsAre("/opt/bin/edgecase-webgl", "chromium"));
  EXPECT_TRUE(own.environment.empty());
  const Command mesa = command_of("webgl:chromium-gl");
  EXPECT_THAT(mesa.argv, ElementsAre("/opt/bin/edgecase-webgl", "chromium-gl"));
  EXPECT_EQ(mesa.environment.at("GALLIUM_DRIVER"), "llvmpipe");
  for (const std::string& name : webgl_renderer_names()) command_of(name);
  EXPECT_THAT(message_of("webgl:safari"), HasSubstr("there is no renderer"));
  EXPECT_TRUE(is_opengl("webgl:chromium")) << "a driver has its faults in a browser, too";
}

TEST(RendererNames, ADeviceOrALibraryIsTheUsersOwn) {
  EXPECT_THAT(command_of("egl:device=NVIDIA H100").argv,
              ElementsAre("/opt/bin/edgecase-gl", "egl-device:NVIDIA H100"));
  EXPECT_THAT(command_of("egl-es:device=software").argv,
              ElementsAre("/opt/bin/edgecase-gl", "egl-es-device:software"));
  const Command angle = command_of("egl-es:lib=/opt/angle/libEGL.so");
  EXPECT_THAT(angle.argv, ElementsAre("/opt/bin/edgecase-gl", "egl-es-lib:/opt/angle/libEGL.so"));
  EXPECT_TRUE(angle.unset.empty()) << "variables of the user reach it";
  // A path that does not begin at the root counts from where we are, and the worker from elsewhere.
  EXPECT_EQ(command_of("egl:lib=own").argv[1],
            "egl-lib:" + std::filesystem::absolute("own").string());
  EXPECT_THAT(message_of("egl:lib="), HasSubstr("egl:lib=PATH"));
  EXPECT_THAT(message_of("osmesa:lib=/opt/mesa"), HasSubstr("there is no renderer"));
}

TEST(RendererNames, WithoutAWorkerNoDevicesAreListed) {
  EXPECT_EQ(listed_egl_devices("/no/such/folder"), 0);
}

TEST(RendererNames, ARecordingHasNoProgram) {
  EXPECT_THAT(message_of("recording:some.rec"),
              AllOf(HasSubstr("'recording:some.rec'"), HasSubstr("no program behind it")));
  EXPECT_THAT(message_of("osmesa:recording"), HasSubstr("recording:FILE"));
}

TEST(RendererNames, ZinkComesWithItsVulkanDriver) {
  const Command lavapipe = command_of("egl:zink");
  EXPECT_THAT(lavapipe.argv,
              ElementsAre("/opt/bin/edgecase-gl", "egl-surfaceless", "--expect-driver", "zink"));
  EXPECT_EQ(lavapipe.environment.at("MESA_LOADER_DRIVER_OVERRIDE"), "zink");
  EXPECT_THAT(lavapipe.environment.at("VK_ICD_FILENAMES"), HasSubstr("/lvp_icd."));
  EXPECT_EQ(lavapipe.environment.count("MESA_GL_VERSION_OVERRIDE"), 0u);
  const Command swiftshader = command_of("egl:zink-swiftshader");
  EXPECT_EQ(swiftshader.argv.back(), "zink-swiftshader");
  EXPECT_THAT(swiftshader.environment.at("VK_ICD_FILENAMES"), HasSubstr("vk_swiftshader_icd.json"));
  EXPECT_EQ(swiftshader.environment.at("MESA_GL_VERSION_OVERRIDE"), "4.3");
  for (const Command* command : {&lavapipe, &swiftshader}) {
    EXPECT_EQ(command->environment.at("VK_DRIVER_FILES"),
              command->environment.at("VK_ICD_FILENAMES"));
    EXPECT_THAT(command->unset, IsSupersetOf({"GALLIUM_DRIVER", "ZINK_DEBUG", "VK_INSTANCE_LAYERS",
                                              "VK_ADD_DRIVER_FILES"}));
  }
}

TEST(RendererNames, ExecTakesACommandLine) {
  EXPECT_THAT(command_of("exec:python3 my.py").argv, ElementsAre("python3", "my.py"));
  EXPECT_THAT(command_of("exec: a  'b  c' d\"e f\"g '' ").argv,
              ElementsAre("a", "b  c", "de fg", ""));
}

TEST(RendererNames, ExecTakesTheFileOfThatName) {
  const auto folder = std::filesystem::temp_directory_path() / "edgecase renderer names";
  std::filesystem::create_directories(folder);
  const std::string path = folder / "a program";
  std::fclose(std::fopen(path.c_str(), "w"));
  EXPECT_THAT(command_of("exec:" + path).argv, ElementsAre(path));
  std::filesystem::remove_all(folder);
}

TEST(RendererNames, ANameStandsBeforeTheAddress) {
  const auto parts = [](const std::string& renderer) {
    const NamedRenderer named = split_name(renderer);
    return std::pair(named.name, named.address);
  };
  EXPECT_THAT(parts("mine=exec:./r a=b"), Pair("mine", "exec:./r a=b"));
  EXPECT_THAT(parts("mine=exact"), Pair("mine", "exact"));
  for (const char* whole : {"exec:./r a=b", "exact", "./a=b", ""})
    EXPECT_THAT(parts(whole), Pair(whole, whole));
  const auto found = find_renderer("mine=exec:python3 my.py", "/opt/bin");
  EXPECT_EQ(std::get<ProcessSpec>(found).name, "mine");
  EXPECT_THAT(std::get<ProcessSpec>(found).command.argv, ElementsAre("python3", "my.py"));
  EXPECT_THAT(message_of("my own=exec:r"), HasSubstr("'my own' is no name for a renderer"));
}

TEST(RendererNames, PathsOfAProgramCountFromItsFolder) {
  const auto folder = std::filesystem::temp_directory_path() / "edgecase program's folder";
  std::filesystem::create_directories(folder);
  for (const char* name : {"program", "a program"})
    std::fclose(std::fopen((folder / name).c_str(), "w"));
  const auto command = [&](const std::string& name) {
    return std::get<ProcessSpec>(find_renderer(name, "/opt/bin", folder)).command;
  };
  EXPECT_THAT(command("exec:program x").argv, ElementsAre("./program", "x"));
  EXPECT_THAT(command("exec:a program").argv, ElementsAre("./a program"));
  EXPECT_EQ(command("exec:program").folder, folder.string());
  std::filesystem::remove_all(folder);
}

TEST(RendererNames, RefusalsAskWhatWasMeant) {
  const auto question = [](const std::string& name) {
    const std::string message = message_of(name);
    const auto begin = message.find("did you mean ");
    return begin == std::string::npos ? "" : message.substr(begin, message.find('?') + 1 - begin);
  };
  EXPECT_EQ(question("osmesa:lvmpipe"), "did you mean osmesa:llvmpipe?");
  EXPECT_EQ(question("llvmpipe"), "did you mean egl:llvmpipe?");
  EXPECT_EQ(question("osmesa:zink"), "did you mean egl:zink?");
  EXPECT_EQ(question("egl-es:zink-swiftshader"), "did you mean egl:zink-swiftshader?");
  EXPECT_EQ(question("exat"), "did you mean exact?");
  EXPECT_EQ(question("something else"), "");
  EXPECT_EQ(question(""), "");
  const auto folder = std::filesystem::temp_directory_path() / "edgecase meant";
  std::filesystem::create_directories(folder);
  for (const char* name : {"program", "card.rec"})
    std::fclose(std::fopen((folder / name).c_str(), "w"));
  EXPECT_EQ(question(folder / "program"),
            "did you mean exec:" + (folder / "program").string() + "?");
  EXPECT_EQ(question(folder / "card.rec"),
            "did you mean recording:" + (folder / "card.rec").string() + "?");
  std::filesystem::remove_all(folder);
}

TEST(RendererNames, RefusalsNameWhatIsKnown) {
  for (const char* name :
       {"", "osmesa", "osmesa:zink", "egl:", "egl:device", "egl:device-1", "egl:device1x",
        "egl:device9999", "egl-es:", "egl-es:device", "osmesa:device0", "Osmesa:llvmpipe"})
    EXPECT_THAT(message_of(name), HasSubstr("nown are exact, egl:llvmpipe")) << name;
  EXPECT_THAT(message_of("recording:x"), HasSubstr("there is no program behind it"));
  EXPECT_THAT(message_of("exec:"), HasSubstr("names no program"));
  EXPECT_THAT(message_of("exec:'a"), HasSubstr("quote that is not closed"));
}

}  // namespace
}  // namespace edgecase
