// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/job/slice_job.hpp"
#include "lamina/metrics/toolpath_metrics.hpp"

namespace lamina {

/// Slices one part by many different settings and measures the toolpaths. The part is read once; nothing is
/// written.
class SliceMeasurement {
 public:
  /// @param job  part and settings; its output is not used
  /// @throws InvalidMesh, FileError, InvalidConfig as `runSliceJob`
  explicit SliceMeasurement(SliceJob job);
  ~SliceMeasurement();
  SliceMeasurement(SliceMeasurement&&) noexcept;
  SliceMeasurement& operator=(SliceMeasurement&&) noexcept;

  /// Slices the part by the job's settings with some of them changed, and measures the toolpath. May be
  /// called from several threads at once.
  /// @param overrides  settings to change, in order; none of input.* or conformal.base, as the part is
  ///   already read
  /// @param metrics    names from `metricNames`; others are not computed
  /// @return one value for each of `metrics`
  /// @throws InvalidConfig, InvalidInput, InvalidMesh, Unreachable, Cancelled as `runSliceJob`
  std::vector<double> measure(const std::vector<SettingText>& overrides,
                              const std::vector<std::string>& metrics, Progress& progress) const;

 private:
  struct Source;
  std::unique_ptr<const Source> source_;
  SliceJob job_;
};

}  // namespace lamina
