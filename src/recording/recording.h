// SPDX-License-Identifier: MIT
//
// A recording: one renderer's answers to many scenes, in a file that can stand in for the renderer.
//
//   edgecase-recording 1        the version, and a line break
//   {"renderer": ...}           who answered, a line of JSON
//   blocks                      of cases in the order of their ids, see block.h
//   index                       deflated JSON: sizes and checksums of all before it; of each block
//                               the ids of its cases and their scenes' digests
//   0000000000012345 89abcdef   the index's size and checksum, of fixed length, and a line break
//
// Answers are whole and need no other file. Equal answers give equal files. Checksums cover every
// byte of the file and are checked when it is opened: a truncated or altered file is refused as a
// whole.
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

// Version of the format; no other version is read.
constexpr int kRecordingVersion = 1;

// Who answered, and by which program it was recorded.
struct RecordingHead {
  std::string tool;         // the program that recorded: "edgecase 0.1.0"
  RendererInfo renderer;    // as it was when it answered, with the renderer's own name
  bool is_complete = true;  // false: recording was interrupted, and cases are missing
};

// Several neighbouring cases with their outcomes, packed.
struct RecordedBlock {
  struct Scene {
    std::string id;
    std::string digest;  // of the scene (wire/request_line.h)
  };
  std::vector<Scene> scenes;
  std::string bytes;
};

// The most bytes of lines that a block has, unless it has a single one: reading one means reading
// all, and a small file may be a very large block.
constexpr std::size_t kLongestBlock = std::size_t{1} << 23;

// Packs stored lines (see stored_line), one for each scene.
RecordedBlock make_block(std::vector<RecordedBlock::Scene> scenes,
                         const std::vector<std::string>& lines);

// The bytes of the whole file.
std::string recording_bytes(const RecordingHead& head, const std::vector<RecordedBlock>& blocks);

// An open recording. It stays readable if the file is replaced meanwhile.
class Recording {
 public:
  // Where the answer to a case is stored.
  struct Place {
    std::string digest;
    std::size_t block = 0;
    std::size_t line = 0;  // within the block
  };

  // Reads and checks the whole file. On failure, one sentence with the file, the fault and the
  // remedy.
  static std::variant<Recording, std::string> open(const std::filesystem::path& path);
  // Reads only the head; its checksum is not checked.
  static std::variant<RecordingHead, std::string> open_head(const std::filesystem::path& path);

  const RecordingHead& head() const { return head_; }
  std::size_t size() const { return places_.size(); }
  // The place of a case, or null.
  const Place* find(const std::string& id) const;
  // The lines of a block, whose scenes are `scenes` in number. Throws std::runtime_error if it
  // cannot be unpacked. `longest`: what the line of a scene that has a block to itself may have, in
  // bytes.
  std::vector<std::string> lines(std::size_t block, std::size_t longest) const;

 private:
  struct Stretch {
    std::size_t begin = 0;
    std::size_t size = 0;
    std::size_t scenes = 0;
  };

  static Recording read(std::string bytes);

  std::string bytes_;
  RecordingHead head_;
  std::vector<Stretch> blocks_;
  std::map<std::string, Place> places_;
};

}  // namespace edgecase

namespace edgecase::recording {

// The stored form of an outcome: a line as it comes from a renderer (reference/PROTOCOL.md), or the
// reason why there is none. The scene's digest is in the recording's index.

// A line of JSON without a line break.
std::string stored_line(const Outcome& outcome);

// The inverse, as strict as the reading of answers. If the line is not an outcome of this scene,
// the result is a Failure with the reason.
Outcome outcome_of(const std::string& line, const Scene& scene);

}  // namespace edgecase::recording
