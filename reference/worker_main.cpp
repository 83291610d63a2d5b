// SPDX-License-Identifier: MIT
//
// edgecase-gl: the worker program of the OpenGL renderers.
//
//   edgecase-gl CONTEXT [--expect-driver NAME] [--messages|--bench]
//   edgecase-gl --devices
//
// CONTEXT is osmesa, egl-surfaceless, egl-device:N, egl-device:NAME or egl-lib:PATH or, for OpenGL
// ES, one of the last four with egl-es- in place of egl-. With --devices it only prints how many
// devices EGL lists.
//
// It speaks the protocol of reference/PROTOCOL.md: one scene per line on standard input, one answer
// per line on standard output, until its input ends. With --messages, which the main program uses,
// requests and answers are bytes (wire/message.h), each preceded by its length. With --bench it
// times drawing (wire/message.h). Environment variables set by its parent choose the driver;
// --expect-driver verifies it, see driver_proof.h. If there is no context, or another driver than
// the expected one, it prints a sentence to standard error and exits with status 3.
#include <malloc.h>
#include <unistd.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "reference/bench_service.h"
#include "reference/driver_proof.h"
#include "reference/egl_context.h"
#include "reference/gl_context.h"
#include "reference/scene_renderer.h"
#include "wire/answer_line.h"
#include "wire/message.h"
#include "wire/request_line.h"

