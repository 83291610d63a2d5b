// SPDX-License-Identifier: MIT
//
// ChildProcess: a program that answers lines with lines, or messages with messages. A message is
// its number of bytes (eight bytes, in the byte order of this machine) and the bytes.
//
// Writing, reading and draining its standard error happen in one poll loop with a deadline, so that
// no program can block us: one that does not read, one that answers without end, one that fills its
// standard error. The program runs in a process group of its own (Ctrl-C is ours to handle). The
// group dies with this object, and with our process, however that ends; what the program has
// started outside of its group dies with this object, too, or with the last one
// (processes/process_tree.h). A write to a dead program is an error here, never a SIGPIPE.
//
// processes/process_renderer.h knows about scenes, and restarts programs.
#pragma once

#include <sys/types.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace edgecase {

// A program and its surroundings. spawn() starts it with pipes to its standard streams.
struct Command {
  std::vector<std::string> argv;  // argv[0]: a path, or a name that is looked up in PATH
  std::map<std::string, std::string> environment;  // added to, or replacing, our own
  std::vector<std::string> unset;                  // removed from our own
  std::string folder{};                            // that it is started in; empty: our own
};

// A file descriptor that closes itself.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(other.number_) { other.number_ = -1; }
  Descriptor& operator=(Descriptor&& other) noexcept;
  ~Descriptor() { close(); }
  void close();
  int number() const { return number_; }
  bool is_open() const { return number_ >= 0; }

 private:
  int number_;
};

// A program that runs. Our ends do not block.
struct Spawned {
  pid_t pid = -1;     // and its group; whoever has this reaps it
  Descriptor input;   // its standard input, where we write
  Descriptor output;  // its standard output, where we read
  Descriptor errors;
  Descriptor life;  // its group is killed when this is closed
};

// Starts the program, or says why it cannot be started.
std::variant<Spawned, std::string> spawn(const Command& command);

class ChildProcess {
 public:
  using Clock = std::chrono::steady_clock;

  enum class Status {
    answered,   // a whole line or message came
    ended,      // the program ended, or closed its output
    timed_out,  // the deadline passed
    too_long,   // more than max_line_length bytes came without a line break, or were announced
    stopped,    // `stop` became true
  };

  // Starts the program, or says why it cannot be started.
  static std::variant<std::unique_ptr<ChildProcess>, std::string> start(const Command& command);

  // Asks the program to end by closing its input, gives it a moment, then kills its group.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  // Writes `request` and a line break, and reads one line into `answer`, without its line break.
  // `stop`, which may be null, is checked ten times a second. After any status but `answered` the
  // program must not be used any more.
  Status exchange(std::string_view request, std::string& answer, std::size_t max_line_length,
                  Clock::time_point deadline, const std::atomic<bool>* stop = nullptr);

  // Sends a message as far as the pipe takes it; receive() sends the rest. Messages are answered in
  // their order.
  void send(std::string_view message);

  // Waits for the next answer, with the statuses of exchange(). `answer` is valid until the next
  // call.
  Status receive(std::string_view& answer, std::size_t max_length, Clock::time_point deadline,
                 const std::atomic<bool>* stop = nullptr);
  // Frees the memory of the last message if it is large. The message must not be used any more.
  void forget_message();

  // The output beyond the line that exchange() returned last: "" if the program answers one line
  // for each request. Waits for `patience` or until something comes.
  const std::string& unasked_output(std::chrono::milliseconds patience);

  // Closes its input and waits: true if the program ended by itself in time. It is reaped in either
  // case. Its output meanwhile counts as unasked.
  bool finish(std::chrono::milliseconds patience);

  // Kills the group and reaps the program. Afterwards the two below are known.
  void kill() { reap(); }

  // How the program ended: "exit status 3", "signal 11 (Segmentation fault)"; "" while it runs, and
  // after kill().
  std::string how_it_ended() const;
  // Its exit status; -1 when it did not exit by itself.
  int exit_status() const;
  // The last 2000 bytes or so that it wrote to standard error.
  const std::string& error_output() const { return error_output_; }

 private:
  explicit ChildProcess(Spawned spawned);

  void write_some();
  bool has_written() const { return sent_ == unsent_.size(); }
  bool read_some();
  void drain_errors();
  bool take_line(std::string& answer);
  bool take_message(std::string_view& answer);
  void make_room();
  std::size_t announced_length() const;
  std::optional<Status> turn(Clock::time_point deadline, const std::atomic<bool>* stop);
  Status end(bool answered);
  bool has_ended();
  bool wait_for_end(std::chrono::milliseconds patience);
  void reap();

  pid_t pid_;            // -1 once reaped
  int wait_status_ = 0;  // as waitpid gives it
  bool ended_by_itself_ = false;
  Descriptor input_;   // its standard input, where we write
  Descriptor output_;  // its standard output, where we read
  Descriptor errors_;
  Descriptor life_;           // while it is open, the program may live
  std::string unsent_;        // what is yet to be written to its input
  std::size_t sent_ = 0;      // bytes of unsent_ that are written already
  std::string received_;      // output that is not yet part of an answer
  std::size_t searched_ = 0;  // bytes of received_ known to hold no line break
  std::size_t taken_ = 0;     // bytes of received_ that were messages and are answered
  std::string error_output_;
};

}  // namespace edgecase
