// SPDX-License-Identifier: MIT
//
// A project's settings: edgecase.toml, which says once what would be said with every command. The
// page reports/pages/renderers.md shows its keys.
//
// Every key is an option, and an option on the command line wins. Paths count from the file's
// folder, and programs are started there, so that it does not matter in which folder of the project
// a command runs.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace edgecase {

// What is wrong with a project's file: "edgecase.toml:3: …", one line, with the remedy.
struct ProjectError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Project {
  std::filesystem::path folder;                  // of the file, from here
  std::map<std::string, std::string> renderers;  // name -> address
  // The name of an option, or of a command's words, and what the file gives it.
  std::map<std::string, std::vector<std::string>> options;

  // Gives the command what its own options, which are parsed, do not say.
  void give(CLI::App& command) const;
  // Throws ProjectError where the name is nearly that of one of its renderers.
  void refuse_misspelt(const std::string& renderer) const;
};

// --config of commands that obey a project's file, and the variable EDGECASE_CONFIG.
void add_config_option(CLI::App& command, std::string& config);

// The project of the file `config`, or, where that is empty, of the nearest edgecase.toml from this
// folder upward; nothing where there is none. Throws ProjectError.
std::optional<Project> find_project(const std::string& config);

}  // namespace edgecase
