// SPDX-License-Identifier: MIT
#include "wire/bench_message.h"

#include "wire/binary_values.h"

namespace edgecase {

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
