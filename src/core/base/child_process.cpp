// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/child_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kMostBytes = 64U << 20U;
constexpr int kPollMs = 20;
constexpr std::chrono::seconds kGrace(2);

/// The reading and the writing end of a pipe; children do not inherit them.
class Pipe {
 public:
  Pipe() {
    if (::pipe2(ends_.data(), O_CLOEXEC) != 0)
      throw FileError(std::string("no pipe can be made: ") + std::strerror(errno));
    ::fcntl(ends_[0], F_SETFL, O_NONBLOCK);
  }
  ~Pipe() {
    ::close(ends_[0]);
    closeWritingEnd();
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  int readingEnd() const { return ends_[0]; }
  int writingEnd() const { return ends_[1]; }
  void closeWritingEnd() {
    if (ends_[1] >= 0) ::close(ends_[1]);
    ends_[1] = -1;
  }

  /// What can be read without waiting.
  /// @throws InvalidInput if `text` becomes too long
  void readInto(std::string& text) const {
    std::array<char, 65536> buffer{};
    for (;;) {
      const ssize_t count = ::read(ends_[0], buffer.data(), buffer.size());
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) return;
      text.append(buffer.data(), static_cast<std::size_t>(count));
      if (text.size() > kMostBytes) throw InvalidInput("the program writes more than 64 MB");
    }
  }

 private:
  std::array<int, 2> ends_{-1, -1};
};

