// SPDX-License-Identifier: MIT
//
// A server for one page on this machine: just enough of HTTP/1.1 (RFC 9112) for a browser's fetch.
//
// It listens on the loopback interface alone, and answers nothing but addresses below a random
// path, so that no other page or user can ask it.
#pragma once

#include <functional>
#include <string>

namespace edgecase {

struct PageRequest {
  std::string path;  // behind the random part: "" or "scene"
  std::string body;
};

class Loopback {
 public:
  // Throws std::runtime_error if no port can be had.
  Loopback();

  // "http://127.0.0.1:PORT/SECRET/".
  const std::string& url() const { return url_; }

  // Serves for ever, with a thread for each connection. `answer` is called from any of them; it
  // returns an HTML page for the path "", and otherwise any text. An empty text is "not found".
  [[noreturn]] void serve(const std::function<std::string(const PageRequest&)>& answer);

 private:
  void talk(int connection, const std::function<std::string(const PageRequest&)>& answer) const;

  int socket_ = -1;
  std::string secret_;
  std::string url_;
};

}  // namespace edgecase
