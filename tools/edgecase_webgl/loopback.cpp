// SPDX-License-Identifier: MIT
#include "tools/edgecase_webgl/loopback.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>
#include <random>
#include <stdexcept>
#include <string_view>
#include <thread>

namespace edgecase {
namespace {

constexpr std::size_t kMostOfHead = std::size_t{1} << 16;  // bytes
constexpr std::size_t kMostOfBody = std::size_t{1} << 30;
constexpr std::string_view kHeadEnd = "\r\n\r\n";

std::string make_secret() {
  std::random_device device;
  std::string secret;
  for (int i = 0; i < 4; ++i) secret += fmt::format("{:08x}", device());
  return secret;
}

// The value of a header, whose name is given in small letters; 0 if it is not there.
std::optional<std::size_t> length_of_body(std::string head) {
  std::ranges::transform(head, head.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  constexpr std::string_view kName = "\r\ncontent-length:";
  std::size_t at = head.find(kName);
  if (at == std::string::npos) return 0;
  at = head.find_first_not_of(' ', at + kName.size());
  std::size_t length = 0;
  const auto [end, error] = std::from_chars(head.data() + at, head.data() + head.size(), length);
  if (error != std::errc() || length > kMostOfBody) return std::nullopt;
  return length;
}

// One connection's bytes.
class Stream {
 public:
  explicit Stream(int connection) : connection_(connection) {}
  ~Stream() { close(connection_); }
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;

  // The next request's head and body; false at the connection's end, or if it is not HTTP.
  bool read(std::string& head, std::string& body) {
    std::size_t end = std::string::npos;
    while ((end = received_.find(kHeadEnd)) == std::string::npos)
      if (received_.size() > kMostOfHead || !receive()) return false;
    head = received_.substr(0, end + 2);
    received_.erase(0, end + kHeadEnd.size());
    const auto length = length_of_body(head);
    if (!length) return false;
    while (received_.size() < *length)
      if (!receive()) return false;
    body = received_.substr(0, *length);
    received_.erase(0, *length);
    return true;
  }

  bool write(std::string_view text) const {
    while (!text.empty()) {
      const ssize_t sent = send(connection_, text.data(), text.size(), MSG_NOSIGNAL);
      if (sent <= 0) return false;
      text.remove_prefix(static_cast<std::size_t>(sent));
    }
    return true;
  }

 private:
  bool receive() {
    char part[1 << 16];
    const ssize_t count = recv(connection_, part, sizeof(part), 0);
    if (count > 0) received_.append(part, static_cast<std::size_t>(count));
    return count > 0;
  }

  int connection_;
  std::string received_;
};

// "GET /SECRET/scene HTTP/1.1" -> "scene"; nothing without the secret.
std::optional<std::string> path_of(const std::string& head, const std::string& secret) {
  const std::size_t begin = head.find(' ');
  const std::size_t end = head.find(' ', begin + 1);
  if (begin == std::string::npos || end == std::string::npos) return std::nullopt;
  const std::string path = head.substr(begin + 1, end - begin - 1);
  const std::string front = "/" + secret + "/";
  if (!path.starts_with(front)) return std::nullopt;
  return path.substr(front.size());
}

}  // namespace

Loopback::Loopback() : secret_(make_secret()) {
  socket_ = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof(address);
  auto* any = reinterpret_cast<sockaddr*>(&address);
  if (socket_ < 0 || bind(socket_, any, size) != 0 || listen(socket_, SOMAXCONN) != 0 ||
      getsockname(socket_, any, &size) != 0)
    throw std::runtime_error("no port of this machine can be had");
  url_ = fmt::format("http://127.0.0.1:{}/{}/", ntohs(address.sin_port), secret_);
}

void Loopback::talk(int connection,
                    const std::function<std::string(const PageRequest&)>& answer) const {
  const int on = 1;
  setsockopt(connection, IPPROTO_TCP, TCP_NODELAY, &on, sizeof(on));
  Stream stream(connection);
  std::string head;
  PageRequest request;
  while (stream.read(head, request.body)) {
    const auto path = path_of(head, secret_);
    request.path = path.value_or("");
    const std::string text = path ? answer(request) : "";
    const std::string start = fmt::format(
        "HTTP/1.1 {}\r\nContent-Type: {}; charset=utf-8\r\nContent-Length: {}\r\n"
        "Cache-Control: no-store\r\n\r\n",
        text.empty() ? "404 Not Found" : "200 OK",
        path && path->empty() ? "text/html" : "text/plain", text.size());
    if (!stream.write(start) || !stream.write(text)) return;
  }
}

void Loopback::serve(const std::function<std::string(const PageRequest&)>& answer) {
  for (;;) {
    const int connection = accept4(socket_, nullptr, nullptr, SOCK_CLOEXEC);
    if (connection >= 0)
      std::thread([this, connection, &answer] { talk(connection, answer); }).detach();
  }
}

}  // namespace edgecase
