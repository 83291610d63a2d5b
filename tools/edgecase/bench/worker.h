// SPDX-License-Identifier: MIT
//
// BenchWorker: a worker of an OpenGL renderer that reports how long it takes to draw scenes, with
// the same program, context and environment as in a run.
#pragma once

#include <memory>
#include <string>
#include <variant>

#include "processes/child_process.h"
#include "wire/message.h"

namespace edgecase {

class BenchWorker {
 public:
  // `renderer`: one of our workers', as the command line names it. Starts it, or returns the reason
  // for failing.
  static std::variant<std::unique_ptr<BenchWorker>, std::string> start(const std::string& renderer);

  // The worker's answer, or a problem if there is none within ten minutes.
  BenchAnswer ask(const BenchRequest& request);

 private:
  explicit BenchWorker(std::unique_ptr<ChildProcess> child) : child_(std::move(child)) {}

  std::unique_ptr<ChildProcess> child_;
};

}  // namespace edgecase
