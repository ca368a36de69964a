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

/// Measures what a study asks for, by slicing or by commands; from several threads at once.
class StudyMeasurement {
 public:
  /// Reads the part, and checks what can be known before anything is tried: keys and both bounds of variables
  /// that are settings, metrics by name.
  /// @throws InvalidConfig naming variable, key, value and bound; InvalidMesh, FileError
  explicit StudyMeasurement(const Study& study);

  const std::vector<std::string>& responseNames() const { return response_names_; }
  /// @throws InvalidInput if the study has a table alone; what slicing, metrics and commands throw
  std::vector<double> at(const DesignPoint& point, Progress& progress) const;

  /// What is measured once more for a front: all metrics that are asked for; the same as before for commands.
  const std::vector<std::string>& frontResponseNames() const { return front_response_names_; }
  std::vector<double> inFull(const DesignPoint& point, Progress& progress) const;

  /// The same for settings by name.
  std::vector<double> ofBaseline(const Baseline& baseline, Progress& progress) const;

  /// The configuration that a point stands for, as YAML: complete where the variables are settings of
  /// slicing, so that `lamina slice --config` takes it; else the variables alone.
  std::string configurationAt(const DesignPoint& point) const;

  /// All that responses depend on besides the point, as 16 hexadecimal digits: settings, the files of the
  /// part and of the base it lies on, commands, and the version of Lamina. Files that commands read are not
  /// looked into.
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
