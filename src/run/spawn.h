// SPDX-License-Identifier: MIT
//
// Starting a program with pipes to its standard streams, in a process group of its own that dies
// with our process, however that ends.
#pragma once

#include <sys/types.h>

#include <map>
#include <string>
#include <variant>
#include <vector>

namespace edgecase {

// A program and its surroundings.
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

}  // namespace edgecase
