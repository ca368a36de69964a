// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "lamina/optimisation/experiment_table.hpp"
#include "lamina/optimisation/goals.hpp"

namespace lamina {

/// A published experiment (examples/tables) and what it was for.
struct PublishedStudy {
  std::string file;
  DesignSpace space;
  std::vector<std::string> response_names;
  Goals goals;

  ExperimentTable table() const {
    return readExperimentTable(std::string(LAMINA_SOURCE_DIR) + "/examples/tables/" + file, space,
                               response_names);
  }
};

inline Variable levelsOf(const std::string& name, const std::vector<double>& levels) {
  return {name, VariableKind::Levels, 0.0, 0.0, levels, {}};
}

/// Light and quickly printed specimens that are stiff enough; their simulated modulus is only predicted.
inline PublishedStudy miniSpecimens() {
  return {"mini_specimens.csv",
          {levelsOf("layer_height_mm", {0.15, 0.3}),
           {"infill_percent", VariableKind::Continuous, 20.0, 100.0, {}, {}},
           levelsOf("perimeters", {1.0, 3.0})},
          {"measured_mpa", "mass_g", "time_s", "simulated_mpa"},
          {{{"mass_g", Sense::Minimise, 0.5},
            {"time_s", Sense::Minimise, 0.5},
            {"simulated_mpa", Sense::Maximise, 0.0}},
           {{"measured_mpa", 2200.0, std::numeric_limits<double>::infinity()}}}};
}

/// Large surface, well joined pores, of a stiffness and size that cells like.
inline PublishedStudy scaffolds(const std::string& file, DesignSpace space) {
  return {file,
          std::move(space),
          {"modulus_mpa", "pore_um", "surface_mm2", "cvi_2_percent"},
          {{{"surface_mm2", Sense::Maximise, 0.5}, {"cvi_2_percent", Sense::Maximise, 0.5}},
           {{"modulus_mpa", 10.0, 1500.0}, {"pore_um", 300.0, 700.0}}}};
}

inline DesignSpace waveSpace() {
  return {levelsOf("amplitude_mm", {0.1, 0.5}), levelsOf("layer_height_mm", {0.15, 0.3}),
          levelsOf("cycles", {5.0, 9.0}), levelsOf("filaments", {5.0, 9.0})};
}

inline PublishedStudy sinusoidalScaffolds() {
  DesignSpace space = waveSpace();
  space.push_back({"wave", VariableKind::Categorical, 0.0, 0.0, {}, {"cosine", "sine", "sine_cosine"}});
  return scaffolds("sinusoidal_scaffolds.csv", space);
}

inline PublishedStudy mirroredScaffolds() { return scaffolds("mirrored_scaffolds.csv", waveSpace()); }

inline PublishedStudy gyroidScaffolds() {
  return scaffolds("gyroid_scaffolds.csv", {levelsOf("layer_height_mm", {0.15, 0.3}),
                                            levelsOf("nominal_porosity_percent", {50.0, 70.0})});
}

}  // namespace lamina
