// SPDX-License-Identifier: MIT
#include "reference/uniform_layouts.h"

#include <regex>

namespace edgecase {

void take_uniform_layouts(std::string& source, std::vector<UniformLayout>& layouts) {
  // layout(WHAT = NUMBER) uniform TYPE NAME;
  static const std::regex pattern(
      R"(layout\((location|binding) = (\d+)\) (uniform \w+ (\w+);))");
  for (std::sregex_iterator found(source.begin(), source.end(), pattern), end; found != end;
       ++found)
    layouts.push_back({(*found)[4], std::stoi((*found)[2]), (*found)[1] == "binding"});
  source = std::regex_replace(source, pattern, "$3");
}

void apply_uniform_layouts(const GladGLContext& gl, const std::vector<UniformLayout>& layouts,
                           GlProgram& program) {
  std::array<GLint, GlProgram::kUniforms> locations;
  locations.fill(-1);
  gl.UseProgram(program.name());
  for (const UniformLayout& layout : layouts) {
    const GLint location = gl.GetUniformLocation(program.name(), layout.name.c_str());
    if (layout.is_binding)
      gl.Uniform1i(location, layout.number);
    else
      locations.at(static_cast<std::size_t>(layout.number)) = location;
  }
  program.set_locations(locations);
}

}  // namespace edgecase
