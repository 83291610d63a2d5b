// SPDX-License-Identifier: MIT
//
// Loads a case file: JSON to Cases with complete Scenes, or all faults of the file.
//
// A file stands for one case or, with "sweep" and "variants", for all combinations of the sweep and
// all images of each.
//
// Defaults: flat interpolation with the last vertex provoking; a target with one sample and format
// rgba8 that is a framebuffer object; a viewport that lets OpenGL receive exact coordinates
// (casefile/scene/viewport.h); colours derived from the case's id, so that no two cases share their
// right answer (salted_clear and salted_primitive of casefile/scene/scene_reader.h).
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/case.h"

namespace edgecase {

// The suite: the case files that paths refer to, and their ids.
//
// An id must not depend on how a case was reached, since known faults refer to it and colours are
// derived from it. So it is relative to the nearest folder named "cases" at or above the file's
// folder. Only if there is none, it is relative to the given folder or, for a single file, to the
// file's own folder.

struct CaseFile {
  std::string file;  // path, as reached from the given one; a text takes a tenth of a path's memory
  std::string id;    // path without suffix, with '/'
};

struct FoundCases {
  std::vector<CaseFile> cases;          // sorted by id, each file once
  std::vector<Diagnostic> diagnostics;  // missing or unreadable paths, equal ids
};

// Expands files and folders. Folders are searched to any depth, without following links to folders,
// for *.json except *.schema.json. Hidden folders and folders named "known", "policies", "profiles"
// or "galleries" are skipped. Never throws.
FoundCases find_cases(std::span<const std::filesystem::path> paths);

// Whether the path of a case, policy, profile or file of known faults leads out of its suite by a
// symbolic link: out of the nearest folder named "cases" round it or, if there is none, of its own
// folder. What a message quotes of such a file could be anybody's secret. A link to a file of the
// same name in another folder "cases" does not lead out, nor does one that leads nowhere.
bool leads_out_of_suite(const std::filesystem::path& file);
constexpr const char* kLeadsOut = "it is a link that leads out of the suite";
constexpr const char* kLeadsOutRemedy = "put the file itself in its place";

struct LoadedCases {
  std::vector<Case> cases;              // empty exactly if there are diagnostics
  std::vector<Diagnostic> diagnostics;  // all faults of the file, in order of lines
  std::vector<Diagnostic> notes;  // no faults, but the numbers as which "~" numerals were read
};

// Reads and checks a file. `id` is the file's id (see casefile/loader.h), with which the ids of its
// cases begin. `known_rules`: ids that "rules" may name; empty: any. Never throws because of the
// file's content.
LoadedCases load_cases(const std::filesystem::path& file, const std::string& id,
                       std::span<const std::string> known_rules = {});

// The same for a text; `file` names it in messages, and coverage files lie in its folder.
LoadedCases load_cases_text(const std::string& text, const std::filesystem::path& file,
                            const std::string& id, std::span<const std::string> known_rules = {});

// A case by its id, and by what distinguishes it within its file (Case).
struct CaseName {
  std::string id;
  std::vector<std::string> parts;
};

struct FileOutline {
  std::vector<CaseName> names;  // of all cases, in the order of load_cases()
  Case first;                   // the first of them
};

// What a file stands for, in a small part of the time that load_cases() takes, since only the first
// case is read. Nothing if that much shows a fault, which load_cases() tells; the other cases may
// have faults, too.
std::optional<FileOutline> outline_cases(const std::filesystem::path& file, const std::string& id,
                                         std::span<const std::string> known_rules = {});

}  // namespace edgecase
