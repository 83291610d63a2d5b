// SPDX-License-Identifier: MIT
#include "results/case_list.h"

#include <algorithm>
#include <iterator>
#include <mutex>

#include "wire/binary.h"

namespace edgecase {

using wire::carry_all;
using wire::Of;

// A member that equals what another has is noted as such, so that both share it when it is read.
template <class Value>
void carry_shared(wire::Writer& io, const Shared<Value>& value, const Shared<Value>& other) {
  const bool is_same = value == other;
  carry(io, is_same);
  if (!is_same) carry(io, *value);
}
template <class Value>
void carry_shared(wire::Reader& io, Shared<Value>& value, const Shared<Value>& other) {
  bool is_same = false;
  carry(io, is_same);
  if (is_same) {
    value = other;
    return;
  }
  Value own;
  carry(io, own);
  value = std::move(own);
}

template <class Io, Of<SampleImage> T>
void carry_samples(Io& io, T& image, const SampleImage& other) {
  carry_all(io, image.samples, image.positions);
  carry_shared(io, image.pixels, other.pixels);
  carry_shared(io, image.hits, other.hits);
  carry_shared(io, image.coverage, other.coverage);
}

template <class Io, Of<AlternativeId> T>
void carry(Io& io, T& id) {
  carry_all(io, id.rule, id.index);
}

template <class Io, Of<Cause> T>
void carry(Io& io, T& cause) {
  carry(io, cause.parts);
}

inline void carry(wire::Writer& io, const AlternativeSet& set) {
  io.bytes(&set, sizeof(set));
}
inline void carry(wire::Reader& io, AlternativeSet& set) {
  io.bytes(&set, sizeof(set));
}

template <class Io, Of<Mark> T>
void carry(Io& io, T& mark) {
  carry_all(io, mark.role, mark.closed, mark.points, mark.label);
}

template <class Io, Of<Figure> T>
void carry(Io& io, T& figure) {
  carry(io, figure.marks);
}

template <class Io, Of<Disagreement::Upright> T>
void carry(Io& io, T& upright) {
  carry_all(io, upright.rule, upright.ruling, upright.legality, upright.cause);
}

// A number that is mostly near 0, in few bytes: seven bits each, the lowest first, behind a bit for
// the sign.
void write_small(wire::Writer& io, std::int64_t value) {
  auto left = static_cast<std::uint64_t>(value) << 1 ^ static_cast<std::uint64_t>(value >> 63);
  std::array<std::uint8_t, 10> bytes;
  std::size_t count = 0;
  for (; left >= 0x80; left >>= 7) bytes[count++] = static_cast<std::uint8_t>(left | 0x80);
  bytes[count++] = static_cast<std::uint8_t>(left);
  io.bytes(bytes.data(), count);
}
std::int64_t read_small(wire::Reader& io) {
  std::uint64_t value = 0;
  std::uint8_t byte = 0x80;
  for (int shift = 0; byte >= 0x80; shift += 7) {
    carry(io, byte);
    value |= std::uint64_t{byte & 0x7fU} << shift;
  }
  return static_cast<std::int64_t>(value >> 1 ^ (0 - (value & 1)));
}

// Each run is the distance of its beginning from the end of the run before, and its length.
void carry_runs(wire::Writer& io, const std::vector<PixelRun>& runs) {
  io.size(runs.size());
  PixelRun before;
  for (const PixelRun& run : runs) {
    for (const std::int64_t number :
         {std::int64_t{run.y} - before.y, std::int64_t{run.begin} - before.end,
          std::int64_t{run.end} - run.begin})
      write_small(io, number);
    before = run;
  }
}
void carry_runs(wire::Reader& io, std::vector<PixelRun>& runs) {
  std::uint64_t count = 0;
  carry(io, count);
  runs.reserve(static_cast<std::size_t>(count));
  PixelRun before;
  for (; count > 0; --count) {
    PixelRun run;
    run.y = before.y + static_cast<int>(read_small(io));
    run.begin = before.end + static_cast<int>(read_small(io));
    run.end = run.begin + static_cast<int>(read_small(io));
    runs.push_back(before = run);
  }
}

template <class Io, Of<CountedDisagreements> T>
void carry(Io& io, T& d) {
  carry_all(io, d.sample, d.primitive, d.kind, d.rule, d.legality, d.cause, d.ruling,
            d.policy_agrees, d.upright);
  carry_runs(io, d.runs);
}

template <class Io, Of<Disagreement> T>
void carry(Io& io, T& d) {
  carry_all(io, d.x, d.y, d.sample, d.primitive, d.kind, d.rule, d.legality, d.cause, d.situation,
            d.ruling, d.policy_agrees, d.upright, d.exact, d.rendered, d.explanation, d.figure);
}

template <class Io, Of<ValueAggregate::Place> T>
void carry(Io& io, T& place) {
  carry_all(io, place.x, place.y, place.primitive);
}

// Places of whole scenes are many, and most of them neighbours in a row: each run of these is the
// distance of its place from the end of the run before, and its length.
using Places = std::vector<ValueAggregate::Place>;

void carry_places(wire::Writer& io, const Places& places) {
  io.size(places.size());
  ValueAggregate::Place end{0, 0, 0};
  for (std::size_t at = 0; at < places.size();) {
    const ValueAggregate::Place& first = places[at];
    int length = 1;
    for (++at; at < places.size(); ++at, ++length) {
      const ValueAggregate::Place& next = places[at];
      if (next.x != first.x + length || next.y != first.y || next.primitive != first.primitive)
        break;
    }
    for (const std::int64_t number :
         {std::int64_t{first.x} - end.x, std::int64_t{first.y} - end.y,
          std::int64_t{first.primitive} - end.primitive, std::int64_t{length}})
      write_small(io, number);
    end = {first.x + length, first.y, first.primitive};
  }
}
void carry_places(wire::Reader& io, Places& places) {
  std::uint64_t count = 0;
  carry(io, count);
  places.resize(static_cast<std::size_t>(count));
  ValueAggregate::Place next{0, 0, 0};
  for (std::size_t at = 0; at < places.size();) {
    next.x += static_cast<int>(read_small(io));
    next.y += static_cast<int>(read_small(io));
    next.primitive += static_cast<int>(read_small(io));
    for (std::int64_t length = read_small(io); length > 0 && at < places.size(); --length, ++next.x)
      places[at++] = next;
  }
}

template <class Io, Of<ValueAggregate> T>
void carry(Io& io, T& v) {
  carry_all(io, v.attribute, v.rule, v.ruling, v.cause, v.compared, v.components);
  carry_places(io, v.differing);
  carry_all(io, v.worst, v.worst_component, v.worst_exact, v.worst_rendered, v.worst_low,
            v.worst_high, v.worst_ulp, v.mean_ulp, v.worst_relative, v.ulp_histogram);
}

template <class Io, Of<Result::Evidence> T>
void carry(Io& io, T& evidence) {
  carry_all(io, evidence.primitive, evidence.causes, evidence.illegal_line_snaps,
            evidence.broken_clause, evidence.pass);
}

inline void carry_cells(wire::Writer& io, const Shared<PlaceCells>& cells) {
  io.bytes(&*cells, sizeof(PlaceCells));
}
inline void carry_cells(wire::Reader& io, Shared<PlaceCells>& cells) {
  PlaceCells own;
  io.bytes(&own, sizeof(own));
  cells = own;
}

template <class Io, Of<Result::Shown> T>
void carry(Io& io, T& shown) {
  auto& thing = shown.thing;
  carry_all(io, thing.kind, thing.of, thing.sample, thing.x, thing.y, shown.low, shown.high);
  if (thing.kind == SingleThing::Kind::sample_cells) carry_cells(io, shown.cells);
}

template <class Io, Of<Result::LevelPoint> T>
void carry(Io& io, T& point) {
  carry_all(io, point.x, point.y, point.exact, point.low, point.high, point.rendered);
}

template <class Io, Of<Result::ReportedFragment> T>
void carry(Io& io, T& reported) {
  auto& f = reported.fragment;
  carry_all(io, f.x, f.y, f.primitive, f.coverage, f.depth, f.color, f.has_depth, f.has_color,
            reported.pass);
}

template <class Io, Of<PixelCounts> T>
void carry(Io& io, T& counts) {
  carry_all(io, counts.by_verdict, counts.same);
}

// All but the answer, which the outline has.
template <class Io, class T>
void carry_findings(Io& io, T& result, const CaseResults& one) {
  carry_all(io, result.disagreements, result.counted, result.values, result.evidence,
            result.illegal_line_snaps, result.refuted, result.shown, result.ramp,
            result.exact_fragments, result.rendered_fragments, result.pixel_counts);
  carry_shared(io, result.exact_pixels, one.pixels);
  carry_shared(io, result.pixels, result.exact_pixels);
  carry_samples(io, result.exact_samples, one.samples);
  carry_samples(io, result.samples, result.exact_samples);
}

template <class Io, class T>
void carry_head(Io& io, T& one) {
  carry_all(io, one.title, one.why, one.rules, one.spec, one.origin, one.tags, one.file,
            one.file_digest, one.width, one.height, one.viewport);
}

template <class Io, class T>
void carry_case(Io& io, T& one) {
  carry_head(io, one);
  carry_shared(io, one.pixels, {});
  carry_samples(io, one.samples, {});
  carry_all(io, one.fragments, one.figure, one.expect_failures);
  for (auto& result : one.results) carry_findings(io, result, one);
}

namespace {

std::string bytes_of(const CaseResults& one) {
  std::string bytes;
  wire::Writer io(bytes);
  carry_case(io, one);
  return bytes;
}

std::string head_bytes_of(const CaseResults& one) {
  std::string bytes;
  wire::Writer io(bytes);
  carry_head(io, one);
  return bytes;
}

// Places and runs are few bytes only on the shelf.
std::size_t bytes_of_places(const CaseResults& one) {
  std::size_t bytes = 0;
  for (const Result& result : one.results)
    for (const CountedDisagreements& counted : result.counted)
      bytes += counted.runs.size() * sizeof(PixelRun);
  for (const Result& result : one.results)
    for (const ValueAggregate& values : result.values)
      bytes += values.differing.size() * sizeof(ValueAggregate::Place);
  return bytes;
}

}  // namespace

CaseOutline outline_of(const CaseResults& one) {
  const bool has_ramp =
      std::ranges::any_of(one.results, [](const Result& result) { return !result.ramp.empty(); });
  return {
      one.id,
      one.surface,
      one.expect_failures.size(),
      has_ramp,
      std::ranges::any_of(one.results, depends_on_run),
      std::ranges::any_of(one.results, [](const Result& result) { return !result.shown.empty(); }),
      {one.results.begin(), one.results.end()}};
}

bool has_details(const CaseOutline& one) {
  return one.expect_failures > 0 || one.has_ramp ||
         std::ranges::any_of(one.answers, [](const ResultOutline& answer) {
           return answer.verdict != Verdict::agree || answer.standing != Standing::expected;
         });
}

ShelvedCase::ShelvedCase(const CaseResults& one, std::shared_ptr<Shelf> shelf)
    : outline(outline_of(one)),
      shelf_(std::move(shelf)),
      head_(shelf_->put_repeated(head_bytes_of(one))),
      place_(shelf_->put(bytes_of(one))),
      bytes_(place_.unpacked + bytes_of_places(one)) {}

CaseResults ShelvedCase::head() const {
  const std::string bytes = shelf_->at(head_);
  CaseResults one;
  one.id = outline.id;
  one.surface = outline.surface;
  wire::Reader io(bytes);
  carry_head(io, one);
  return one;
}

CaseResults ShelvedCase::whole() const {
  const std::string bytes = shelf_->at(place_);
  CaseResults one;
  one.id = outline.id;
  one.surface = outline.surface;
  one.results.resize(outline.answers.size());
  wire::Reader io(bytes);
  carry_case(io, one);
  for (std::size_t r = 0; r < one.results.size(); ++r)
    static_cast<ResultOutline&>(one.results[r]) = outline.answers[r];
  return one;
}

std::optional<std::size_t> CaseList::find(const std::string& id) const {
  const auto found = std::ranges::find(
      cases_, id, [](const ShelvedCase& one) -> const std::string& { return one.outline.id; });
  if (found == cases_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - cases_.begin());
}

void CaseList::merge(CaseList other) {
  std::ranges::move(other.cases_, std::back_inserter(cases_));
  std::ranges::sort(cases_, {},
                    [](const ShelvedCase& one) -> const std::string& { return one.outline.id; });
}

const std::shared_ptr<Shelf>& CaseList::own_shelf() {
  static std::mutex making;
  const std::lock_guard lock(making);
  if (shelf_ == nullptr) shelf_ = std::make_shared<Shelf>();
  return shelf_;
}

}  // namespace edgecase
