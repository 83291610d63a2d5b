// SPDX-License-Identifier: MIT
#include "model/renderer.h"

#include <algorithm>

namespace edgecase {
namespace {

bool is_letter_or_digit(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

}  // namespace

Failure internal_failure(const std::string& id, const std::exception& thrown) {
  return {
      FailureKind::internal,
      "edgecase itself failed in the case " + id + " (" + thrown.what() +
          "), which is no fault of the renderer: please report it with the case and the answer"};
}

bool is_own_name(std::string_view name) {
  constexpr std::size_t kMost = 64;
  return !name.empty() && name.size() <= kMost && name != "exact" && is_letter_or_digit(name[0]) &&
         std::ranges::all_of(name, [](char c) {
           return is_letter_or_digit(c) || c == '.' || c == '-' || c == '_';
         });
}

const std::string& address_of(const RendererInfo& info) {
  const auto address = info.traits.find(kAddressTrait);
  return is_own_name(info.name) && address != info.traits.end() ? address->second : info.name;
}

std::string asked_as(const RendererInfo& info) {
  const std::string& address = address_of(info);
  return address == info.name ? address : info.name + "=" + address;
}

bool is_opengl(std::string_view address) {
  return address.starts_with("osmesa:") || address.starts_with("egl:") ||
         address.starts_with("egl-es:") || address.starts_with("webgl:");
}

const std::string& known_as(const RendererInfo& info) {
  const std::string* known = &address_of(info);
  const bool is_named = *known != info.name;
  const auto recorded = info.traits.find(kRecordedTrait);
  if (known->starts_with(kRecordingPrefix) && recorded != info.traits.end())
    known = &recorded->second;
  return is_named && !is_opengl(*known) ? info.name : *known;
}

}  // namespace edgecase
