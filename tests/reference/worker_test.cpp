// SPDX-License-Identifier: MIT
//
// The worker program's refusals: what it says when it cannot be what its name promises.
#include <gmock/gmock.h>

#include "reference/egl_library.h"
#include "run/renderers.h"
#include "tests/reference/drawings.h"

namespace edgecase {
namespace {

using ::testing::HasSubstr;

ProcessSpec spec_of(const std::string& name) {
  return std::get<ProcessSpec>(find_renderer(name, EDGECASE_BIN));
}

Failure failure_of(const ProcessSpec& spec) {
  ProcessRenderer renderer(spec);
  const Outcome outcome = render_outcome(renderer, blank_scene(1, 1));
  const auto* failure = std::get_if<Failure>(&outcome);
  return failure == nullptr ? Failure{FailureKind::garbage, "it renders"} : *failure;
}

TEST(Worker, AnotherDriverThanPromisedIsUnavailable) {
  for (const char* way : {"osmesa", "egl"}) {
    ProcessSpec spec = spec_of(std::string(way) + ":llvmpipe");
    spec.command.environment["GALLIUM_DRIVER"] = "softpipe";
    const Failure failure = failure_of(spec);
    EXPECT_EQ(failure.kind, FailureKind::unavailable) << way;
    EXPECT_THAT(failure.reason, testing::AnyOf(HasSubstr("the driver is 'softpipe', not llvmpipe"),
                                               HasSubstr("cannot be opened")));
  }
}

TEST(Worker, AVulkanDriverThatIsNotInstalledIsUnavailable) {
  for (const auto& [name, package] : {std::pair("egl:zink", "package mesa-vulkan-drivers"),
                                      std::pair("egl:zink-swiftshader", "package chromium")}) {
    ProcessSpec spec = spec_of(name);
    spec.command.environment["VK_ICD_FILENAMES"] = "/no/such/driver.json";
    const Failure failure = failure_of(spec);
    EXPECT_EQ(failure.kind, FailureKind::unavailable) << name;
    EXPECT_THAT(failure.reason, HasSubstr("/no/such/driver.json cannot be opened"));
    EXPECT_THAT(failure.reason, HasSubstr(package));
  }
}

TEST(Worker, ZinkUponAnotherVulkanDriverIsUnavailable) {
  ProcessSpec spec = spec_of("egl:zink-swiftshader");
  const ProcessSpec lavapipe = spec_of("egl:zink");
  for (const char* variable : {"VK_ICD_FILENAMES", "VK_DRIVER_FILES"})
    spec.command.environment[variable] = lavapipe.command.environment.at(variable);
  spec.command.environment["MESA_SHADER_CACHE_DISABLE"] = "true";
  const Failure failure = failure_of(spec);
  EXPECT_EQ(failure.kind, FailureKind::unavailable);
  EXPECT_THAT(failure.reason,
              testing::AnyOf(HasSubstr("the driver is 'zink "), HasSubstr("cannot be opened")));
  // lavapipe calls itself llvmpipe, and is another driver than the one of that name.
  ProcessSpec llvmpipe = spec_of("egl:llvmpipe");
  llvmpipe.command.environment = lavapipe.command.environment;
  llvmpipe.command.unset.clear();
  EXPECT_THAT(failure_of(llvmpipe).reason,
              testing::AnyOf(HasSubstr("LLVM"), HasSubstr("cannot be")));
  EXPECT_EQ(failure_of(llvmpipe).kind, FailureKind::unavailable);
}

TEST(Worker, ADeviceThatIsNotThereIsUnavailable) {
  const Failure failure = failure_of(spec_of("egl:device99"));
  EXPECT_EQ(failure.kind, FailureKind::unavailable);
  EXPECT_THAT(failure.reason,
              testing::AnyOf(HasSubstr("there is no EGL device 99"), HasSubstr("cannot be opened"),
                             HasSubstr("cannot list its devices")));
}

TEST(Worker, AnUnknownContextIsUnavailable) {
  ProcessSpec spec = spec_of("egl:llvmpipe");
  for (const char* name : {"glx", "e", "egl-", "egl-device:", "egl-es-", "egl-es-gl", "egl-lib"}) {
    spec.command.argv = {spec.command.argv[0], name};
    EXPECT_THAT(failure_of(spec).reason, HasSubstr("known are osmesa, egl-surfaceless")) << name;
  }
}

TEST(EglLibrary, AnExtensionIsAWholeWordOfItsList) {
  constexpr const char* kList = "EGL_EXT_device_drm_render_node EGL_EXT_device_query ";
  EXPECT_TRUE(has_extension(kList, "EGL_EXT_device_query"));
  EXPECT_FALSE(has_extension(kList, "EGL_EXT_device_drm"));
  EXPECT_FALSE(has_extension(kList, ""));
  EXPECT_FALSE(has_extension(nullptr, "EGL_EXT_device_query"));
}

TEST(Worker, ADeviceIsNamedByThreeLettersOrMore) {
  ProcessSpec spec = spec_of("egl:llvmpipe");
  for (const char* name : {"x", "1x", "of nobody"}) {
    spec.command.argv = {spec.command.argv[0], std::string("egl-device:") + name};
    EXPECT_THAT(failure_of(spec).reason,
                HasSubstr(std::string("no EGL devices have \"") + name + '"'));
  }
}

// Softpipe's own version is 3.3: fragments are then drawn, and not stored.
TEST(Worker, WithoutShaderStorageItTellsTheSame) {
  ProcessSpec spec = spec_of("egl:softpipe");
  Scene scene = blank_scene(8, 8);
  scene.draws = {make_draw(Primitive::triangles, {{0, 0}, {2048, 0}, {0, 2048}}),
                 make_draw(Primitive::lines, {{100, 300}, {1900, 700}})};
  scene.draws[0].interpolation = Interpolation::smooth;
  scene.draws[0].vertices[1].color = {0.25F, -3, 0x1p-30F, 1};
  Rendering stored;
  for (const char* capture : {"ssbo", "words"}) {
    ProcessRenderer renderer(spec);
    const Outcome outcome = render_outcome(renderer, scene);
    if (const auto* failure = std::get_if<Failure>(&outcome)) {
      ASSERT_THAT(failure->reason, HasSubstr("cannot be opened"));
      GTEST_SKIP() << failure->reason;
    }
    EXPECT_EQ(renderer.info().traits.at("capture"), capture);
    const Rendering& rendering = std::get<Rendering>(outcome);
    if (stored.fragments.empty()) stored = rendering;
    EXPECT_EQ(rendering.hits, stored.hits);
    ASSERT_EQ(rendering.fragments.size(), stored.fragments.size());
    for (std::size_t i = 0; i < stored.fragments.size(); ++i) {
      EXPECT_TRUE(cover_alike(rendering.fragments[i], stored.fragments[i])) << i;
      EXPECT_TRUE(have_equal_values(rendering.fragments[i], stored.fragments[i])) << i;
    }
    spec.command.environment.erase("MESA_GL_VERSION_OVERRIDE");
    spec.command.environment.erase("MESA_GLSL_VERSION_OVERRIDE");
  }
}

TEST(Worker, WithoutFineDerivativesItTellsThePlainOnes) {
  ProcessSpec spec = spec_of("egl:llvmpipe");
  spec.command.environment["MESA_GL_VERSION_OVERRIDE"] = "4.3";
  spec.command.environment["MESA_GLSL_VERSION_OVERRIDE"] = "430";
  // Mesa 25.0 crashes where another version's programs are in its cache.
  spec.command.environment["MESA_SHADER_CACHE_DISABLE"] = "true";
  Scene scene = blank_scene(1, 1);
  scene.details.derivatives = true;
  scene.draws = {make_draw(Primitive::points, {{128, 128}})};
  for (bool has_extension : {true, false}) {
    if (!has_extension)
      spec.command.environment["MESA_EXTENSION_OVERRIDE"] = "-GL_ARB_derivative_control";
    ProcessRenderer renderer(spec);
    const Outcome outcome = render_outcome(renderer, scene);
    if (const auto* failure = std::get_if<Failure>(&outcome)) {
      ASSERT_THAT(failure->reason, HasSubstr("cannot be opened"));
      GTEST_SKIP() << failure->reason;
    }
    const Rendering& rendering = std::get<Rendering>(outcome);
    EXPECT_EQ(renderer.info().traits.at("derivatives"),
              has_extension ? "plain fine coarse" : "plain");
    ASSERT_EQ(rendering.details.size(), 1u);
    for (std::size_t i = 0; i < kDerivatives; ++i)
      EXPECT_EQ(rendering.details[0].derivatives[i].has_value(), has_extension || i < 2) << i;
  }
}

}  // namespace
}  // namespace edgecase
