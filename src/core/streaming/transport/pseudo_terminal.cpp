// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/transport/pseudo_terminal.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

void makeRaw(int descriptor) {
  struct termios options {};
  ::tcgetattr(descriptor, &options);
  ::cfmakeraw(&options);
  ::tcsetattr(descriptor, TCSANOW, &options);
}

}  // namespace

PseudoTerminal::PseudoTerminal() {
  machine_ = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  char name[128] = {};
  const bool is_open = machine_ >= 0 && ::grantpt(machine_) == 0 && ::unlockpt(machine_) == 0 &&
                       ::ptsname_r(machine_, name, sizeof name) == 0;
  if (is_open) user_ = ::open(name, O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (user_ < 0) {
    const std::string why = std::strerror(errno);
    if (machine_ >= 0) ::close(machine_);
    throw DeviceError("cannot open a pseudo-terminal: " + why);
  }
  path_ = name;
  makeRaw(user_);
}

PseudoTerminal::~PseudoTerminal() {
  if (machine_ >= 0) ::close(machine_);
  ::close(user_);
}

int PseudoTerminal::releaseMachineSide() {
  const int machine = machine_;
  machine_ = -1;
  return machine;
}

SymbolicLink::~SymbolicLink() { remove(); }

void SymbolicLink::remove() {
  if (is_made_) ::unlink(path_.c_str());
  is_made_ = false;
}

void SymbolicLink::pointTo(const std::string& target) {
  struct stat about {};
  if (::lstat(path_.c_str(), &about) == 0 && !S_ISLNK(about.st_mode)) {
    throw FileError("cannot link " + path_ + " to the pseudo-terminal: something else has that name");
  }
  // Made beside and renamed, so that the name never points to nothing.
  const std::string fresh = path_ + "." + std::to_string(::getpid());
  ::unlink(fresh.c_str());
  if (::symlink(target.c_str(), fresh.c_str()) != 0 || std::rename(fresh.c_str(), path_.c_str()) != 0) {
    throw FileError("cannot link " + path_ + " to the pseudo-terminal: " + std::strerror(errno));
  }
  is_made_ = true;
}

}  // namespace lamina
