// SPDX-License-Identifier: MIT
//
// A server for one page on this machine: just enough of HTTP/1.1 (RFC 9112) for a browser's fetch.
//
// It listens on the loopback interface alone, and answers the one browser that was given its secret
// address (request_head.h). Whoever else connects costs little: one thread serves all, a connection
// that has shown nothing yet holds at most a head's bytes, has a few seconds, and makes room for
// newer ones.
#pragma once

#include <cstdint>
#include <functional>
#include <list>
#include <string>

#include "tools/edgecase_webgl/request_head.h"

namespace edgecase {

struct PageRequest {
  std::string path;  // behind the secret: "" or "scene"
  std::string body;
};

// Returns an HTML page for the path "", and otherwise any text. An empty text is "not found".
using PageAnswer = std::function<std::string(const PageRequest&)>;

class Loopback {
 public:
  // Throws std::runtime_error if no port can be had.
  Loopback();
  ~Loopback();
  Loopback(const Loopback&) = delete;
  Loopback& operator=(const Loopback&) = delete;

  // "http://127.0.0.1:PORT/SECRET/". Whoever knows it first gets the page.
  std::string url() const;

  // Serves for ever. While `answer` waits, nothing else is served.
  [[noreturn]] void serve(const PageAnswer& answer);

 private:
  struct Connection;

  void wait();
  void accept_one();
  bool advance(Connection& connection, const PageAnswer& answer);
  bool take_head(Connection& connection);
  bool respond(Connection& connection, const std::string& text);

  int socket_ = -1;
  Admission admission_;
  bool somebody_waits_ = false;        // to be connected
  std::list<Connection> connections_;  // the oldest first
};

}  // namespace edgecase
