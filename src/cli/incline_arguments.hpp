// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "lamina/job/incline_job.hpp"

namespace lamina::cli {

/// The command line of `lamina incline` as it was typed. Empty is not given.
struct InclineArguments {
  std::string program;
  std::string output;
  std::string map = "rotation";
  std::optional<double> angle_deg;
  std::string axis;
  std::vector<double> factors;
  std::vector<double> matrix;
  std::string shear;
  double belt_deg = 0.0;
  std::string begin_code;
  std::string end_code;
  std::vector<double> table_position;
  std::vector<double> offset;
  std::vector<double> final_position;
  std::string machine;
  std::vector<double> limits;
  double layer_height_mm = 0.0;
  int decimals = -1;
  std::string extrusion;
  TransformSettings settings;
};

void addOptions(CLI::App& subcommand, InclineArguments& arguments);

/// @throws InvalidConfig if options do not go together
/// @throws FileError if begin or end code cannot be read
InclineJob jobFrom(const InclineArguments& arguments);

}  // namespace lamina::cli
