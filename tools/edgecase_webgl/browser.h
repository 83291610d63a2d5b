// SPDX-License-Identifier: MIT
//
// A browser without a window, started for one page and ended with this process.
#pragma once

#include <sys/types.h>

#include <string>
#include <variant>
#include <vector>

namespace edgecase {

// How a browser is started.
struct BrowserCommand {
  std::vector<std::string> argv;   // argv[0]: a path
  std::vector<std::string> files;  // of its profile: name, contents, name, contents, ...
};

// The browser of this name, "chromium", "chromium-gl" or "firefox", for a page at `url`, with its
// profile in `folder`. Otherwise one sentence: it is not installed, or there is no such name.
//
// Every user of the machine can read a process's arguments, so `url` stands in none: the browser
// begins with a page in its profile, which sends it there.
std::variant<BrowserCommand, std::string> find_browser(const std::string& name,
                                                       const std::string& folder,
                                                       const std::string& url);

class Browser {
 public:
  // Makes a folder for the profile, which no other user can enter. However this process ends,
  // another one then removes the folder, and ends what is left of our process group, where all that
  // a browser starts is. Call it before there are threads. Throws std::runtime_error if it cannot.
  Browser();

  const std::string& folder() const { return folder_; }
  // Starts it. Throws std::runtime_error if it cannot.
  void start(const BrowserCommand& command);
  // Waits until it has ended.
  void wait() const;

 private:
  std::string folder_;
  pid_t pid_ = -1;
};

}  // namespace edgecase
