// SPDX-License-Identifier: MIT
//
// edgecase-gl: the worker program of the OpenGL renderers.
//
//   edgecase-gl CONTEXT [--expect-driver NAME]
//   edgecase-gl --devices
//
// CONTEXT is osmesa, egl-surfaceless or egl-device:N, or of OpenGL ES egl-es-surfaceless or
// egl-es-device:N. With --devices it prints how many devices EGL lists, and ends.
//
// It speaks the protocol of reference/PROTOCOL.md: one scene per line on standard input, one answer
// per line on standard output, until its input ends. Which driver draws is decided by environment
// variables that its parent sets; --expect-driver makes sure of it, see driver_proof.h. A context
// that cannot be had, or another driver than the expected one, is a sentence on standard error and
// exit status 3.
#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <memory>
#include <string>

#include "reference/driver_proof.h"
#include "reference/egl_context.h"
#include "reference/gl_context.h"
#include "reference/scene_renderer.h"
#include "wire/answer_line.h"
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

// The standard output that the parent reads. Whatever a driver prints goes to standard error.
std::FILE* take_standard_output() {
  const int copy = dup(STDOUT_FILENO);
  if (copy < 0 || dup2(STDERR_FILENO, STDOUT_FILENO) < 0) return nullptr;
  return fdopen(copy, "w");
}

bool write_line(std::FILE* output, const std::string& line) {
  return std::fwrite(line.data(), 1, line.size(), output) == line.size() &&
         std::fputc('\n', output) != EOF && std::fflush(output) == 0;
}

std::string line_of(const Request& request, const Outcome& outcome, const RendererInfo* claims) {
  if (const auto* failure = std::get_if<Failure>(&outcome))
    return refusal_line(request.digest, failure->reason, claims);
  const Rendering& rendering = std::get<Rendering>(outcome);
  return request.coverage_only ? coverage_line(request.digest, rendering, claims)
                               : answer_line(request.digest, rendering, claims);
}

int serve(SceneRenderer& renderer, const RendererInfo& info, std::FILE* output) {
  // The parent needs to hear only once who answers.
  const RendererInfo* claims = &info;
  for (std::string line; std::getline(std::cin, line);) {
    const auto parsed = parse_request(line);
    if (const auto* error = std::get_if<WireError>(&parsed))
      return complain(kUsageError, "bad request: " + error->message);
    Request request = std::get<Request>(parsed);
    // Runs of pixels tell neither samples, nor passes, nor which fragments pass their tests.
    if (request.scene.target.samples > 1 || !request.scene.supersampling.empty() ||
        has_fragment_operations(request.scene))
      request.coverage_only = false;
    const Outcome outcome = renderer.render(request.scene, request.coverage_only);
    const auto* failure = std::get_if<Failure>(&outcome);
    if (failure != nullptr && failure->kind == FailureKind::crashed)
      return complain(kContextLost, failure->reason);
    if (!write_line(output, line_of(request, outcome, claims)))
      return complain(kUsageError, "the parent reads no more");
    claims = nullptr;
  }
  return 0;
}

int print_devices() {
  std::FILE* output = take_standard_output();
  if (output == nullptr) return complain(kUsageError, "there is no standard output");
  return write_line(output, std::to_string(count_egl_devices())) ? 0 : kUsageError;
}

int run(int argc, char** argv) {
  const bool expects = argc == 4 && std::string(argv[2]) == "--expect-driver";
  if (argc != 2 && !expects)
    return complain(kUsageError,
                    "usage: edgecase-gl osmesa|egl-surfaceless|egl-device:N|egl-es-surfaceless|"
                    "egl-es-device:N [--expect-driver NAME], or edgecase-gl --devices");
  if (std::string(argv[1]) == "--devices") return print_devices();
  const std::string driver = expects ? argv[3] : "";
  if (std::string missing = missing_for_driver(driver); !missing.empty())
    return complain(kUnavailable, missing);
  std::FILE* output = take_standard_output();
  if (output == nullptr) return complain(kUsageError, "there is no standard output");
  ContextResult opened = open_context(argv[1]);
  if (const auto* error = std::get_if<ContextError>(&opened))
    return complain(kUnavailable, error->message);
  GlContext& context = *std::get<std::unique_ptr<GlContext>>(opened);
  SceneRenderer renderer(context);
  RendererInfo info = renderer.info();
  if (std::string doubt = doubt_of_driver(driver, info.device); !doubt.empty())
    return complain(kUnavailable, doubt);
  if (std::string stack = stack_of_driver(driver); !stack.empty()) info.traits["stack"] = stack;
  std::ios::sync_with_stdio(false);
  return serve(renderer, info, output);
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
  return edgecase::run(argc, argv);
}
