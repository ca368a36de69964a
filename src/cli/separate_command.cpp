// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "separate_command.hpp"

#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string>

#include "command_line.hpp"
#include "lamina/base/error.hpp"

namespace lamina::cli {
namespace {

struct SeparateCommand {
  const char* name;
  const char* executable;
  const char* description;
};

constexpr std::array kSeparateCommands = {
    SeparateCommand{"alarms", "lamina-journal", kAlarmsDescription},
    SeparateCommand{"audit", "lamina-journal", kAuditDescription},
    SeparateCommand{"decide", "lamina-optimise", kDecideDescription},
    SeparateCommand{"estimate", "lamina-estimate", kEstimateDescription},
    SeparateCommand{"optimise", "lamina-optimise", kOptimiseDescription},
    SeparateCommand{"record", "lamina-journal", kRecordDescription},
    SeparateCommand{"token", "lamina-token", kTokenDescription},
};

}  // namespace

void addSeparateCommands(CLI::App& app, Chosen&) {
  for (const SeparateCommand& command : kSeparateCommands)
    app.add_subcommand(command.name, command.description);
}

void runSeparateCommand(int argc, char** argv) {
  const std::string subcommand = subcommandOf(argc, argv);
  for (const SeparateCommand& command : kSeparateCommands) {
    if (subcommand != command.name) continue;
    const std::string path =
        (std::filesystem::read_symlink("/proc/self/exe").parent_path() / command.executable).string();
    execv(path.c_str(), argv);
    throw FileError("cannot run '" + path + "': " + std::strerror(errno));
  }
}

}  // namespace lamina::cli
