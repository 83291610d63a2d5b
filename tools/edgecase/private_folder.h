// SPDX-License-Identifier: MIT
//
// Folders and small files that only this user can have written: what is kept there from run to run
// may be believed.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>

namespace edgecase {

// The folder edgecase/NAME in the user's folder for caches (processes/shader_cache.h), made if it
// is missing: mode 0700, of the effective user. Otherwise a sentence that says why there is none,
// and what to do. `name`: one name, without a slash.
std::variant<std::filesystem::path, std::string> private_folder(const std::string& name);

// What a file in such a folder holds. Nothing where it is missing, is no regular file, belongs to
// another user, may be read or written by others, or has more than `most` bytes.
std::optional<std::string> read_private_file(const std::filesystem::path& path, std::size_t most);

// Writes such a file as a whole: mode 0600, under another name first, so that no reader and no
// crash sees a part of it. An existing file is replaced, or, with Existing::kept, stays as it is.
// False where the file could not be written, or an existing one was kept.
enum class Existing { replaced, kept };
bool write_private_file(const std::filesystem::path& path, const std::string& text,
                        Existing existing = Existing::replaced);

}  // namespace edgecase
