// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/web/state_bell.hpp"

#include <sys/eventfd.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <string>

#include "lamina/base/error.hpp"

namespace lamina {

StateBell::Ear::Ear(StateBell& bell) : bell_(bell), descriptor_(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {
  if (descriptor_ < 0)
    throw DeviceError(std::string("a page waits for the state, and the system gives no descriptor for it: ") +
                      std::strerror(errno));
  const std::lock_guard<std::mutex> lock(bell_.mutex_);
  bell_.descriptors_.insert(descriptor_);
}

StateBell::Ear::~Ear() {
  {
    const std::lock_guard<std::mutex> lock(bell_.mutex_);
    bell_.descriptors_.erase(descriptor_);
  }
  ::close(descriptor_);
}

void StateBell::Ear::clear() {
  std::uint64_t rings = 0;
  // Nothing to read is nothing to clear.
  if (::read(descriptor_, &rings, sizeof rings) < 0) return;
}

bool StateBell::isHeard() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return !descriptors_.empty();
}

void StateBell::ring() {
  const std::uint64_t once = 1;
  const std::lock_guard<std::mutex> lock(mutex_);
  // One that cannot be written to is full of rings that were not heard yet.
  for (const int descriptor : descriptors_)
    if (::write(descriptor, &once, sizeof once) < 0) continue;
}

}  // namespace lamina
