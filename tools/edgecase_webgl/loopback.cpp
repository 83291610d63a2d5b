// SPDX-License-Identifier: MIT
#include "tools/edgecase_webgl/loopback.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <optional>
#include <random>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "wire/request_line.h"

namespace edgecase {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::string_view kHeadEnd = "\r\n\r\n";
constexpr std::size_t kMostOfHead = std::size_t{1} << 14;  // bytes
// A browser has at most six to one server.
constexpr std::size_t kMostConnections = 16;
// For the head of somebody who has shown nothing, and for the next bytes of our browser.
constexpr std::chrono::seconds kPatience{5};
constexpr std::chrono::seconds kPatienceWithBrowser{60};

std::string make_secret() {
  std::random_device device;
  std::string secret;
  for (int i = 0; i < 4; ++i) secret += fmt::format("{:08x}", device());
  return secret;
}

void send_refusal(int socket, std::string_view status) {
  const std::string text =
      fmt::format("HTTP/1.1 {}\r\nContent-Length: 0\r\nConnection: close\r\n\r\n", status);
  // Whoever does not take it is not waited for.
  send(socket, text.data(), text.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
}

bool send_all(int socket, std::string_view text) {
  while (!text.empty()) {
    const ssize_t sent = send(socket, text.data(), text.size(), MSG_NOSIGNAL);
    if (sent <= 0) return false;
    text.remove_prefix(static_cast<std::size_t>(sent));
  }
  return true;
}

}  // namespace

struct Loopback::Connection {
  explicit Connection(int number) : socket(number), late(Clock::now() + kPatience) {
    const int on = 1;
    setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &on, sizeof(on));
    const timeval patience{kPatienceWithBrowser.count(), 0};
    setsockopt(socket, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof(patience));
  }
  ~Connection() { close(socket); }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  int socket;
  bool has_bytes = false;    // to be received
  bool is_admitted = false;  // has shown what our browser knows
  std::string received;
  std::optional<AdmittedRequest> request;  // whose body is being received
  // When it is closed; nothing for the browser's between two requests.
  std::optional<Clock::time_point> late;
};

Loopback::Loopback() {
  socket_ = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof(address);
  auto* any = reinterpret_cast<sockaddr*>(&address);
  if (socket_ < 0 || bind(socket_, any, size) != 0 ||
      listen(socket_, static_cast<int>(kMostConnections)) != 0 ||
      getsockname(socket_, any, &size) != 0)
    throw std::runtime_error("no port of this machine can be had");
  admission_ = {fmt::format("127.0.0.1:{}", ntohs(address.sin_port)), make_secret(), "",
                kMaxLineLength};
}

Loopback::~Loopback() {
  close(socket_);
}

std::string Loopback::url() const {
  return fmt::format("http://{}/{}/", admission_.host, admission_.secret);
}

// Waits until there is something to do, and notes where.
void Loopback::wait() {
  std::vector<pollfd> waiting = {{socket_, POLLIN, 0}};
  auto next = Clock::time_point::max();
  for (const Connection& one : connections_) {
    waiting.push_back({one.socket, POLLIN, 0});
    next = std::min(next, one.late.value_or(next));
  }
  // Rounded up, so that what is late then is late.
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(next - Clock::now()).count();
  const bool is_endless = next == Clock::time_point::max();
  poll(waiting.data(), waiting.size(), is_endless ? -1 : static_cast<int>(std::max(left, {})));
  somebody_waits_ = waiting.front().revents != 0;
  std::size_t i = 1;
  for (Connection& one : connections_) one.has_bytes = waiting[i++].revents != 0;
}

// The oldest that has shown nothing makes room; where all are the browser's, nobody comes in.
void Loopback::accept_one() {
  const int number = accept4(socket_, nullptr, nullptr, SOCK_CLOEXEC);
  if (number < 0) return;
  connections_.emplace_back(number);
  if (connections_.size() > kMostConnections)
    connections_.erase(std::ranges::find(connections_, false, &Connection::is_admitted));
}

// Takes what has come, and answers what is whole. False: the connection is to be closed.
bool Loopback::advance(Connection& connection, const PageAnswer& answer) {
  char part[1 << 16];
  const ssize_t count = recv(connection.socket, part,
                             connection.is_admitted ? sizeof(part) : kMostOfHead, MSG_DONTWAIT);
  if (count <= 0) return count < 0 && (errno == EAGAIN || errno == EINTR);
  connection.received.append(part, static_cast<std::size_t>(count));
  if (connection.is_admitted) connection.late = Clock::now() + kPatienceWithBrowser;
  while (connection.request || connection.received.find(kHeadEnd) != std::string::npos) {
    if (!connection.request && !take_head(connection)) return false;
    if (connection.received.size() < connection.request->length) return true;
    PageRequest request{connection.request->path, {}};
    std::string rest = connection.received.substr(connection.request->length);
    connection.received.resize(connection.request->length);
    request.body = std::exchange(connection.received, std::move(rest));
    if (!respond(connection, answer(request))) return false;
    connection.request.reset();
    connection.late.reset();
  }
  if (connection.received.size() <= kMostOfHead) return true;
  send_refusal(connection.socket, "431 Request Header Fields Too Large");
  return false;
}

// Reads the head of what was received; false, after a refusal, where the request is not admitted.
bool Loopback::take_head(Connection& connection) {
  const std::size_t end = connection.received.find(kHeadEnd);
  const auto head = parse_head(std::string_view(connection.received).substr(0, end));
  std::variant<AdmittedRequest, std::string> admitted = "400 Bad Request";
  if (head && end <= kMostOfHead) admitted = admit(*head, admission_);
  if (const auto* refusal = std::get_if<std::string>(&admitted)) {
    send_refusal(connection.socket, *refusal);
    return false;
  }
  connection.received.erase(0, end + kHeadEnd.size());
  connection.request = std::get<AdmittedRequest>(admitted);
  connection.is_admitted = true;
  connection.late = Clock::now() + kPatienceWithBrowser;
  return true;
}

bool Loopback::respond(Connection& connection, const std::string& text) {
  const bool is_page = connection.request->path.empty();
  std::string cookie;
  if (is_page && admission_.session.empty()) {
    admission_.session = make_secret();
    cookie = fmt::format("Set-Cookie: {}={}; Path=/{}/; HttpOnly; SameSite=Lax\r\n", kSessionCookie,
                         admission_.session, admission_.secret);
  }
  const std::string head = fmt::format(
      "HTTP/1.1 {}\r\nContent-Type: {}; charset=utf-8\r\nContent-Length: {}\r\n"
      "Cache-Control: no-store\r\n{}\r\n",
      text.empty() ? "404 Not Found" : "200 OK", is_page ? "text/html" : "text/plain", text.size(),
      cookie);
  return send_all(connection.socket, head) && send_all(connection.socket, text);
}

void Loopback::serve(const PageAnswer& answer) {
  for (;;) {
    wait();
    // What came in time is taken before what is late is closed.
    std::erase_if(connections_, [&](Connection& one) {
      return (one.has_bytes && !advance(one, answer)) || (one.late && *one.late <= Clock::now());
    });
    if (somebody_waits_) accept_one();
  }
}

}  // namespace edgecase
