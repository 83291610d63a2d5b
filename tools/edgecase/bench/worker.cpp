// SPDX-License-Identifier: MIT
#include "tools/edgecase/bench/worker.h"

#include <fmt/format.h>

#include <chrono>
#include <utility>

#include "run/renderers.h"

namespace edgecase {
namespace {

constexpr const char* kBenchOption = "--bench";
constexpr std::chrono::minutes kPatience{10};
constexpr std::size_t kLongestAnswer = std::size_t{1} << 30;

}  // namespace

std::variant<std::unique_ptr<BenchWorker>, std::string> BenchWorker::start(
    const std::string& renderer) {
  auto found = find_renderer(renderer, worker_directory());
  if (auto* unknown = std::get_if<UnknownRenderer>(&found)) return std::move(unknown->message);
  ProcessSpec& spec = std::get<ProcessSpec>(found);
  if (!spec.takes_messages)
    return fmt::format("'{}' is not one of our own workers, which alone can be timed", renderer);
  spec.command.argv.push_back(kBenchOption);
  auto started = ChildProcess::start(spec.command);
  if (auto* error = std::get_if<std::string>(&started)) return std::move(*error);
  return std::unique_ptr<BenchWorker>(
      new BenchWorker(std::move(std::get<std::unique_ptr<ChildProcess>>(started))));
}

BenchAnswer BenchWorker::ask(const BenchRequest& request) {
  child_->send(bench_request_message(request));
  std::string_view bytes;
  const auto status =
      child_->receive(bytes, kLongestAnswer, ChildProcess::Clock::now() + kPatience);
  if (status != ChildProcess::Status::answered)
    return {"the worker does not answer: " + child_->error_output(), 0, 0, {}};
  auto parsed = parse_bench_answer(bytes);
  if (const auto* error = std::get_if<WireError>(&parsed)) return {error->message, 0, 0, {}};
  return std::get<BenchAnswer>(std::move(parsed));
}

}  // namespace edgecase
