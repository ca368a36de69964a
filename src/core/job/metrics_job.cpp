// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/metrics_job.hpp"

#include <algorithm>

#include "job/modes/part_slicing.hpp"
#include "job/part/shrinkage.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

/// The settings that a part is read by must stay as they were.
void requireOfSlicing(const std::string& key) {
  if (key.rfind("input.", 0) == 0 || key == "conformal.base")
    throw InvalidConfig(key + " cannot change from one evaluation to the next; the part is read once");
}

JobSettings changed(JobSettings settings, const std::vector<SettingText>& overrides) {
  SettingsSchema schema;
  describe(schema, settings);
  for (const SettingText& setting : overrides) {
    requireOfSlicing(setting.key);
    schema.set(setting.key, setting.text);
  }
  validate(settings);
  return settings;
}

std::size_t indexOf(const std::string& metric) {
  const std::vector<std::string> names = metricNames();
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), metric) - names.begin());
}

}  // namespace

struct SliceMeasurement::Source {
  SourcePart part;
};

SliceMeasurement::SliceMeasurement(SliceJob job) : job_(std::move(job)) {
  validate(job_.settings);
  NoProgress nobody;
  source_ = std::make_unique<const Source>(Source{readSource(job_, nobody)});
}
SliceMeasurement::~SliceMeasurement() = default;
SliceMeasurement::SliceMeasurement(SliceMeasurement&&) noexcept = default;
SliceMeasurement& SliceMeasurement::operator=(SliceMeasurement&&) noexcept = default;

std::vector<double> SliceMeasurement::measure(const std::vector<SettingText>& overrides,
                                              const std::vector<std::string>& metrics,
                                              Progress& progress) const {
  const SliceJob job{job_.part, "", changed(job_.settings, overrides)};
  const MetricsSettings asked = onlyFor(metrics, job.settings.metrics);
  const BuildSpace space = buildSpaceOf(job.settings.machine);
  requireToolAxisFor(job, space);
  const SlicedPart sliced = sliceSource(source_->part, job, space, progress);
  const ToolpathMetrics measured =
      changesSize(job.settings.compensation)
          ? measureToolpath(sliced.toolpath, grownForShrinkage(source_->part, job.settings).mesh,
                            sliced.bed_from_part, asked, progress)
          : measureToolpath(sliced.toolpath, source_->part.mesh, sliced.bed_from_part, asked, progress);
  const std::vector<double> all = metricValues(measured);
  std::vector<double> values;
  values.reserve(metrics.size());
  for (const std::string& metric : metrics) values.push_back(all[indexOf(metric)]);
  return values;
}

}  // namespace lamina
