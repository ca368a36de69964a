// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "lamina/job/job_settings.hpp"
#include "subcommand.hpp"

namespace lamina::cli {

/// Further arguments of `lamina fill-voids` for programs of drops.
struct DropFillArguments {
  std::string overlap;
  std::string definition;
  std::string detector;
  std::string sweep;
  bool iterates = false;
};

void addTo(CLI::App& subcommand, DropFillArguments& arguments);

/// The arguments as settings.
std::vector<SettingText> overridesOf(const DropFillArguments& arguments);

/// Outputs are empty for none.
struct DropFillFiles {
  std::string program;
  std::string output;
  std::string sweep;
};

/// Fills the voids of a program of drops and reports the result.
void fillDropVoids(const DropFillFiles& files, const JobSettings& settings, OutputFormat format);

}  // namespace lamina::cli
