// SPDX-License-Identifier: MIT
//
// A recording: what one renderer answered to many scenes, in a file that can be asked instead of
// it.
//
//   edgecase-recording 1        the version, and a line break
//   {"renderer": ...}           who answered, a line of JSON
//   blocks                      of cases in the order of their ids, see block.h
//   index                       deflated JSON: sizes and checksums of all before it; of each block
//                               the ids of its cases and their scenes' digests
//   0000000000012345 89abcdef   the index's size and checksum, of fixed length, and a line break
//
// Answers are whole, and need nothing beside the file. The same answers make the same bytes. Every
// byte of the file is under a checksum that is looked at as it is opened: one that is cut off or
// was altered is refused as a whole.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "model/renderer.h"

namespace edgecase {

// Version of the format; no other is read.
constexpr int kRecordingVersion = 1;

// Who answered, and what to.
struct RecordingHead {
  std::string tool;         // the program that recorded: "edgecase 0.1.0"
  RendererInfo renderer;    // as it was when it answered; its name is the renderer's own
  bool is_complete = true;  // false: recording was interrupted, and cases are missing
};

// Some neighbouring cases with their outcomes, packed.
struct RecordedBlock {
  struct Scene {
    std::string id;
    std::string digest;  // of the scene (wire/request_line.h)
  };
  std::vector<Scene> scenes;
  std::string bytes;
};

// Packs stored lines (below), as many as there are scenes.
RecordedBlock make_block(std::vector<RecordedBlock::Scene> scenes,
                         const std::vector<std::string>& lines);

// The whole file.
std::string recording_bytes(const RecordingHead& head, const std::vector<RecordedBlock>& blocks);

// A recording that was opened. It stays readable while the file is replaced by another.
class Recording {
 public:
  // Where a case is.
  struct Place {
    std::string digest;
    std::size_t block = 0;
    std::size_t line = 0;  // within the block
  };

  // Reads and checks the whole file. One sentence that names the file, what is wrong and the
  // remedy, otherwise.
  static std::variant<Recording, std::string> open(const std::filesystem::path& path);
  // Who answered: the head alone, whose checksum is not looked at.
  static std::variant<RecordingHead, std::string> open_head(const std::filesystem::path& path);

  const RecordingHead& head() const { return head_; }
  std::size_t size() const { return places_.size(); }
  // The place of a case, or null.
  const Place* find(const std::string& id) const;
  // The lines of a block. Throws std::runtime_error where it is none.
  std::vector<std::string> lines(std::size_t block) const;

 private:
  struct Stretch {
    std::size_t begin = 0;
    std::size_t size = 0;
  };

  static Recording read(std::string bytes);

  std::string bytes_;
  RecordingHead head_;
  std::vector<Stretch> blocks_;
  std::map<std::string, Place> places_;
};

}  // namespace edgecase

namespace edgecase::recording {

// What a recording keeps of a case: a line as it comes from a renderer (reference/PROTOCOL.md), or
// the reason why there is none. The scene's digest stands in the recording's index.

// A line of JSON without a line break.
std::string stored_line(const Outcome& outcome);

// The inverse, as strict as answers are read; what is not an outcome of this scene is a Failure
// that says so.
Outcome outcome_of(const std::string& line, const Scene& scene);

}  // namespace edgecase::recording
