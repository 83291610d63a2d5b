// SPDX-License-Identifier: MIT
//
// Who can have written a file: what sshd's StrictModes and git's safe.directory ask.
//
// A file is this user's word if nobody else but the superuser can write it, or put another in its
// place. So its owner and those of all folders on the way to it, and of every link there, are this
// user (the effective one) or the superuser, and no others may write any of them. Two things that
// others seem to be able to do they cannot:
//
// - The sticky bit of a folder, such as /tmp, keeps them from renaming what is not theirs. So it is
//   enough for the folders above, but not for the folder of the file itself, where programs and
//   outputs lie beside it.
// - A group of the owner's name in which nobody else is (Debian gives one to each user) lets nobody
//   else write, unless an access control list does.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace edgecase {

// Why others can write this file, or exchange it: "/tmp/x belongs to the user nobody". Empty: they
// cannot, or the path leads to nothing.
std::string how_others_can_write(const std::filesystem::path& file);

// The first link on the way to a file that belongs to neither this user nor the superuser: where it
// leads others decide. Empty: there is none.
std::filesystem::path link_of_others(const std::filesystem::path& file);

// The absolute path without links that the kernel reaches by `path`, whose end may be missing.
// Nothing where links lead in a circle.
std::optional<std::filesystem::path> without_links(const std::filesystem::path& path);

}  // namespace edgecase
