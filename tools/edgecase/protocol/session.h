// SPDX-License-Identifier: MIT
//
// ProtocolSession: a program behind `exec:` while it is examined, one request after another.
//
// Unlike ProcessRenderer, which tolerates as much as possible, it reports every departure from
// reference/PROTOCOL.md: the reply to each request, the number of starts, and unrequested output.
// It judges nothing.
#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <string>

#include "model/renderer.h"
#include "processes/child_process.h"

namespace edgecase {

// The reply to one request.
struct Reply {
  enum class Kind {
    rendering,  // an answer by the protocol
    refusal,    // "not_run"
    garbage,    // a line that is no answer to this request
    silence,    // no line: it ended, or did not answer in time
  };
  Kind kind = Kind::silence;
  std::string line;  // as received, without the line break
  std::string
      problem;  // of garbage and silence, a sentence without full stop; of a refusal, its reason
  Rendering rendering;
  int exit_status = -1;  // of silence: the status, if the program ended by itself
};

class ProtocolSession {
 public:
  // `patience`: the time for each answer, in addition to that of a start. `stop` may be null; once
  // it is true, every reply is silence.
  ProtocolSession(Command command, std::chrono::milliseconds patience,
                  const std::atomic<bool>* stop);

  // Starts the program; returns the reason for failing, or "". ask() starts it, too.
  std::string start();

  // Requests a scene under an id, as `edgecase run` does. Starts the program if it is not running.
  Reply ask(const std::string& id, const Scene& scene, bool coverage_only = false);
  // Sends any text as a request; the answer is read as one to `scene`, whose digest is `digest`.
  Reply ask_text(const std::string& request, const std::string& digest, const Scene& scene,
                 bool coverage_only = false);

  // The number of times that the program was started.
  int starts() const { return starts_; }
  // The running program, or null.
  ChildProcess* process() { return child_.get(); }
  // Ends the program; the next request starts it anew.
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
