// SPDX-License-Identifier: MIT
//
// BenchWorker: a worker of an OpenGL renderer that tells how long it takes with scenes. The same
// program, context and environment as in any run.
#pragma once

#include <memory>
#include <string>
#include <variant>

#include "run/child_process.h"
#include "wire/message.h"

namespace edgecase {

class BenchWorker {
 public:
  // `renderer`: as the command line names it, one that lives in our worker. Starts it, or says why
  // not.
  static std::variant<std::unique_ptr<BenchWorker>, std::string> start(const std::string& renderer);

  // What it answers; a problem where it does not within ten minutes.
  BenchAnswer ask(const BenchRequest& request);

 private:
  explicit BenchWorker(std::unique_ptr<ChildProcess> child) : child_(std::move(child)) {}

  std::unique_ptr<ChildProcess> child_;
};

}  // namespace edgecase
