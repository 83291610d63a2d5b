// SPDX-License-Identifier: MIT
//
// edgecase-webgl: the worker program of the renderers webgl:chromium, webgl:chromium-gl and
// webgl:firefox.
//
//   edgecase-webgl chromium|chromium-gl|firefox
//
// It speaks the protocol of reference/PROTOCOL.md in lines. It starts the browser with a page
// (reference/web) that asks it for each request over the loopback interface, and brings the answer.
// If the browser is missing or has no WebGL 2, it prints a sentence to standard error and exits
// with status 3; if the browser ends or loses its context, with status 4.
#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>

#include "reports/page.h"
#include "tools/edgecase_webgl/browser.h"
#include "tools/edgecase_webgl/loopback.h"

namespace edgecase {
namespace {

constexpr int kUsageError = 2;
constexpr int kUnavailable = 3;
constexpr int kEnded = 4;

// What the page sends first; anything else is why it cannot draw.
constexpr std::string_view kReady = "ready";

class Worker {
 public:
  std::string answer(const PageRequest& request) {
    if (request.path.empty()) return page();
    if (request.path == "lost") end(kEnded, request.body);
    if (request.path != "scene") return "";
    // A page that begins anew, as when a browser loads it again, has not answered yet.
    if (is_ready_ && request.body == kReady) return asked_;
    take(request.body);
    if (!std::getline(std::cin, asked_)) end(0, "");
    return asked_;
  }

  // Ends the browser, and us. Never returns.
  [[noreturn]] void end(int status, const std::string& sentence) {
    static std::mutex once;
    once.lock();
    if (!sentence.empty()) std::fprintf(stderr, "edgecase-webgl: %s\n", sentence.c_str());
    std::fflush(nullptr);
    _exit(status);
  }

  void run(const std::string& name) {
    browser_ = std::make_unique<Browser>();
    const auto command = find_browser(name, browser_->folder(), server_.url());
    if (const auto* sentence = std::get_if<std::string>(&command)) end(kUnavailable, *sentence);
    browser_->start(std::get<BrowserCommand>(command));
    std::thread([this] {
      browser_->wait();
      end(kEnded, "the browser ended");
    }).detach();
    server_.serve([this](const PageRequest& request) { return answer(request); });
  }

 private:
  static std::string page() {
    std::string page(kWebBeforeLoads);
    page += "; connect-src 'self'";
    page += kWebBeforeData;
    page += R"({"mode":"serve"})";
    page += kWebBeforeBlocks;
    page += kWebAfterBlocks;
    return page;
  }

  // The page first says whether it can draw; each further line is an answer.
  void take(const std::string& line) {
    if (is_ready_) {
      std::cout << line << std::endl;
      return;
    }
    is_ready_ = true;
    if (line != kReady) end(kUnavailable, line);
  }

  Loopback server_;
  std::unique_ptr<Browser> browser_;
  bool is_ready_ = false;
  std::string asked_;  // the latest request
};

int run(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: edgecase-webgl chromium|chromium-gl|firefox\n");
    return kUsageError;
  }
  // The thread that waits for the browser may outlive this function, so the worker is never freed.
  static auto* worker = new Worker;
  try {
    worker->run(argv[1]);
  } catch (const std::runtime_error& error) {
    worker->end(kUnavailable, error.what());
  }
  return 0;
}

}  // namespace
}  // namespace edgecase

int main(int argc, char** argv) {
  return edgecase::run(argc, argv);
}
