// SPDX-License-Identifier: MIT
//
// ProtocolSession: a program behind `exec:` while it is examined, one request after another.
//
// ProcessRenderer makes the best of whatever a program does. Here every departure from
// reference/PROTOCOL.md is told instead: what came back for a request, line by line, how often the
// program had to be started, and what it wrote without being asked. It judges nothing.
#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <string>

#include "model/renderer.h"
#include "run/child_process.h"

namespace edgecase {

// What came of one request.
struct Reply {
  enum class Kind {
    rendering,  // an answer by the protocol
    refusal,    // "not_run"
    garbage,    // a line that is no answer to this request
    silence,    // no line: it ended, or did not answer in time
  };
  Kind kind = Kind::silence;
  std::string line;  // as it came, without the line break
  std::string
      problem;  // of garbage and silence, a sentence without full stop; of a refusal, its reason
  Rendering rendering;
  int exit_status = -1;  // of silence: where the program ended by itself with one
};

class ProtocolSession {
 public:
  // `patience`: for each answer, beside what a start may take. `stop` may be null; once it is true
  // every reply is silence.
  ProtocolSession(Command command, std::chrono::milliseconds patience,
                  const std::atomic<bool>* stop);

  // Why the program cannot be started, or "". Asking starts it, too.
  std::string start();

  // The scene under an id, as `edgecase run` asks. Starts the program if it is not running.
  Reply ask(const std::string& id, const Scene& scene, bool coverage_only = false);
  // Any text of a request; the answer is read as one to `scene`, whose digest is `digest`.
  Reply ask_text(const std::string& request, const std::string& digest, const Scene& scene,
                 bool coverage_only = false);

  // How often the program has been started.
  int starts() const { return starts_; }
  // The running program, or null.
  ChildProcess* process() { return child_.get(); }
  // Ends the program: the next request goes to a new one.
  void restart() { child_.reset(); }

 private:
  Reply silence(ChildProcess::Status status);

  Command command_;
  std::chrono::milliseconds patience_;
  const std::atomic<bool>* stop_;
  std::unique_ptr<ChildProcess> child_;
  int starts_ = 0;
};

}  // namespace edgecase
