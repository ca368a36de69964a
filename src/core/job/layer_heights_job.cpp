// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/layer_heights_job.hpp"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "job/modes/part_slicing.hpp"
#include "job/part/part_reading.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/job/modes/slicing_mode.hpp"
#include "lamina/job/output_files.hpp"
#include "lamina/slicing/adaptive_heights/height_table.hpp"
#include "lamina/slicing/planar/layer_plane.hpp"

namespace lamina {
namespace {

constexpr std::size_t kMostFlatsReported = 3;

std::string noteOnHeights(const LayerHeightsReport& report, const SlicingSettings& settings) {
  const auto [least, greatest] =
      std::minmax_element(report.bounds.begin(), report.bounds.end(),
                          [](const LayerBounds& a, const LayerBounds& b) { return a.height() < b.height(); });
  char text[160];
  std::snprintf(text, sizeof text,
                "%zu layers of %.4g to %.4g mm %s; the greatest cusp above the first is %.4g mm",
                report.bounds.size(), least->height(), greatest->height(),
                settings.heights == LayerHeights::File ? "as their table says" : "follow the part's slopes",
                report.greatest_cusp_mm);
  return text;
}

std::string noteOnMissed(const std::vector<MissedFlat>& missed) {
  std::string note = std::to_string(missed.size()) +
                     (missed.size() == 1 ? " level face lies" : " level faces lie") +
                     " between the ends of layers:";
  char text[80];
  for (std::size_t i = 0; i < std::min(missed.size(), kMostFlatsReported); ++i) {
    std::snprintf(text, sizeof text, "%s at %.6g mm, off by %.3g mm", i > 0 ? ";" : "", missed[i].z_mm,
                  missed[i].off_mm);
    note += text;
  }
  return note + (missed.size() > kMostFlatsReported ? "; ..." : "");
}

/// The first layer has its own height whatever the part is like.
double cuspAboveFirst(const Mesh& mesh, const std::vector<LayerBounds>& bounds) {
  if (bounds.empty()) return 0.0;
  return greatestCusp(mesh, {bounds.begin() + 1, bounds.end()});
}

}  // namespace

LayerHeightsReport layerHeightsOf(const Mesh& mesh, const SlicingSettings& settings) {
  const Box3 box = boundingBox(mesh);
  LayerHeightsReport report;
  if (settings.heights == LayerHeights::Equal) {
    report.bounds = stackLayers(box.low.z(), box.high.z(), settings);
    return report;
  }
  if (settings.heights == LayerHeights::Adaptive) {
    AdaptiveLayers layers = adaptiveLayers(mesh, settings);
    report.bounds = std::move(layers.bounds);
    report.missed = std::move(layers.missed);
  } else {
    report.bounds = readHeightTable(settings.heights_file, box.low.z(), box.high.z());
  }
  report.greatest_cusp_mm = cuspAboveFirst(mesh, report.bounds);
  return report;
}

void requireCapableOf(const LayerHeightsReport& report, const JobSettings& settings) {
  if (settings.slicing.heights != LayerHeights::File) return;
  std::vector<double> heights_mm;
  heights_mm.reserve(report.bounds.size());
  for (const LayerBounds& layer : report.bounds) heights_mm.push_back(layer.height());
  requireCapableOfTable(heights_mm, settings);
}

std::vector<std::string> notesOn(const LayerHeightsReport& report, const SlicingSettings& settings) {
  if (settings.heights == LayerHeights::Equal || report.bounds.empty()) return {};
  std::vector<std::string> notes = {noteOnHeights(report, settings)};
  if (!report.missed.empty()) notes.push_back(noteOnMissed(report.missed));
  return notes;
}

LayerHeightsReport runLayerHeightsJob(const SliceJob& job) {
  const SlicingSettings& slicing = job.settings.slicing;
  validate(job.settings);
  if (!hasPlaneLayers(slicing.mode))
    throw InvalidConfig("slicing.mode is '" + slicing.mode +
                        "'; expected planar or inclined: only plane layers have heights of their own");
  requireApart({job.output}, {job.part, slicing.heights_file});
  NoProgress nobody;
  SourcePart source = readSource(job, nobody);
  if (slicing.plane.angle_deg != 0.0)
    source.mesh = turned(std::move(source.mesh), partFromLayers(slicing.plane).conjugate());
  LayerHeightsReport report = layerHeightsOf(source.mesh, slicing);
  requireCapableOf(report, job.settings);
  report.greatest_cusp_mm = cuspAboveFirst(source.mesh, report.bounds);
  if (!job.output.empty()) writeFile(job.output, heightTable(report.bounds));
  return report;
}

}  // namespace lamina
