// SPDX-License-Identifier: MIT
//
// The head of a request of HTTP/1.1 (RFC 9112), and whether it may be answered.
//
// Every program of this machine can connect to the loopback interface, whoever runs it, and so can
// every page in any browser here. All that tells ours from theirs stands in the head, so nothing
// of a body is read for anybody else:
//
// - the secret, the first part of the path, which only our browser was given;
// - Host, which is our address: a page of a site that lets its name resolve to 127.0.0.1 (DNS
//   rebinding) sends that name;
// - Origin, which is our address too, for all but the page itself;
// - the session, a cookie: the first browser that asks for the page gets it, and no other one.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace edgecase {

struct RequestHead {
  std::string method;
  std::string target;                         // "/SECRET/scene"
  std::map<std::string, std::string> fields;  // by name in small letters
};

// A head without the empty line at its end; nothing if it is none, or has a field twice.
std::optional<RequestHead> parse_head(std::string_view text);

// What a request has to show.
struct Admission {
  std::string host;  // "127.0.0.1:PORT"
  std::string secret;
  std::string session;       // empty: nobody has asked for the page yet
  std::size_t most_of_body;  // bytes
};

struct AdmittedRequest {
  std::string path;        // behind the secret: "" for the page, "scene"
  std::size_t length = 0;  // of the body, bytes
};

// The request, or the status line that refuses it: "404 Not Found".
std::variant<AdmittedRequest, std::string> admit(const RequestHead& head,
                                                 const Admission& admission);

// The name of the session's cookie.
constexpr std::string_view kSessionCookie = "session";

}  // namespace edgecase
