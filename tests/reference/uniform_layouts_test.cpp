// SPDX-License-Identifier: MIT
//
// Numbers of uniforms for GLSL that has none.
#include "reference/uniform_layouts.h"

#include <gtest/gtest.h>

namespace edgecase {
namespace {

TEST(UniformLayouts, AreTakenOutOfTheText) {
  std::string source = R"(
layout(location = 3) uniform float value;
layout(binding = 2) uniform isampler2D limits;
layout(location = 0) out vec4 target;
)";
  std::vector<UniformLayout> layouts;
  take_uniform_layouts(source, layouts);
  EXPECT_EQ(source, R"(
uniform float value;
uniform isampler2D limits;
layout(location = 0) out vec4 target;
)");
  ASSERT_EQ(layouts.size(), 2u);
  EXPECT_EQ(layouts[0].name, "value");
  EXPECT_EQ(layouts[0].number, 3);
  EXPECT_FALSE(layouts[0].is_binding);
  EXPECT_EQ(layouts[1].name, "limits");
  EXPECT_EQ(layouts[1].number, 2);
  EXPECT_TRUE(layouts[1].is_binding);
}

GLint unit_of_limits = -1;

TEST(UniformLayouts, BecomeLocationsAndUnits) {
  GladGLContext gl{};
  gl.DeleteProgram = [](GLuint) {};
  gl.UseProgram = [](GLuint) {};
  gl.GetUniformLocation = [](GLuint, const GLchar* name) {
    return std::string(name) == "value" ? 17 : 23;
  };
  gl.Uniform1i = [](GLint location, GLint unit) {
    if (location == 23) unit_of_limits = unit;
  };
  GlProgram program(gl, 1);
  EXPECT_EQ(program.location(3), 3) << "explicit locations";
  apply_uniform_layouts(gl, {{"value", 3, false}, {"limits", 2, true}}, program);
  EXPECT_EQ(program.location(3), 17);
  EXPECT_EQ(program.location(2), -1) << "the program has no such uniform";
  EXPECT_EQ(unit_of_limits, 2);
}

}  // namespace
}  // namespace edgecase
