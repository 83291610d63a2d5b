// SPDX-License-Identifier: MIT
//
// SHA-256 (FIPS 180-4): a digest for which nobody can make a second text.
#pragma once

#include <string>
#include <string_view>

namespace edgecase {

// 64 hexadecimal digits, small letters.
std::string sha256(std::string_view text);

}  // namespace edgecase
