// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <memory>
#include <utility>

#include "processes/process_renderer.h"
#include "reports/text.h"
#include "run/renderers.h"
#include "tools/edgecase/commands/commands.h"
#include "tools/edgecase/interrupt.h"
#include "tools/edgecase/options.h"
#include "tools/edgecase/protocol/backend_probe.h"
#include "tools/edgecase/protocol/checks.h"
#include "tools/edgecase/protocol/report.h"

namespace edgecase {

namespace {

constexpr std::size_t kColumns = 12;
using Row = std::array<std::string, kColumns>;

constexpr const char* kExplanation =
    "\nbits claimed / measured: GL_SUBPIXEL_BITS, and what a probe with a slanted edge resolves.\n"
    "capture: fragments come with depth and colour; + hits: an independent count per pixel "
    "agrees;\nssbo: OpenGL's shaders store them in a buffer; words: they are drawn, part by part.\n"
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
  return fmt::format("{} / {}", claim == info.traits.end() ? "?" : one_line(claim->second), drawn);
}

// Whether fragments come with colours and hits, and the way in which OpenGL tells them.
std::string capture_of(const RendererInfo& info, const ProbeResult& result) {
  const auto way = info.traits.find("capture");
  return yes_or_no(result.fragment_colors) + (result.hits_agree ? " + hits" : "") +
         (way == info.traits.end() ? "" : ", " + one_line(way->second));
}

Row row_of(const RendererInfo& info, const ProbeResult& result) {
  const std::string bits = result.subpixel_bits == 0 ? "?"
                                                     : fmt::format("{}{}", result.subpixel_bits,
                                                                   result.more_bits ? "+" : "");
  return {info.name,
          one_line(info.device),
          one_line(info.version),
          fmt::format("{} / {}", info.subpixel_bits, bits),
          capture_of(info, result),
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

namespace {

struct BackendsCommand {
  std::vector<std::string> names;
  std::string json;
  double timeout = 10;
};

using Examinations = std::vector<std::pair<std::string, ProtocolExamination>>;

// True for programs of users, which speak the protocol.
bool is_program(const ProcessSpec& spec) {
  return spec.name.starts_with("exec:");
}

// Examines the protocol of each program, and prints each examination when it is done unless
// standard output is for JSON. Ends early if interrupted.
Examinations examine(const std::vector<ProcessSpec>& specs, const BackendsCommand& command) {
  const std::chrono::milliseconds patience(static_cast<std::int64_t>(1000 * command.timeout));
  Examinations all;
  for (const ProcessSpec& spec : specs) {
    if (!is_program(spec)) continue;
    if (interrupted()) break;
    all.emplace_back(spec.name, examine_protocol(spec.command, patience, &interrupted()));
    if (command.json != "-")
      fmt::print("{}\n", xml_text(examination_text(all.back().first, all.back().second)));
  }
  return all;
}

// The exit code of examinations: 4 if a program does not start, 1 if a check fails or a root is
// found. A program that was not asked before an interruption has done neither.
ExitCode examined_exit_code(const Examinations& examinations) {
  ExitCode code = ExitCode::as_expected;
  for (const auto& [name, examination] : examinations) {
    if (!examination.started && !examination.checks.empty()) code = worse(code, ExitCode::renderer);
    if (examination.count(CheckOutcome::fail) > 0 || !examination.roots.empty())
      code = worse(code, ExitCode::unexpected);
  }
  return code;
}

// True if the examination has shown that the program answers nothing, so that it is not probed.
bool is_dead(const std::string& name, const Examinations& examinations) {
  return std::any_of(examinations.begin(), examinations.end(), [&](const auto& examined) {
    return examined.first == name && !examined.second.started;
  });
}

// Probes all except dead programs and prints the table. Returns 4 if a named renderer of ours, or
// all default ones, draw nothing.
ExitCode print_probes(std::vector<ProcessSpec>& specs, const Examinations& examinations,
                      bool all_must_work) {
  std::vector<Row> rows = {{"renderer", "device", "version", "bits claimed / measured", "capture",
                            "fragments", "smooth", "surfaces", "line widths", "point sizes",
                            "first", ""}};
  std::size_t working = 0;
  for (ProcessSpec& spec : specs) {
    if (is_dead(spec.name, examinations)) continue;
    spec.stop = &interrupted();
    ProcessRenderer renderer(spec);
    const ProbeResult result = probe(renderer);
    if (result.problem.empty() || is_program(spec)) ++working;
    rows.push_back(row_of(renderer.info(), result));
    if (!result.problem.empty()) rows.back().back() = one_line(result.problem);
  }
  if (rows.size() > 1) {
    print_table(rows);
    fmt::print("{}", kExplanation);
  }
  const bool enough = all_must_work ? working == rows.size() - 1 : working > 0;
  return enough ? ExitCode::as_expected : ExitCode::renderer;
}

// All drivers by name, of OpenGL, OpenGL ES and WebGL, and every device that EGL lists. The first
// device is included even if EGL lists none, so that the reason is shown.
std::vector<std::string> default_names() {
  std::vector<std::string> names = opengl_renderer_names();
  const auto& es = opengl_es_renderer_names();
  const auto& web = webgl_renderer_names();
  names.insert(names.end(), es.begin(), es.end());
  names.insert(names.end(), web.begin(), web.end());
  const int devices = listed_egl_devices(worker_directory());
  for (int device = 1; device < devices; ++device)
    for (const char* front_end : {"egl", "egl-es"})
      names.push_back(fmt::format("{}:device{}", front_end, device));
  return names;
}

ExitCode run_backends(const BackendsCommand& command) {
  std::vector<ProcessSpec> specs;
  for (const std::string& name : command.names.empty() ? default_names() : command.names) {
    auto found = find_renderer(name, worker_directory());
    if (const auto* unknown = std::get_if<UnknownRenderer>(&found)) {
      print_error(unknown->message);
      return ExitCode::usage;
    }
    specs.push_back(std::move(std::get<ProcessSpec>(found)));
  }
  const InterruptGuard guard;
  const Examinations examinations = examine(specs, command);
  ExitCode code = examined_exit_code(examinations);
  if (!command.json.empty()) {
    const std::string text = examinations_json(examinations);
    if (command.json == "-")
      fmt::print("{}", text);
    else if (!write_file(command.json, text))
      code = ExitCode::internal;
  }
  if (command.json != "-" && !interrupted()) {
    const ExitCode probed = print_probes(specs, examinations, !command.names.empty());
    // An interrupted renderer has not failed.
    if (!interrupted()) return worse(code, probed);
  }
  if (!interrupted()) return code;
  print_error("interrupted; not all was asked");
  return worse(code, ExitCode::unexpected);
}

}  // namespace

void add_backends_command(CLI::App& app, ExitCode& exit) {
  CLI::App* command = app.add_subcommand(
      "backends", "Test what renderers offer, and check that programs keep the protocol");
  auto options = std::make_shared<BackendsCommand>();
  command->add_option("renderers", options->names,
                      "Renderers (default: those of OpenGL and OpenGL ES, with every EGL device)");
  command->add_option("--json", options->json,
                      "Write the checks of programs as JSON; - for standard output");
  command->add_option("--timeout", options->timeout, "Seconds for each answer to a check")
      ->check(in_range(0.001, 3600.0));
  command->callback([options, &exit] { exit = run_backends(*options); });
}

}  // namespace edgecase
