// SPDX-License-Identifier: MIT
#include "recording/recording.h"

#include <fmt/format.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <variant>

#include "recording/block.h"
#include "recording/bytes.h"
#include "wire/answer_line.h"
#include "wire/json_size.h"
#include "wire/json_values.h"

namespace edgecase {

namespace {

using nlohmann::json;
using recording::checksum;

constexpr std::string_view kMagic = "edgecase-recording ";
// A size of 16 digits, a space, a checksum of 8 digits, a line break.
constexpr std::size_t kEndSize = 26;
// Its first two lines; claims are bounded (wire/answer_line.h).
constexpr std::size_t kLongestHead = std::size_t{1} << 20;

std::string text_of(const json& value) {
  return value.dump(-1, ' ', true, json::error_handler_t::replace);
}

std::string head_text(const RecordingHead& head) {
  const RendererInfo& info = head.renderer;
  const json renderer = {{"name", info.name},
                         {"vendor", info.vendor},
                         {"version", info.version},
                         {"device", info.device},
                         {"subpixel_bits", info.subpixel_bits},
                         {"traits", info.traits}};
  const json line = {{"tool", head.tool}, {"complete", head.is_complete}, {"renderer", renderer}};
  return fmt::format("{}{}\n{}\n", kMagic, kRecordingVersion, text_of(line));
}

RecordingHead to_head(const json& line) {
  RecordingHead head;
  head.tool = line.at("tool");
  head.is_complete = line.at("complete");
  const json& renderer = line.at("renderer");
  head.renderer.name = renderer.at("name");
  head.renderer.vendor = renderer.at("vendor");
  head.renderer.version = renderer.at("version");
  head.renderer.device = renderer.at("device");
  head.renderer.subpixel_bits =
      wire::read_int(renderer.at("subpixel_bits"), wire::Path({}, "subpixel_bits"),
                     std::numeric_limits<int>::min(), std::numeric_limits<int>::max());
  head.renderer.traits = renderer.at("traits").get<std::map<std::string, std::string>>();
  head.renderer = bounded_claims(std::move(head.renderer));
  return head;
}

json stretch_json(std::string_view bytes) {
  return {{"size", bytes.size()}, {"crc", checksum(bytes)}};
}

std::string index_text(std::string_view head, const std::vector<RecordedBlock>& blocks) {
  json list = json::array();
  for (const RecordedBlock& block : blocks) {
    json scenes = json::array();
    for (const auto& [id, digest] : block.scenes) {
      scenes.push_back(id);
      scenes.push_back(digest);
    }
    json one = stretch_json(block.bytes);
    one["scenes"] = std::move(scenes);
    list.push_back(std::move(one));
  }
  return text_of({{"head", stretch_json(head)}, {"blocks", std::move(list)}});
}

// The part of a file that an entry of its index describes, starting at `begin`.
std::string_view checked(std::string_view bytes, std::size_t begin, const json& entry) {
  const auto whole = [&](const char* key, std::int64_t high) {
    return wire::read_integer(entry.at(key), wire::Path({}, key), 0, high);
  };
  const auto size =
      static_cast<std::size_t>(whole("size", std::numeric_limits<std::int64_t>::max()));
  if (begin > bytes.size() || size > bytes.size() - begin)
    throw std::runtime_error("it is cut off");
  const std::string_view stretch = bytes.substr(begin, size);
  if (checksum(stretch) != whole("crc", std::numeric_limits<std::uint32_t>::max()))
    throw std::runtime_error(
        fmt::format("its bytes {} to {} are not what was written", begin, begin + size));
  return stretch;
}

template <class Number>
Number read_hex(std::string_view digits) {
  Number value = 0;
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
  if (error != std::errc() || end != digits.data() + digits.size())
    throw std::runtime_error("its end is missing");
  return value;
}

// The index before the file's end.
std::string_view index_of(std::string_view bytes) {
  if (bytes.size() < kEndSize) throw std::runtime_error("its end is missing");
  const std::string_view end = bytes.substr(bytes.size() - kEndSize);
  if (end[16] != ' ' || end.back() != '\n') throw std::runtime_error("its end is missing");
  const auto size = read_hex<std::size_t>(end.substr(0, 16));
  if (size > bytes.size() - kEndSize) throw std::runtime_error("its end is missing");
  const std::string_view index = bytes.substr(bytes.size() - kEndSize - size, size);
  if (checksum(index) != read_hex<std::uint32_t>(end.substr(17, 8)))
    throw std::runtime_error("its index is not what was written");
  return index;
}

// Refuses files that are not recordings, and other versions.
void check_version(std::string_view first_line) {
  if (!first_line.starts_with(kMagic)) throw std::runtime_error("it is no recording");
  const std::string_view version = first_line.substr(kMagic.size());
  if (version != std::to_string(kRecordingVersion))
    throw std::runtime_error(
        fmt::format("it has version {} of the format, and this program reads "
                    "version {}",
                    version.substr(0, 20), kRecordingVersion));
}

std::string refusal(const std::filesystem::path& path, const std::string& why) {
  return fmt::format("the recording {} cannot be used: {}; record it again with `edgecase record`",
                     path.string(), why);
}

std::string unreadable(const std::filesystem::path& path) {
  const int code = errno;
  std::error_code error;
  // A recording is read twice, and a device could be endless.
  if (std::filesystem::is_other(path, error))
    return fmt::format("cannot read the recording {}: it is a pipe or a device; name a file",
                       path.string());
  return fmt::format("cannot read the recording {}: {}", path.string(),
                     std::strerror(code != 0 ? code : EISDIR));
}

// A file that can be read from its start.
std::optional<std::ifstream> open_file(const std::filesystem::path& path) {
  std::error_code other;
  if (std::filesystem::is_other(path, other)) return std::nullopt;
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  if (!in || in.peek() == std::ifstream::traits_type::eof()) {
    std::error_code error;
    // An empty file can be opened, and is refused later with a better message.
    if (!std::filesystem::is_regular_file(path, error)) return std::nullopt;
    in.clear();
  }
  return in;
}

}  // namespace

RecordedBlock make_block(std::vector<RecordedBlock::Scene> scenes,
                         const std::vector<std::string>& lines) {
  return {std::move(scenes), recording::pack_block(lines)};
}

std::string recording_bytes(const RecordingHead& head, const std::vector<RecordedBlock>& blocks) {
  std::string bytes = head_text(head);
  std::string index;
  recording::write_deflated(index_text(bytes, blocks), index);
  for (const RecordedBlock& block : blocks) bytes += block.bytes;
  bytes += index;
  bytes += fmt::format("{:016x} {:08x}\n", index.size(), checksum(index));
  return bytes;
}

namespace {

// Of some 100,000 cases at most.
json read_index(std::string_view index) {
  constexpr std::size_t kMostBytes = std::size_t{1} << 24;
  constexpr std::size_t kMostValues = std::size_t{1} << 20;
  const std::string text = recording::read_deflated(index, kMostBytes);
  const JsonSize size = size_of_json(text);
  if (size.levels > kMostLevels || size.values > kMostValues)
    throw std::runtime_error("its index is larger than any may be");
  return json::parse(text);
}

}  // namespace

Recording Recording::read(std::string bytes) {
  Recording result;
  result.bytes_ = std::move(bytes);
  const std::string_view all = result.bytes_;
  check_version(all.substr(0, all.find('\n')));
  std::string_view index = index_of(all);
  const std::size_t end = all.size() - kEndSize - index.size();
  const json entries = read_index(index);
  const std::string_view head = checked(all, 0, entries.at("head"));
  result.head_ = to_head(json::parse(head.substr(head.find('\n'))));
  std::size_t begin = head.size();
  for (const json& entry : entries.at("blocks")) {
    const std::size_t size = checked(all, begin, entry).size();
    const json& scenes = entry.at("scenes");
    for (std::size_t i = 0; i + 1 < scenes.size(); i += 2)
      result.places_[scenes[i]] = {scenes[i + 1], result.blocks_.size(), i / 2};
    result.blocks_.push_back({begin, size, scenes.size() / 2});
    begin += size;
  }
  if (begin != end) throw std::runtime_error("it holds more than its index says");
  return result;
}

std::variant<Recording, std::string> Recording::open(const std::filesystem::path& path) {
  auto in = open_file(path);
  if (!in) return unreadable(path);
  std::ostringstream text;
  text << in->rdbuf();
  try {
    return read(std::move(text).str());
  } catch (const std::exception& error) {
    return refusal(path, error.what());
  }
}

std::variant<RecordingHead, std::string> Recording::open_head(const std::filesystem::path& path) {
  auto in = open_file(path);
  if (!in) return unreadable(path);
  try {
    std::string beginning(kLongestHead, '\0');
    in->read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
    beginning.resize(static_cast<std::size_t>(in->gcount()));
    const std::size_t end = beginning.find('\n');
    check_version(std::string_view(beginning).substr(0, end));
    return to_head(json::parse(beginning.substr(end + 1, beginning.find('\n', end + 1) - end - 1)));
  } catch (const std::exception& error) {
    return refusal(path, error.what());
  }
}

const Recording::Place* Recording::find(const std::string& id) const {
  const auto found = places_.find(id);
  return found == places_.end() ? nullptr : &found->second;
}

std::vector<std::string> Recording::lines(std::size_t block, std::size_t longest) const {
  const Stretch& stretch = blocks_.at(block);
  return recording::unpack_block(std::string_view(bytes_).substr(stretch.begin, stretch.size),
                                 stretch.scenes > 1 ? kLongestBlock : longest);
}

}  // namespace edgecase

