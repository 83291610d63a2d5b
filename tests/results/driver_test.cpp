// SPDX-License-Identifier: MIT
//
// Drivers and releases by what real renderers report of themselves.
#include "results/known_faults.h"

#include <gtest/gtest.h>

namespace edgecase {
namespace {

RendererInfo info_of(const std::string& name, const std::string& device,
                     const std::string& version) {
  RendererInfo info;
  info.name = name;
  info.device = device;
  info.version = version;
  return info;
}

TEST(Driver, IsReadFromWhatRenderersReport) {
  struct Row {
    RendererInfo info;
    const char* driver;
    const char* release;
  };
  const Row rows[] = {
      {info_of("osmesa:llvmpipe", "llvmpipe (LLVM 15.0.6, 256 bits)",
               "4.5 (Core Profile) Mesa 22.3.6"),
       "llvmpipe", "Mesa 22.3.6"},
      {info_of("egl-es:softpipe", "softpipe", "OpenGL ES 3.1 Mesa 22.3.6"), "softpipe",
       "Mesa 22.3.6 ES"},
      {info_of("egl:zink", "zink (llvmpipe (LLVM 15.0.6, 256 bits))",
               "4.6 (Core Profile) Mesa 22.3.6"),
       "zink", "Mesa 22.3.6"},
      {info_of("egl:zink", "zink Vulkan 1.4(llvmpipe (LLVM 19.1.7, 256 bits) (MESA_LLVMPIPE))",
               "4.6 (Core Profile) Mesa 25.0.7-2"),
       "zink", "Mesa 25.0.7"},
      {info_of("egl:zink-swiftshader", "zink (SwiftShader Device (LLVM 10.0.0))",
               "4.6 (Core Profile) Mesa 22.3.6"),
       "SwiftShader", "Mesa 22.3.6"},
      {info_of(
           "egl-es:lib=/opt/angle",
           "ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device (Subzero) (0x0000C0DE)), SwiftShader "
           "driver-5.0.0)",
           "OpenGL ES 3.1 (ANGLE 2.1.27278 git hash: 0d61b30acc76)"),
       "SwiftShader", "ANGLE 2.1.27278 ES"},
      {info_of("egl-es:lib=/opt/angle",
               "ANGLE (NVIDIA Corporation, NVIDIA GeForce RTX 3080/PCIe/SSE2, OpenGL 4.5.0)",
               "OpenGL ES 3.1 (ANGLE 2.1.1 git hash: unknown hash)"),
       "NVIDIA GeForce RTX 3080", "ANGLE 2.1.1 ES"},
      {info_of("egl:device0", "NVIDIA H100 PCIe/PCIe/SSE2", "4.6.0 NVIDIA 535.104.05"),
       "NVIDIA H100 PCIe", "NVIDIA 535.104.5"},
      {info_of("exec:./mine", "a device", "tiny 1.2"), "exec:./mine", "tiny 1.2"},
      {info_of("exec:./mine", "", "7"), "exec:./mine", "7"},
      {info_of("exec:./mine", "", ""), "exec:./mine", "unversioned"},
      {info_of("exec:./mine", "", "of today"), "exec:./mine", "of today"},
      {info_of("egl:device0", "", ""), "egl:device0", "unversioned"},
  };
  for (const Row& row : rows) {
    EXPECT_EQ(driver_of(row.info), row.driver);
    EXPECT_EQ(text_of(release_of(row.info)), row.release) << row.info.version;
  }
}

TEST(Driver, OfARecordingIsTheRecordedOnes) {
  RendererInfo info = info_of("recording:a.rec", "llvmpipe (LLVM 15.0.6, 256 bits)",
                              "4.5 (Core Profile) Mesa 22.3.6");
  EXPECT_EQ(driver_of(info), "recording:a.rec");
  info.traits[kRecordedTrait] = "egl:llvmpipe";
  EXPECT_EQ(driver_of(info), "llvmpipe");
  EXPECT_EQ(text_of(release_of(info)), "Mesa 22.3.6");
}

TEST(Driver, OfANamedProgramIsItsName) {
  RendererInfo info = info_of("mine", "a device", "tiny 1.2");
  info.traits[kAddressTrait] = "exec:./mine";
  EXPECT_EQ(driver_of(info), "mine");
  EXPECT_EQ(text_of(release_of(info)), "tiny 1.2");
  info = info_of("mine", "llvmpipe (LLVM 15.0.6, 256 bits)", "4.5 (Core Profile) Mesa 22.3.6");
  info.traits[kAddressTrait] = "egl:llvmpipe";
  EXPECT_EQ(driver_of(info), "llvmpipe");
  EXPECT_EQ(text_of(release_of(info)), "Mesa 22.3.6");
}

VersionRange range(const std::string& text) {
  const auto parsed = parse_range(text);
  if (const auto* fault = std::get_if<std::string>(&parsed)) throw std::runtime_error(*fault);
  return std::get<VersionRange>(parsed);
}

TEST(VersionRange, ReadsBack) {
  for (const char* text : {"Mesa >=22.3", "Mesa >=22.3.6 <25.1", "Mesa <25", "Mesa", ">=1 <2",
                           "NVIDIA GRID >=535.104"})
    EXPECT_EQ(text_of(range(text)), text);
  EXPECT_EQ(text_of(range("Mesa >= 22.3  < 25")), "Mesa >=22.3 <25");
  for (const char* text : {"", ">22", "Mesa <=3", "Mesa >=", "Mesa >=x", "Mesa >=22 >=23",
                           "Mesa >=25 <22", "Mesa >=25 <25.0", "Mesa >=1234567890"})
    EXPECT_TRUE(std::holds_alternative<std::string>(parse_range(text))) << text;
}

TEST(VersionRange, HoldsWhatLiesWithin) {
  const auto holds_in = [](const std::string& text, std::vector<int> numbers) {
    return holds(range(text), {"Mesa", std::move(numbers), false});
  };
  EXPECT_TRUE(holds_in("Mesa >=22.3 <25.1", {22, 3}));
  EXPECT_TRUE(holds_in("Mesa >=22.3 <25.1", {22, 3, 6}));
  EXPECT_TRUE(holds_in("Mesa >=22.3 <25.1", {25, 0, 99}));
  EXPECT_FALSE(holds_in("Mesa >=22.3 <25.1", {22, 2, 99}));
  EXPECT_FALSE(holds_in("Mesa >=22.3 <25.1", {25, 1}));
  EXPECT_FALSE(holds_in("Mesa >=22.3 <25.1", {25, 1, 0}));
  EXPECT_TRUE(holds_in("Mesa >=22.3", {100}));
  EXPECT_TRUE(holds_in("Mesa <25", {1}));
  EXPECT_FALSE(holds_in("Vulkan >=1", {22, 3}));
  EXPECT_TRUE(holds(range("Mesa >=22.3"), {"Mesa", {22, 3}, true})) << "OpenGL ES as well";
}

}  // namespace
}  // namespace edgecase
