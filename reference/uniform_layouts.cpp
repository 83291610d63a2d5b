// SPDX-License-Identifier: MIT
#include "reference/uniform_layouts.h"

#include <string_view>

namespace edgecase {

namespace {

constexpr std::string_view kUniform = ") uniform ";  // behind the number
constexpr std::string_view kLayouts[] = {"layout(location = ", "layout(binding = "};

// Takes the layouts of one kind out of the text.
void take(std::string& source, std::string_view layout, std::vector<UniformLayout>& layouts) {
  for (std::size_t at = source.find(layout); at != std::string::npos;
       at = source.find(layout, at + 1)) {
    const std::size_t number = at + layout.size();
    const std::size_t behind = source.find(')', number);
    // Inputs and outputs have numbers in all versions.
    if (source.compare(behind, kUniform.size(), kUniform) != 0) continue;
    const std::size_t end = source.find(';', behind);
    const std::size_t name = source.rfind(' ', end) + 1;
    layouts.push_back(
        {source.substr(name, end - name), std::stoi(source.substr(number)), layout == kLayouts[1]});
    source.erase(at, behind + 2 - at);
  }
}

}  // namespace

// layout(WHAT = NUMBER) uniform TYPE NAME;
void take_uniform_layouts(std::string& source, std::vector<UniformLayout>& layouts) {
  for (const std::string_view layout : kLayouts) take(source, layout, layouts);
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