namespace edgecase {

namespace {

constexpr int kUsageError = 2;
constexpr int kUnavailable = 3;
constexpr int kContextLost = 4;

int complain(int status, const std::string& sentence) {
  std::fprintf(stderr, "edgecase-gl: %s\n", sentence.c_str());
  return status;
}

// The standard output that the parent reads. A driver's own output goes to standard error. Most
// answers fit into the buffer and are written at once, since each write wakes a waiting parent.
std::FILE* take_standard_output() {
  static std::array<char, std::size_t{1} << 16> buffer;
  const int copy = dup(STDOUT_FILENO);
  if (copy < 0 || dup2(STDERR_FILENO, STDOUT_FILENO) < 0) return nullptr;
  std::FILE* output = fdopen(copy, "w");
  if (output != nullptr) std::setvbuf(output, buffer.data(), _IOFBF, buffer.size());
  return output;
}

bool write_line(std::FILE* output, const std::string& line) {
  return std::fwrite(line.data(), 1, line.size(), output) == line.size() &&
         std::fputc('\n', output) != EOF && std::fflush(output) == 0;
}

// Messages are preceded by their length, eight bytes in this machine's order.
bool write_message(std::FILE* output, const std::string& bytes) {
  const std::uint64_t length = bytes.size();
  return std::fwrite(&length, sizeof(length), 1, output) == 1 &&
         std::fwrite(bytes.data(), 1, bytes.size(), output) == bytes.size() &&
         std::fflush(output) == 0;
}

bool read_message(std::FILE* input, std::string& bytes) {
  std::uint64_t length = 0;
  if (std::fread(&length, sizeof(length), 1, input) != 1) return false;
  bytes.resize(static_cast<std::size_t>(length));
  return std::fread(bytes.data(), 1, bytes.size(), input) == bytes.size();
}

std::string line_of(const std::string& digest, const Outcome& outcome, bool coverage_only,
                    const RendererInfo* claims) {
  if (const auto* failure = std::get_if<Failure>(&outcome))
    return refusal_line(digest, failure->reason, claims);
  const Rendering& rendering = std::get<Rendering>(outcome);
  return coverage_only ? coverage_line(digest, rendering, claims)
                       : answer_line(digest, rendering, claims);
}

// Runs of pixels cannot express samples, passes, or which fragments pass their tests.
bool can_be_runs(const Scene& scene) {
  return scene.target.samples == 1 && scene.supersampling.empty() &&
         !has_fragment_operations(scene);
}

// Draws one scene. `answer(outcome, coverage_only)` writes the answer. Returns the exit status if
// the worker cannot continue.
template <class AnyRequest, class Answer>
std::optional<int> answer_one(SceneRenderer& renderer, const AnyRequest& request, Answer answer) {
  const bool coverage_only = request.coverage_only && can_be_runs(request.scene);
  const Outcome outcome = renderer.render(request.scene, coverage_only);
  const auto* failure = std::get_if<Failure>(&outcome);
  if (failure != nullptr && failure->kind == FailureKind::crashed)
    return complain(kContextLost, failure->reason);
  if (!answer(outcome, coverage_only)) return complain(kUsageError, "the parent reads no more");
  return std::nullopt;
}

int serve_lines(SceneRenderer& renderer, const RendererInfo& info, std::FILE* output) {
  // The parent needs the renderer's identity only once.
  const RendererInfo* claims = &info;
  for (std::string line; std::getline(std::cin, line);) {
    const auto parsed = parse_request(line);
    if (const auto* error = std::get_if<WireError>(&parsed)) {
      if (error->digest.empty()) return complain(kUsageError, "bad request: " + error->message);
      // What this worker does not know may change what must be drawn.
      if (!write_line(output, refusal_line(error->digest, error->message, claims)))
        return complain(kUsageError, "the parent reads no more");
      claims = nullptr;
      continue;
    }
    const Request& request = std::get<Request>(parsed);
    const auto status =
        answer_one(renderer, request, [&](const Outcome& outcome, bool coverage_only) {
          return write_line(output, line_of(request.digest, outcome, coverage_only, claims));
        });
    if (status) return *status;
    claims = nullptr;
  }
  return 0;
}

int serve_messages(SceneRenderer& renderer, const RendererInfo& info, std::FILE* output) {
  const RendererInfo* claims = &info;
  for (std::string bytes; read_message(stdin, bytes);) {
    const auto parsed = parse_request_message(bytes);
    if (const auto* error = std::get_if<WireError>(&parsed))
      return complain(kUsageError, "bad request: " + error->message);
    const auto& request = std::get<IncomingRequest>(parsed);
    const auto status =
        answer_one(renderer, request, [&](const Outcome& outcome, bool coverage_only) {
          return write_message(output,
                               answer_message(request.digest, outcome, coverage_only, claims));
        });
    if (status) return *status;
    claims = nullptr;
  }
  return 0;
}

int serve_bench(SceneRenderer& renderer, std::FILE* output) {
  for (std::string bytes; read_message(stdin, bytes);) {
    const auto parsed = parse_bench_request(bytes);
    if (const auto* error = std::get_if<WireError>(&parsed))
      return complain(kUsageError, "bad request: " + error->message);
    const BenchAnswer answer = time_scenes(renderer, std::get<BenchRequest>(parsed));
    if (!write_message(output, bench_answer_message(answer)))
      return complain(kUsageError, "the parent reads no more");
  }
  return 0;
}

int print_devices() {
  std::FILE* output = take_standard_output();
  if (output == nullptr) return complain(kUsageError, "there is no standard output");
  return write_line(output, std::to_string(count_egl_devices())) ? 0 : kUsageError;
}

// Mesa makes the last folder of its cache, but none above it. Without it there is no cache.
void make_cache_folder() {
  const char* const folder = std::getenv("MESA_SHADER_CACHE_DIR");
  std::error_code ignored;
  if (folder != nullptr) std::filesystem::create_directories(folder, ignored);
}

int run(int argc, char** argv) {
  std::vector<std::string> arguments(argv + 1, argv + argc);
  const auto has_last = [&](const char* option) {
    const bool has = arguments.size() > 1 && arguments.back() == option;
    if (has) arguments.pop_back();
    return has;
  };
  const bool is_bench = has_last("--bench");
  const bool takes_messages = !is_bench && has_last("--messages");
  const bool expects = arguments.size() == 3 && arguments[1] == "--expect-driver";
  if (arguments.size() != 1 && !expects)
    return complain(kUsageError,
                    "usage: edgecase-gl osmesa|egl-surfaceless|egl-device:N|egl-device:NAME|"
                    "egl-lib:PATH [--expect-driver NAME] [--messages|--bench], of OpenGL ES by "
                    "egl-es- in place of egl-, or "
                    "edgecase-gl --devices");
  if (arguments[0] == "--devices") return print_devices();
  const std::string driver = expects ? arguments[2] : "";
  if (std::string missing = missing_for_driver(driver); !missing.empty())
    return complain(kUnavailable, missing);
  std::FILE* output = take_standard_output();
  if (output == nullptr) return complain(kUsageError, "there is no standard output");
  make_cache_folder();
  ContextResult opened = open_context(arguments[0]);
  if (const auto* error = std::get_if<ContextError>(&opened))
    return complain(kUnavailable, error->message);
  GlContext& context = *std::get<std::unique_ptr<GlContext>>(opened);
  SceneRenderer renderer(context);
  RendererInfo info = renderer.info();
  if (std::string doubt = doubt_of_driver(driver, info.device); !doubt.empty())
    return complain(kUnavailable, doubt);
  if (std::string stack = stack_of_driver(driver); !stack.empty()) info.traits["stack"] = stack;
  std::ios::sync_with_stdio(false);
  if (is_bench) return serve_bench(renderer, output);
  return takes_messages ? serve_messages(renderer, info, output)
                        : serve_lines(renderer, info, output);
}

}  // namespace

}  // namespace edgecase

#ifdef __SANITIZE_ADDRESS__
// Drivers keep memory until the process ends. Reporting it would replace our exit status.
extern "C" const char* __asan_default_options() {
  return "detect_leaks=0";
}
#endif

int main(int argc, char** argv) {
  // What a scene took serves the next one: pages that the system gives anew are cleared first.
  mallopt(M_MMAP_THRESHOLD, 1 << 25);
  mallopt(M_TRIM_THRESHOLD, 1 << 26);
  return edgecase::run(argc, argv);
}