class SpawnSettings {
 public:
  SpawnSettings(const Pipe& output, const Pipe& errors, const std::string& folder) {
    ::posix_spawn_file_actions_init(&actions_);
    ::posix_spawnattr_init(&attributes_);
    ::posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_adddup2(&actions_, output.writingEnd(), STDOUT_FILENO);
    ::posix_spawn_file_actions_adddup2(&actions_, errors.writingEnd(), STDERR_FILENO);
    if (!folder.empty()) ::posix_spawn_file_actions_addchdir_np(&actions_, folder.c_str());
    sigset_t none;
    ::sigemptyset(&none);
    sigset_t all;
    ::sigfillset(&all);
    ::posix_spawnattr_setsigmask(&attributes_, &none);
    ::posix_spawnattr_setsigdefault(&attributes_, &all);
    ::posix_spawnattr_setpgroup(&attributes_, 0);
    ::posix_spawnattr_setflags(&attributes_,
                               POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  }
  ~SpawnSettings() {
    ::posix_spawn_file_actions_destroy(&actions_);
    ::posix_spawnattr_destroy(&attributes_);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;

  const posix_spawn_file_actions_t* actions() const { return &actions_; }
  const posix_spawnattr_t* attributes() const { return &attributes_; }

 private:
  posix_spawn_file_actions_t actions_{};
  posix_spawnattr_t attributes_{};
};

/// A process and all that it started; none of it lives longer than this.
class ProcessGroup {
 public:
  explicit ProcessGroup(pid_t leader) : leader_(leader) {}
  ~ProcessGroup() { end(); }
  ProcessGroup(const ProcessGroup&) = delete;
  ProcessGroup& operator=(const ProcessGroup&) = delete;

  /// Whether the leader runs no more. Until `exitCode` its number belongs to nobody else, unless it is lost.
  bool hasEnded() const { return leaderNow() != Leader::Runs; }

  /// Ends what is left, and reports how the leader ended.
  /// @throws FileError if that is not to be known
  int exitCode() {
    end();
    if (!is_known_)
      throw FileError("how a program ended is not known: this process ignores SIGCHLD or waits elsewhere");
    return WIFSIGNALED(status_) ? 128 + WTERMSIG(status_) : WEXITSTATUS(status_);
  }

 private:
  /// Lost: somebody else has taken notice of its end, and its number may be another's by now.
  enum class Leader { Runs, HasEnded, IsLost };

  Leader leaderNow() const {
    siginfo_t found{};
    if (::waitid(P_PID, static_cast<id_t>(leader_), &found, WEXITED | WNOHANG | WNOWAIT) != 0)
      return Leader::IsLost;
    return found.si_pid == leader_ ? Leader::HasEnded : Leader::Runs;
  }

  void end() {
    if (is_over_) return;
    is_over_ = true;
    if (!hasEnded()) {
      ::kill(-leader_, SIGTERM);
      const Clock::time_point last = Clock::now() + kGrace;
      while (!hasEnded() && Clock::now() < last) ::usleep(1000U * kPollMs);
    }
    if (leaderNow() == Leader::IsLost) return;
    ::kill(-leader_, SIGKILL);
    pid_t waited = 0;
    do waited = ::waitpid(leader_, &status_, 0);
    while (waited < 0 && errno == EINTR);
    is_known_ = waited == leader_;
  }

  pid_t leader_;
  int status_ = 0;
  bool is_over_ = false;
  bool is_known_ = false;  ///< status_
};

/// Ends a process group, and removes a folder, if this process does not live to do so: a shell that reads
/// from a pipe of which nobody else has the writing end.
class Watcher {
 public:
  Watcher(pid_t leader, const std::string& scratch) {
    std::array<std::string, 6> words = {"/bin/sh",
                                        "-c",
                                        "read -r over; kill -9 -\"$1\"; [ -z \"$2\" ] || rm -rf -- \"$2\"",
                                        "watcher",
                                        std::to_string(leader),
                                        scratch};
    std::array<char*, 7> pointers{};
    for (std::size_t i = 0; i < words.size(); ++i) pointers[i] = words[i].data();
    posix_spawn_file_actions_t actions{};
    ::posix_spawn_file_actions_init(&actions);
    ::fcntl(pipe_.readingEnd(), F_SETFL, 0);
    ::posix_spawn_file_actions_adddup2(&actions, pipe_.readingEnd(), STDIN_FILENO);
    ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    ::posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    posix_spawnattr_t attributes{};
    ::posix_spawnattr_init(&attributes);
    ::posix_spawnattr_setpgroup(&attributes, 0);
    ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    const int error = ::posix_spawn(&shell_, pointers[0], &actions, &attributes, pointers.data(), environ);
    ::posix_spawn_file_actions_destroy(&actions);
    ::posix_spawnattr_destroy(&attributes);
    if (error != 0) throw FileError(std::string("cannot start '/bin/sh': ") + std::strerror(error));
  }
  ~Watcher() {
    ::kill(shell_, SIGKILL);
    while (::waitpid(shell_, nullptr, 0) < 0 && errno == EINTR) continue;
  }
  Watcher(const Watcher&) = delete;
  Watcher& operator=(const Watcher&) = delete;

 private:
  Pipe pipe_;
  pid_t shell_ = 0;
};

void requireUsable(const ProgramCall& call) {
  if (call.arguments.empty() || call.arguments.front().empty()) throw InvalidConfig("no program is named");
  for (const std::string& argument : call.arguments)
    if (argument.find('\0') != std::string::npos)
      throw InvalidConfig("an argument of '" + call.arguments.front() + "' holds a zero byte");
}

pid_t spawned(const ProgramCall& call, const SpawnSettings& settings) {
  std::vector<std::string> arguments = call.arguments;
  std::vector<char*> pointers;
  pointers.reserve(arguments.size() + 1);
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  pid_t child = 0;
  const int error = ::posix_spawnp(&child, pointers[0], settings.actions(), settings.attributes(),
                                   pointers.data(), environ);
  if (error != 0) throw FileError("cannot start '" + call.arguments.front() + "': " + std::strerror(error));
  return child;
}

/// Until the leader has ended.
void gather(const ProcessGroup& group, const ProgramCall& call, const Progress& progress,
            const std::array<const Pipe*, 2>& pipes, const std::array<std::string*, 2>& texts) {
  const auto limit =
      std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(call.time_limit_s));
  const Clock::time_point last = Clock::now() + limit;
  for (;;) {
    const bool has_ended = group.hasEnded();
    for (std::size_t i = 0; i < pipes.size(); ++i) pipes[i]->readInto(*texts[i]);
    if (has_ended) return;
    throwIfCancelled(progress, call.arguments.front());
    if (Clock::now() >= last)
      throw TimedOut("'" + call.arguments.front() + "' runs longer than " + numberText(call.time_limit_s) +
                     " s");
    std::array<pollfd, 2> ready{{{pipes[0]->readingEnd(), POLLIN, 0}, {pipes[1]->readingEnd(), POLLIN, 0}}};
    // A pipe that is closed is always ready; the leader may go on without it.
    if (::poll(ready.data(), ready.size(), kPollMs) > 0 &&
        ((ready[0].revents | ready[1].revents) & POLLIN) == 0)
      ::usleep(1000U * kPollMs);
  }
}

}  // namespace

ProgramEnd runProgram(const ProgramCall& call, const Progress& progress) {
  requireUsable(call);
  throwIfCancelled(progress, call.arguments.front());
  Pipe output;
  Pipe errors;
  const SpawnSettings settings(output, errors, call.folder);
  const pid_t leader = spawned(call, settings);
  ProcessGroup group(leader);
  const Watcher watcher(leader, call.scratch);
  output.closeWritingEnd();
  errors.closeWritingEnd();
  ProgramEnd end;
  gather(group, call, progress, {&output, &errors}, {&end.output, &end.errors});
  end.exit_code = group.exitCode();
  return end;
}

std::string siblingProgram(const std::string& name) {
  std::error_code unreachable;
  const auto own = std::filesystem::read_symlink("/proc/self/exe", unreachable);
  if (unreachable) return name;
  const auto sibling = own.parent_path() / name;
  return std::filesystem::exists(sibling, unreachable) ? sibling.string() : name;
}

}  // namespace lamina
