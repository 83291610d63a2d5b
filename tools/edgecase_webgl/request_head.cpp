// SPDX-License-Identifier: MIT
#include "tools/edgecase_webgl/request_head.h"

#include <algorithm>
#include <cctype>
#include <charconv>

namespace edgecase {
namespace {

constexpr std::string_view kLineEnd = "\r\n";

// Takes as long wherever two texts of one length differ, so that no part of a secret can be guessed
// from times.
bool is_same(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  unsigned differing = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    differing |=
        static_cast<unsigned char>(a[i]) ^ static_cast<unsigned>(static_cast<unsigned char>(b[i]));
  return differing == 0;
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t";
  const std::size_t begin = std::min(text.find_first_not_of(kBlanks), text.size());
  text.remove_prefix(begin);
  return text.substr(0, text.find_last_not_of(kBlanks) + 1);
}

std::string small_letters(std::string_view text) {
  std::string small(text);
  std::ranges::transform(small, small.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return small;
}

// The text before `end`, which is taken from `rest`; all of it where that has no `end`.
std::string_view take_until(std::string_view& rest, std::string_view end) {
  const std::size_t at = std::min(rest.find(end), rest.size());
  const std::string_view taken = rest.substr(0, at);
  rest.remove_prefix(std::min(at + end.size(), rest.size()));
  return taken;
}

std::string_view field(const RequestHead& head, const char* name) {
  const auto found = head.fields.find(name);
  return found == head.fields.end() ? std::string_view() : found->second;
}

bool shows_session(const RequestHead& head, const std::string& session) {
  std::string_view cookies = field(head, "cookie");
  while (!cookies.empty()) {
    std::string_view value = trimmed(take_until(cookies, ";"));
    if (take_until(value, "=") == kSessionCookie && is_same(value, session)) return true;
  }
  return false;
}

// The length of the body; nothing where it is not told as one number.
std::optional<std::size_t> length_of_body(const RequestHead& head) {
  if (head.fields.contains("transfer-encoding")) return std::nullopt;
  if (!head.fields.contains("content-length")) return 0;
  const std::string_view text = field(head, "content-length");
  std::size_t length = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), length);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return length;
}

// Only the page is asked for without an origin: by the browser itself.
bool has_origin(const RequestHead& head, const Admission& admission, bool is_page) {
  if (!head.fields.contains("origin")) return is_page;
  return field(head, "origin") == "http://" + admission.host;
}

}  // namespace

std::optional<RequestHead> parse_head(std::string_view text) {
  RequestHead head;
  std::string_view line = take_until(text, kLineEnd);
  head.method = take_until(line, " ");
  head.target = take_until(line, " ");
  if (head.target.empty() || line != "HTTP/1.1") return std::nullopt;
  while (!text.empty()) {
    line = take_until(text, kLineEnd);
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos || colon == 0) return std::nullopt;
    const bool is_new =
        head.fields.emplace(small_letters(line.substr(0, colon)), trimmed(line.substr(colon + 1)))
            .second;
    if (!is_new) return std::nullopt;
  }
  return head;
}

std::variant<AdmittedRequest, std::string> admit(const RequestHead& head,
                                                 const Admission& admission) {
  // To whom lacks the secret, nothing is here.
  const std::size_t front = admission.secret.size() + 2;
  const std::string_view target = head.target;
  if (!is_same(target.substr(0, front), "/" + admission.secret + "/")) return "404 Not Found";
  const std::string_view path = target.substr(front);
  const bool is_page = path.empty();
  if (field(head, "host") != admission.host || !has_origin(head, admission, is_page))
    return "403 Forbidden";
  if (head.method != (is_page ? "GET" : "POST")) return "405 Method Not Allowed";
  const bool is_first = is_page && admission.session.empty();
  if (!is_first && (admission.session.empty() || !shows_session(head, admission.session)))
    return "403 Forbidden";
  const auto length = length_of_body(head);
  if (!length) return "411 Length Required";
  if (*length > (is_page ? 0 : admission.most_of_body)) return "413 Content Too Large";
  return AdmittedRequest{std::string(path), *length};
}

}  // namespace edgecase
