// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "run/process_renderer.h"
#include "run/renderer_names.h"
#include "tools/edgecase/backend_probe.h"
#include "tools/edgecase/backends.h"
#include "tools/edgecase/commands.h"
#include "tools/edgecase/interrupt.h"

namespace edgecase {

namespace {

constexpr int kUsageError = 2;
constexpr int kRendererMissing = 4;

constexpr std::size_t kColumns = 12;
using Row = std::array<std::string, kColumns>;

constexpr const char* kExplanation =
    "\nbits claimed / measured: GL_SUBPIXEL_BITS, and what a probe with a slanted edge resolves.\n"
    "capture: fragments come with depth and colour; + hits: an independent count per pixel "
    "agrees.\n"
    "fragments: of one point, one line and one triangle.  first: start to first rendering.\n"
    "surfaces: fbo, and window where the window system's framebuffer can be drawn to.\n"
    "line widths, point sizes: the range that the driver claims / the largest power of two that "
    "came\nout that thick (scenes go up to 64).\n";

std::string yes_or_no(bool value) {
  return value ? "yes" : "no";
}

// A range that the renderer claims, and the largest size that was measured.
std::string thickness(const RendererInfo& info, const char* trait, int drawn) {
  const auto claim = info.traits.find(trait);
  return fmt::format("{} / {}", claim == info.traits.end() ? "?" : claim->second, drawn);
}

Row describe(const RendererInfo& info, const ProbeResult& result) {
  const std::string bits = result.subpixel_bits == 0 ? "?"
                                                     : fmt::format("{}{}", result.subpixel_bits,
                                                                   result.more_bits ? "+" : "");
  return {info.name,
          info.device,
          info.version,
          fmt::format("{} / {}", info.subpixel_bits, bits),
          yes_or_no(result.fragment_colors) + (result.hits_agree ? " + hits" : ""),
          fmt::format("{} {} {}", result.points, result.lines, result.triangles),
          yes_or_no(result.smooth),
          result.window ? "fbo window" : "fbo",
          thickness(info, "line_widths", result.line_width),
          thickness(info, "point_sizes", result.point_size),
          fmt::format("{} ms", result.first_answer.count()),
          ""};
}

void print_table(const std::vector<Row>& rows) {
  std::array<std::size_t, kColumns> widths{};
  for (const Row& row : rows) {
    if (!row.back().empty()) continue;
    for (std::size_t i = 0; i < kColumns; ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  // A renderer without a rendering has a reason in place of its columns.
  for (const Row& row : rows) widths[0] = std::max(widths[0], row[0].size());
  for (const Row& row : rows) {
    std::string line = fmt::format("{:<{}}", row[0], widths[0]);
    if (!row.back().empty()) {
      line += "  " + row.back();
    } else {
      for (std::size_t i = 1; i + 1 < kColumns; ++i)
        line += fmt::format("  {:<{}}", row[i], widths[i]);
    }
    fmt::print("{}\n", line.substr(0, line.find_last_not_of(' ') + 1));
  }
}

}  // namespace

int run_backends(const std::vector<std::string>& names, const std::string& program_directory) {
  std::vector<ProcessSpec> specs;
  for (const std::string& name : names.empty() ? opengl_renderer_names() : names) {
    auto found = find_renderer(name, program_directory);
    if (const auto* unknown = std::get_if<UnknownRenderer>(&found)) {
      fmt::print(stderr, "edgecase: {}\n", unknown->message);
      return kUsageError;
    }
    specs.push_back(std::move(std::get<ProcessSpec>(found)));
  }
  std::vector<Row> rows = {{"renderer", "device", "version", "bits claimed / measured", "capture",
                            "fragments", "smooth", "surfaces", "line widths", "point sizes",
                            "first", ""}};
  std::size_t working = 0;
  const InterruptGuard guard;
  for (ProcessSpec& spec : specs) {
    spec.stop = &interrupted();
    ProcessRenderer renderer(spec);
    const ProbeResult result = probe(renderer);
    if (result.problem.empty()) ++working;
    rows.push_back(describe(renderer.info(), result));
    if (!result.problem.empty()) rows.back().back() = result.problem;
  }
  print_table(rows);
  fmt::print("{}", kExplanation);
  const bool enough = names.empty() ? working > 0 : working == specs.size();
  return enough ? 0 : kRendererMissing;
}

void add_backends_command(CLI::App& app, ExitCode& exit) {
  CLI::App* command = app.add_subcommand(
      "backends", "Probe renderers by rendering, and print what each really offers");
  auto names = std::make_shared<std::vector<std::string>>();
  command->add_option("renderers", *names, "Renderers (default: the OpenGL ones)");
  command->callback([names, &exit] {
    exit = static_cast<ExitCode>(run_backends(*names, executable_directory()));
  });
}

}  // namespace edgecase
