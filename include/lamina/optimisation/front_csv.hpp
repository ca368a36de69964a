// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/optimisation/design_space.hpp"
#include "lamina/optimisation/evaluation.hpp"

namespace lamina {

/// A point of a front as it stands in a file.
struct FrontRow {
  std::vector<std::string> values;  ///< of the variables, as they stand in a configuration
  std::vector<double> responses;    ///< not a number where the cell is empty
  std::size_t line = 0;             ///< of the file, from 1
};

/// A front as it stands in a file.
struct FrontTable {
  std::string source;  ///< names the file in errors
  std::vector<std::string> variables;
  std::vector<std::string> responses;
  std::vector<FrontRow> rows;
};

/// The front as a table (.csv): a line `# variables N`, a header, and a row for each point with its N
/// variables and then its responses. Responses that are not finite, and those of what could not be tried, are
/// left empty.
std::string frontCsv(const DesignSpace& space, const std::vector<std::string>& response_names,
                     const std::vector<Evaluation>& front);

/// Reads what `frontCsv` wrote, or somebody typed in its way.
/// @throws FileError; InvalidInput naming file and line if the number of variables is missing or
///   greater than the number of columns, there is no row, or a response is no number
FrontTable readFrontCsv(const std::string& path);

}  // namespace lamina
