// SPDX-License-Identifier: MIT
#include "wire/answer_planes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

namespace edgecase::wire {

using nlohmann::json;

namespace {

using Bytes = json::binary_t::container_type;

template <class Number>
void append(Number number, Bytes& bytes) {
  const std::size_t end = bytes.size();
  bytes.resize(end + sizeof number);
  std::memcpy(bytes.data() + end, &number, sizeof number);
}

template <class Integer>
void append_integer(const json& value, const Path& path, Bytes& bytes) {
  append(static_cast<Integer>(read_integer(value, path, 0, std::numeric_limits<Integer>::max())),
         bytes);
}

void append_depth(const json& value, const Path& path, Bytes& bytes) {
  append(read_finite(value, path), bytes);
}

void append_number(const json& value, const Path& path, Bytes& bytes) {
  append(read_number(value, path), bytes);
}

struct PlaneKey {
  const char* key;
  void (*append)(const json& value, const Path& path, Bytes& bytes);
};

constexpr std::array kPlanes = {PlaneKey{"pixels", append_integer<std::uint8_t>},
                                PlaneKey{"sample_pixels", append_integer<std::uint8_t>},
                                PlaneKey{"stencils", append_integer<std::uint8_t>},
                                PlaneKey{"hits", append_integer<std::uint32_t>},
                                PlaneKey{"depths", append_depth},
                                PlaneKey{"accumulated", append_number}};

// Makes the document as the library's own parser does, but for planes. What the library calls is
// named as it asks; all return true, to go on. (Its parser with a callback looks through all
// elements of an array at the end of each, which takes minutes for a list of fragments.)
class DocumentBuilder {
 public:
  json take() { return std::move(root_); }

  bool null() { return add(nullptr); }
  bool boolean(bool value) { return add(value); }
  bool number_integer(json::number_integer_t value) { return add(value); }
  bool number_unsigned(json::number_unsigned_t value) { return add(value); }
  bool number_float(json::number_float_t value, const std::string&) { return add(value); }
  bool string(std::string& value) { return add(std::move(value)); }
  bool binary(json::binary_t& value) { return add(std::move(value)); }

  bool start_object(std::size_t) {
    if (open_.size() == 2) ++passes_;
    return open(json::object());
  }
  bool start_array(std::size_t) {
    const bool may_be_plane = open_.size() == 1 || (open_.size() == 3 && is_in_passes_);
    if (plane_ != nullptr || !may_be_plane || key_plane_ == nullptr) return open(json::array());
    plane_ = key_plane_;
    elements_ = 0;
    return true;
  }
  bool end_object() { return close(); }
  bool end_array() {
    if (plane_ == nullptr) return close();
    plane_ = nullptr;
    return add(json::binary(std::exchange(bytes_, {})));
  }
  bool key(std::string& name) {
    const auto found =
        std::ranges::find_if(kPlanes, [&](const PlaneKey& plane) { return name == plane.key; });
    key_plane_ = found == kPlanes.end() ? nullptr : &*found;
    if (open_.size() == 1) {
      is_in_passes_ = name == "passes";
      passes_ = 0;
    }
    place_ = &(*open_.back())[name];
    return true;
  }
  template <class Error>
  bool parse_error(std::size_t, const std::string&, const Error& error) {
    throw error;
  }

 private:
  bool add(json value) {
    if (plane_ != nullptr)
      append(value);
    else
      *place_for_value() = std::move(value);
    return true;
  }

  // An array or object; none is a value that a plane holds.
  bool open(json empty) {
    if (plane_ != nullptr) append(empty);
    json* const place = place_for_value();
    *place = std::move(empty);
    open_.push_back(place);
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }

  json* place_for_value() {
    if (open_.empty()) return &root_;
    if (!open_.back()->is_array()) return place_;
    open_.back()->push_back(nullptr);
    return &open_.back()->back();
  }

  void append(const json& value) {
    const Path line;
    const Path passes(line, "passes");
    const Path pass(passes, passes_ - 1);
    const Path plane(open_.size() == 3 ? pass : line, plane_->key);
    plane_->append(value, {plane, elements_++}, bytes_);
  }

  json root_;
  std::vector<json*> open_;  // arrays and objects that have begun, the outermost first
  json* place_ = nullptr;    // of the value of the latest key
  bool is_in_passes_ = false;
  std::size_t passes_ = 0;               // that have begun
  const PlaneKey* key_plane_ = nullptr;  // of the latest key
  const PlaneKey* plane_ = nullptr;      // that is read
  Bytes bytes_;                          // of its elements
  std::size_t elements_ = 0;
};

}  // namespace

json parse_answer_text(std::string_view line) {
  return parse_text(line, [](std::string_view text) {
    DocumentBuilder builder;
    json::sax_parse(text, &builder);
    return builder.take();
  });
}

template <class Number>
std::vector<Number> read_plane(const json& value, const Path& path, std::size_t size) {
  if (!value.is_binary()) require_array(value, path, size);
  const Bytes& bytes = value.get_binary();
  if (bytes.size() != size * sizeof(Number))
    throw Refusal(fmt::format("{} must have {} elements, but it has {}", path.text(), size,
                              bytes.size() / sizeof(Number)));
  std::vector<Number> result(size);
  if (size > 0) std::memcpy(result.data(), bytes.data(), bytes.size());
  return result;
}

template std::vector<std::uint8_t> read_plane(const json&, const Path&, std::size_t);
template std::vector<std::uint32_t> read_plane(const json&, const Path&, std::size_t);
template std::vector<double> read_plane(const json&, const Path&, std::size_t);

}  // namespace edgecase::wire
