// SPDX-License-Identifier: MIT
//
// Recording: every case of a suite rendered by one renderer, and its answers packed for a file.
//
// Cases are cut beforehand into blocks of about the same work, so that the file is the same
// whatever the number of threads. Each thread drives a renderer of its own, and packs what it
// renders.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <string>

#include "model/renderer.h"
#include "run/renderers.h"
#include "run/selection.h"

namespace edgecase {

struct RecordOptions {
  std::string tool;      // the program that records: "edgecase 0.1.0"
  std::string renderer;  // a name that make_renderer knows
  RendererOptions renderer_options;
  int jobs = 1;                                            // threads, at least 1
  std::function<void(std::size_t, std::size_t)> progress;  // done, total; from any thread; or empty
  // Becomes true when recording should end; put it into renderer_options as well.
  const std::atomic<bool>* stop = nullptr;
};

struct Recorded {
  std::string bytes;  // of the file
  RendererInfo renderer;
  std::size_t cases = 0;     // in the file
  std::size_t failures = 0;  // of them, those without a rendering
  bool is_complete = true;
  // Why the renderer could not be started; then there is no use in the file. Empty: it could.
  std::string unavailable;
};

// Records. Cases that were left out when `stop` became true are not in the file.
Recorded record_suite(const Suite& suite, const RecordOptions& options);

}  // namespace edgecase
