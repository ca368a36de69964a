// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lamina/job/metrics_job.hpp"
#include "lamina/optimisation/evaluation.hpp"
#include "lamina/study/study.hpp"

namespace lamina {

/// Measures the responses of a study at points of its space, by slicing or by commands. Points may be
/// measured from several threads at once.
class StudyMeasurement {
 public:
  /// Reads the part, and checks what can be checked before any point is tried: names of settings, both bounds
  /// of variables that are settings, and names of metrics.
  /// @throws InvalidConfig naming variable, key, value and bound; InvalidMesh, FileError
  explicit StudyMeasurement(const Study& study);

  const std::vector<std::string>& responseNames() const { return response_names_; }
  /// The responses at a point.
  /// @throws InvalidInput if the study has only a table; as slicing, metrics and commands
  std::vector<double> at(const DesignPoint& point, Progress& progress) const;

  /// Names of the responses that are measured again for points of the front: of slicing, the front's metrics
  /// of the study or, if it names none, all metrics; of commands, `responseNames`.
  const std::vector<std::string>& frontResponseNames() const { return front_response_names_; }
  /// The responses `frontResponseNames` at a point.
  /// @throws as `at`
  std::vector<double> inFull(const DesignPoint& point, Progress& progress) const;

  /// The responses `frontResponseNames` for the settings of a baseline.
  /// @throws InvalidInput if the study does not slice; as slicing and metrics
  std::vector<double> ofBaseline(const Baseline& baseline, Progress& progress) const;

  /// The configuration at a point, as YAML: if the study slices, the complete settings, which `lamina slice
  /// --config` reads; otherwise the variables alone.
  std::string configurationAt(const DesignPoint& point) const;

  /// A hash, as 16 hexadecimal digits, of what responses depend on besides the point: settings, commands, the
  /// version of Lamina, and the contents of files: the part, its base, modifiers with their meshes, the table
  /// of heights, and the machine's description, including files that variables and baselines name. Meshes
  /// named by the description, and files named by commands, are not included.
  /// @throws FileError; InvalidConfig as `readModifiersFile` and `readMachineDescription`
  std::string fingerprint() const;

 private:
  std::vector<SettingText> overridesAt(const DesignPoint& point) const;

  Study study_;
  std::vector<std::string> response_names_;
  std::vector<std::string> front_response_names_;
  std::shared_ptr<const SliceMeasurement> slices_;
  PointMeasurement commands_;
};

}  // namespace lamina
