// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>

#include "command_line.hpp"

int main(int argc, char** argv) {
  using namespace lamina::cli;
  try {
    return runCommandLine(argc, argv, {{"alarms", addAlarms}, {"audit", addAudit}, {"record", addRecord}});
  } catch (...) {
    std::fputs("lamina: cannot start; out of memory?\n", stderr);
    return 1;
  }
}
