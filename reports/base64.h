// SPDX-License-Identifier: MIT
//
// Bytes as text: base64 (RFC 4648, section 4). A page holds its data so.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace edgecase {

// Padded with "=" to a multiple of four characters.
std::string to_base64(const std::vector<std::uint8_t>& bytes);

// The inverse. Throws std::runtime_error for any other text.
std::vector<std::uint8_t> from_base64(std::string_view text);

}  // namespace edgecase
