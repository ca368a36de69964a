// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/transport/serial_baud.hpp"

// The kernel's own termios, which cannot be included together with the library's.
#include <asm/termbits.h>
#include <sys/ioctl.h>

#include <cerrno>
#include <system_error>

namespace lamina {

void setBaudRate(int descriptor, int baud) {
  struct termios2 options {};
  if (::ioctl(descriptor, TCGETS2, &options) == 0) {
    options.c_cflag &= ~static_cast<tcflag_t>(CBAUD);
    options.c_cflag |= BOTHER;
    options.c_ispeed = static_cast<speed_t>(baud);
    options.c_ospeed = static_cast<speed_t>(baud);
    if (::ioctl(descriptor, TCSETS2, &options) == 0) return;
  }
  throw std::system_error(errno, std::generic_category());
}

}  // namespace lamina