namespace edgecase::recording {

namespace {

// The start of a failure; no answer starts like this.
constexpr const char* kFailureStart = "{\"failure\":";

FailureKind kind_of_name(const std::string& name) {
  FailureKind kind{};
  if (parse_name(name, kind)) return kind;
  throw std::runtime_error("the kind of failure \"" + name + "\" is not known");
}

Failure unreadable(const std::string& why) {
  return {FailureKind::garbage, "the recorded answer is refused: " + why};
}

Failure read_failure(const std::string& line) {
  try {
    const json failure = json::parse(line);
    return {kind_of_name(failure.at("failure")), bounded_text(failure.at("reason"))};
  } catch (const std::exception& error) {
    return unreadable(error.what());
  }
}

}  // namespace

std::string stored_line(const Outcome& outcome) {
  if (const auto* rendering = std::get_if<Rendering>(&outcome))
    return answer_line("", *rendering, nullptr);
  const Failure& failure = std::get<Failure>(outcome);
  const json line = {{"failure", name_of(failure.kind)}, {"reason", failure.reason}};
  return line.dump(-1, ' ', true, json::error_handler_t::replace);
}

Outcome outcome_of(const std::string& line, const Scene& scene) {
  if (line.starts_with(kFailureStart)) return read_failure(line);
  auto parsed = parse_answer(line, "", scene);
  if (auto* answer = std::get_if<Answer>(&parsed)) return std::move(answer->outcome);
  return unreadable(std::get<WireError>(parsed).message);
}

}  // namespace edgecase::recording
