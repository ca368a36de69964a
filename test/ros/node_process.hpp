// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <string>
#include <vector>

namespace lamina::test {

/// A node that a test starts and ends by itself.
class NodeProcess {
 public:
  NodeProcess(const std::string& executable, const std::vector<std::string>& arguments) {
    std::vector<std::string> all{executable};
    all.insert(all.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& argument : all) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    process_ = fork();
    if (process_ != 0) return;
    execv(executable.c_str(), pointers.data());
    _exit(127);
  }
  NodeProcess(const NodeProcess&) = delete;
  NodeProcess& operator=(const NodeProcess&) = delete;
  ~NodeProcess() {
    if (process_ > 0) end(SIGINT);
  }

  pid_t id() const { return process_; }

  /// Sends the signal and waits for the end.
  /// @return exit code; -1 if a signal ended it
  int end(int signal) {
    if (process_ == 0) return -1;
    kill(process_, signal);
    return wait();
  }

  /// True once it has ended, by itself or by a signal.
  bool isOver() {
    if (process_ == 0) return true;
    int status = 0;
    if (waitpid(process_, &status, WNOHANG) != process_) return false;
    process_ = 0;
    return true;
  }

  /// Waits for the end that it comes to by itself, and returns the same.
  int wait() {
    int status = 0;
    waitpid(process_, &status, 0);
    process_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

 private:
  pid_t process_ = 0;
};

}  // namespace lamina::test
