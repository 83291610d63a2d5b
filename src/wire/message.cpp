// SPDX-License-Identifier: MIT
#include "wire/message.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <exception>
#include <utility>
#include <vector>

#include "model/fnv.h"
#include "wire/binary.h"
#include "wire/fragments.h"

namespace edgecase {

using wire::carry;
using wire::Reader;
using wire::Refusal;
using wire::Writer;

namespace {

enum class AnswerKind : std::uint8_t { rendering, coverage, refusal };

// FNV-1a over words of eight bytes. `before` is the digest of what comes before them.
std::uint64_t digest_of_bytes(std::string_view bytes, std::uint64_t before = kFnvStart) {
  std::uint64_t hash = before;
  const auto add = [&](std::uint64_t word) {
    hash = fnv_step(hash, word);
    hash ^= hash >> 29;
  };
  std::uint64_t word = 0;
  for (; bytes.size() >= sizeof(word); bytes.remove_prefix(sizeof(word))) {
    std::memcpy(&word, bytes.data(), sizeof(word));
    add(word);
  }
  word = bytes.size();
  std::memcpy(&word, bytes.data(), bytes.size());
  if (!bytes.empty()) add(word);
  return hash;
}

// Everything except fragments, hits and passes.
template <class Io, wire::Of<Rendering> T>
void carry_planes(Io& io, T& rendering) {
  wire::carry_all(io, rendering.sample_positions, rendering.pixels, rendering.sample_pixels,
                  rendering.depths, rendering.stencils, rendering.mip_chains,
                  rendering.accumulated);
}

void write_rendering(Writer& io, const Rendering& rendering) {
  carry_planes(io, rendering);
  wire::write_fragments(io, rendering);
  wire::write_hits(io, rendering);
  io.size(rendering.passes.size());
  for (const Rendering& pass : rendering.passes) write_rendering(io, pass);
}

// Reads the rendering of a scene or, if there may be no passes, of one of its passes.
Rendering read_rendering(Reader& io, const Scene& scene, bool may_have_passes) {
  Rendering rendering;
  rendering.width = scene.target.width;
  rendering.height = scene.target.height;
  rendering.samples = scene.target.samples;
  carry_planes(io, rendering);
  wire::drop_signs_of_zero(rendering.depths);
  wire::drop_signs_of_zero(rendering.accumulated);
  wire::read_fragments(io, scene, rendering);
  wire::read_hits(io, rendering);
  const std::size_t passes = io.size(1);
  if (passes > 0 && !may_have_passes) throw Refusal("a pass has passes");
  if (passes > scene.supersampling.size())
    throw Refusal("there are more passes than were asked for");
  for (std::size_t k = 0; k < passes; ++k)
    rendering.passes.push_back(read_rendering(io, scene, false));
  sort_fragments(rendering);
  return rendering;
}

void write_coverage(Writer& io, const Rendering& rendering) {
  carry(io, wire::coverage_runs(rendering));
  const bool has_hits = contradiction_of_hits(rendering).has_value();
  carry(io, has_hits);
  if (has_hits) carry(io, rendering.hits);
}

Rendering read_coverage(Reader& io, const Scene& scene) {
  Rendering rendering;
  rendering.width = scene.target.width;
  rendering.height = scene.target.height;
  std::vector<int> runs;
  carry(io, runs);
  rendering.fragments = wire::fragments_of_runs(
      runs, {rendering.width, rendering.height, static_cast<int>(primitives_of(scene).size())});
  bool has_hits = false;
  carry(io, has_hits);
  if (has_hits) carry(io, rendering.hits);
  sort_fragments(rendering);
  return rendering;
}

Rendering read_drawing(Reader& io, AnswerKind kind, const Scene& scene, bool coverage_only) {
  if (kind == AnswerKind::rendering) {
    Rendering rendering = read_rendering(io, scene, true);
    check_rendering(rendering, scene);
    return rendering;
  }
  if (kind != AnswerKind::coverage || !coverage_only)
    throw Refusal("the answer is of a kind that was not asked for");
  Rendering rendering = read_coverage(io, scene);
  check_coverage(rendering, scene);
  return rendering;
}

Answer read_answer(Reader& io, std::uint64_t digest, const Scene& scene, bool coverage_only) {
  std::uint64_t given = 0;
  carry(io, given);
  if (given != digest) throw Refusal("it is the answer to another scene");
  auto kind = AnswerKind::rendering;
  carry(io, kind);
  Answer answer;
  carry(io, answer.claims);
  if (answer.claims) {
    check_claims(*answer.claims);
    answer.claims = bounded_claims(std::move(*answer.claims));
  }
  answer.digest = digest_of_bytes(io.left(), digest);
  if (kind == AnswerKind::refusal) {
    Failure failure{FailureKind::unsupported, ""};
    carry(io, failure.reason);
    failure.reason = bounded_text(std::move(failure.reason));
    answer.outcome = std::move(failure);
  } else {
    answer.outcome = read_drawing(io, kind, scene, coverage_only);
  }
  if (!io.left().empty()) throw Refusal("the message goes on after its end");
  return answer;
}

}  // namespace

OutgoingRequest request_message(const std::string& id, const Scene& scene, bool coverage_only) {
  std::string body;
  Writer io(body);
  wire::carry_all(io, id, coverage_only, scene);
  OutgoingRequest request;
  request.digest = digest_of_bytes(body);
  request.bytes.reserve(body.size() + sizeof(request.digest));
  Writer head(request.bytes);
  carry(head, request.digest);
  request.bytes += body;
  return request;
}

std::variant<IncomingRequest, WireError> parse_request_message(std::string_view bytes) {
  try {
    Reader io(bytes);
    IncomingRequest request;
    carry(io, request.digest);
    if (digest_of_bytes(io.left()) != request.digest)
      throw Refusal("the message has changed on its way");
    wire::carry_all(io, request.id, request.coverage_only, request.scene);
    if (!io.left().empty()) throw Refusal("the message goes on after its end");
    return request;
  } catch (const Refusal& refusal) {
    return WireError{refusal.what()};
  }
}

std::string answer_message(std::uint64_t digest, const Outcome& outcome, bool coverage_only,
                           const RendererInfo* claims) {
  const auto* failure = std::get_if<Failure>(&outcome);
  const AnswerKind kind = failure != nullptr ? AnswerKind::refusal
                          : coverage_only    ? AnswerKind::coverage
                                             : AnswerKind::rendering;
  std::string bytes;
  Writer io(bytes);
  const bool has_claims = claims != nullptr;
  wire::carry_all(io, digest, kind, has_claims);
  if (has_claims) carry(io, *claims);
  if (failure != nullptr)
    carry(io, failure->reason);
  else if (coverage_only)
    write_coverage(io, std::get<Rendering>(outcome));
  else
    write_rendering(io, std::get<Rendering>(outcome));
  return bytes;
}

std::uint64_t digest_of_answer(const Scene& scene, const Rendering& rendering) {
  std::string bytes;
  Writer io(bytes);
  carry(io, scene);
  write_rendering(io, rendering);
  return digest_of_bytes(bytes);
}

std::variant<Answer, WireError> parse_answer_message(std::string_view bytes, std::uint64_t digest,
                                                     const Scene& scene, bool coverage_only) {
  try {
    Reader io(bytes);
    return read_answer(io, digest, scene, coverage_only);
  } catch (const std::exception& thrown) {
    return error_of_reading(thrown);
  }
}

namespace wire {

template <class Io, Of<BenchRequest> T>
void carry(Io& io, T& request) {
  carry_all(io, request.task, request.seconds, request.scenes);
}

template <class Io, Of<BenchAnswer> T>
void carry(Io& io, T& answer) {
  carry_all(io, answer.problem, answer.rounds, answer.seconds, answer.pixels);
}

}  // namespace wire

namespace {

template <class Message>
std::string bytes_of(const Message& message) {
  std::string bytes;
  wire::Writer io(bytes);
  carry(io, message);
  return bytes;
}

template <class Message>
std::variant<Message, WireError> read(std::string_view bytes) {
  try {
    wire::Reader io(bytes);
    Message message;
    carry(io, message);
    if (!io.left().empty()) throw wire::Refusal("the message goes on after its end");
    return message;
  } catch (const wire::Refusal& refusal) {
    return WireError{refusal.what()};
  }
}

}  // namespace

std::string bench_request_message(const BenchRequest& request) {
  return bytes_of(request);
}

std::variant<BenchRequest, WireError> parse_bench_request(std::string_view bytes) {
  return read<BenchRequest>(bytes);
}

std::string bench_answer_message(const BenchAnswer& answer) {
  return bytes_of(answer);
}

std::variant<BenchAnswer, WireError> parse_bench_answer(std::string_view bytes) {
  return read<BenchAnswer>(bytes);
}

}  // namespace edgecase
