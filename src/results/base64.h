// SPDX-License-Identifier: MIT
//
// Bytes as text of 64 characters (RFC 4648, section 4), padded.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace edgecase {

std::string to_base64(const std::vector<std::uint8_t>& bytes);

// The inverse. Throws std::runtime_error where `text` is anything else.
std::vector<std::uint8_t> from_base64(std::string_view text);

}  // namespace edgecase
