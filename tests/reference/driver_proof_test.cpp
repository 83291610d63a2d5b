// SPDX-License-Identifier: MIT
//
// Which driver is at work, by the strings that drivers of several releases really report.
#include "reference/driver_proof.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace edgecase {
namespace {

using ::testing::HasSubstr;

constexpr const char* kDrivers[] = {"llvmpipe", "softpipe", "zink", "zink-swiftshader"};

TEST(DriverProof, ReadsWhatEachReleaseReports) {
  struct Row {
    const char* gl_renderer;
    const char* driver;  // empty: none of them
  };
  const Row rows[] = {
      // Mesa 22.3.6
      {"llvmpipe (LLVM 15.0.6, 256 bits)", "llvmpipe"},
      {"softpipe", "softpipe"},
      {"zink (llvmpipe (LLVM 15.0.6, 256 bits))", "zink"},
      {"zink (SwiftShader Device (LLVM 10.0.0))", "zink-swiftshader"},
      // Mesa 25.0.7
      {"llvmpipe (LLVM 19.1.7, 256 bits)", "llvmpipe"},
      {"zink Vulkan 1.4(llvmpipe (LLVM 19.1.7, 256 bits) (MESA_LLVMPIPE))", "zink"},
      // Graphics cards
      {"zink Vulkan 1.3(AMD Radeon RX 6800 (RADV NAVI21) (MESA_RADV))", ""},
      {"NVIDIA H100 PCIe/PCIe/SSE2", ""},
  };
  for (const Row& row : rows)
    for (const std::string driver : kDrivers) {
      const std::string doubt = doubt_of_driver(driver, row.gl_renderer);
      if (driver != row.driver)
        EXPECT_THAT(doubt, HasSubstr("the driver is '")) << driver << ", " << row.gl_renderer;
      else if (driver.starts_with("zink"))
        // The name is right, but this process has not opened the Vulkan driver.
        EXPECT_THAT(doubt, HasSubstr("is not what this process executes")) << row.gl_renderer;
      else
        EXPECT_EQ(doubt, "") << row.gl_renderer;
    }
}

}  // namespace
}  // namespace edgecase
