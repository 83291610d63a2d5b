// SPDX-License-Identifier: MIT
#include "tools/edgecase_webgl/browser.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace edgecase {
namespace {

namespace fs = std::filesystem;

// The first of the programs that is in PATH; empty if none is.
std::string find_program(std::initializer_list<const char*> names) {
  const char* path = std::getenv("PATH");
  for (const char* name : names) {
    std::istringstream folders(path == nullptr ? "" : path);
    for (std::string folder; std::getline(folders, folder, ':');) {
      const std::string file = folder + "/" + name;
      if (access(file.c_str(), X_OK) == 0) return file;
    }
  }
  return "";
}

using Found = std::variant<BrowserCommand, std::string>;

// The page in the profile with which a browser begins.
constexpr const char* kStartPage = "start.html";

std::string start_of(const std::string& folder) {
  return fs::absolute(fs::path(folder) / kStartPage).string();
}

Found chromium(bool upon_gl, const std::string& folder) {
  const std::string program =
      find_program({"chromium", "chromium-browser", "google-chrome", "google-chrome-stable"});
  if (program.empty()) return "there is no chromium in PATH; Debian has it in the package chromium";
  BrowserCommand command{{program, "--headless=new", "--user-data-dir=" + folder, "--no-first-run",
                          "--disable-background-networking", "--disable-dev-shm-usage",
                          "--disable-extensions", "--disable-renderer-backgrounding"},
                         {}};
  // Its sandbox does not work for the superuser.
  if (geteuid() == 0) command.argv.push_back("--no-sandbox");
  const std::vector<std::string> driver =
      upon_gl ? std::vector<std::string>{"--use-gl=angle", "--use-angle=gl-egl",
                                         "--ignore-gpu-blocklist"}
              : std::vector<std::string>{"--use-angle=swiftshader", "--enable-unsafe-swiftshader"};
  command.argv.insert(command.argv.end(), driver.begin(), driver.end());
  command.argv.push_back(start_of(folder));
  return command;
}

// Without a display it has no WebGL 2, so it gets one that nobody sees.
Found firefox(const std::string& folder) {
  const std::string program = find_program({"firefox-esr", "firefox"});
  if (program.empty())
    return "there is no firefox in PATH; Debian has it in the package firefox-esr";
  const std::string display = find_program({"xvfb-run"});
  if (display.empty()) return "there is no xvfb-run in PATH; Debian has it in the package xvfb";
  constexpr const char* kPreferences =
      "user_pref(\"webgl.force-enabled\", true);\n"
      "user_pref(\"webgl.sanitize-unmasked-renderer\", false);\n"
      "user_pref(\"app.update.enabled\", false);\n"
      "user_pref(\"browser.shell.checkDefaultBrowser\", false);\n"
      "user_pref(\"browser.aboutwelcome.enabled\", false);\n"
      "user_pref(\"datareporting.policy.dataSubmissionEnabled\", false);\n"
      "user_pref(\"network.captive-portal-service.enabled\", false);\n"
      "user_pref(\"network.connectivity-service.enabled\", false);\n";
  return BrowserCommand{
      {display, "-a", program, "--no-remote", "--profile", folder, start_of(folder)},
      {"user.js", kPreferences}};
}

// Removes the folder, and kills the process group of the worker, when that has ended: it may be
// killed before it can do so. Runs in a process of its own, outside of that group, and never
// returns; `life` ends with the worker.
[[noreturn]] void clean_up_after(int life, const std::string& folder, pid_t worker) {
  constexpr int kMostAttempts = 100;
  setsid();
  const int nothing = open("/dev/null", O_RDWR);
  dup2(life, STDIN_FILENO);
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) dup2(nothing, stream);
  close_range(STDERR_FILENO + 1, ~0U, 0);
  char byte = 0;
  while (read(STDIN_FILENO, &byte, 1) < 0 && errno == EINTR) {
  }
  ::kill(-worker, SIGKILL);
  std::error_code ignored;
  for (int i = 0; i < kMostAttempts; ++i) {
    fs::remove_all(folder, ignored);
    if (!fs::exists(folder, ignored)) break;
    usleep(20'000);
  }
  _exit(0);
}

}  // namespace

Found find_browser(const std::string& name, const std::string& folder, const std::string& url) {
  Found found = "there is no browser \"" + name + "\"; known are chromium, chromium-gl and firefox";
  if (name == "chromium" || name == "chromium-gl") found = chromium(name == "chromium-gl", folder);
  if (name == "firefox") found = firefox(folder);
  if (auto* command = std::get_if<BrowserCommand>(&found))
    command->files.insert(command->files.end(), {kStartPage,
                                                 "<!doctype html><meta charset=\"utf-8\"><script>"
                                                 "location.replace(\"" +
                                                     url + "\")</script>\n"});
  return found;
}

Browser::Browser() {
  std::string pattern = (fs::temp_directory_path() / "edgecase-webgl-XXXXXX").string();
  std::array<int, 2> life{};
  if (mkdtemp(pattern.data()) == nullptr || pipe2(life.data(), O_CLOEXEC) != 0)
    throw std::runtime_error(std::string("no folder can be made: ") + std::strerror(errno));
  folder_ = pattern;
  const pid_t worker = getpid();
  // Where we lead no process group, as for somebody who tries this program, nothing else is in it.
  if (fork() == 0) clean_up_after(life[0], folder_, worker);
  close(life[0]);
}

void Browser::start(const BrowserCommand& command) {
  for (std::size_t i = 0; i + 1 < command.files.size(); i += 2)
    std::ofstream(fs::path(folder_) / command.files[i]) << command.files[i + 1];
  std::vector<std::string> words = command.argv;
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const pid_t worker = getpid();
  pid_ = fork();
  if (pid_ < 0) throw std::runtime_error(std::string("no process: ") + std::strerror(errno));
  if (pid_ > 0) return;
  // It ends with us, however we end.
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != worker) _exit(1);
  const int nothing = open("/dev/null", O_RDWR);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(nothing, stream);
  setenv("TMPDIR", folder_.c_str(), 1);
  execv(argv[0], argv.data());
  _exit(1);
}

void Browser::wait() const {
  while (waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

}  // namespace edgecase
