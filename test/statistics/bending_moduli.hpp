// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace lamina {

/// A row of test/data/bending_moduli.csv.
struct BendingModuli {
  std::string layer, infill, perimeters;
  double simulated_mpa = 0.0;
  double mean_mpa = 0.0;       ///< of the measured ones, before they were rounded
  double deviation_mpa = 0.0;  ///< of the sample
  std::vector<double> measured_mpa;
};

inline std::vector<BendingModuli> bendingModuli() {
  std::ifstream file(std::string(LAMINA_TEST_DATA) + "/bending_moduli.csv");
  std::vector<BendingModuli> rows;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#' || line[0] == 'r') continue;
    std::istringstream cells(line);
    std::vector<std::string> row;
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
    BendingModuli read{row[1], row[2], row[3], std::stod(row[4]), std::stod(row[5]), std::stod(row[6]), {}};
    for (std::size_t i = 7; i < row.size(); ++i) read.measured_mpa.push_back(std::stod(row[i]));
    rows.push_back(read);
  }
  return rows;
}

}  // namespace lamina
