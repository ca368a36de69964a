// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program_layers.hpp"

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/program/gcode/gcode_reader.hpp"

namespace lamina {
namespace {

constexpr std::size_t kMostPoints = 1000000;  // of all layers: 8 MB
constexpr std::uintmax_t kMostBytes = std::uintmax_t{256} << 20;
constexpr double kSameHeight = 1e-4;  // [mm]
constexpr double kMetres = 1e-3;      // [m/mm]

/// Gathers motions that deposit into lines, layer by layer.
class LayerGatherer {
 public:
  void take(const GcodeMotion& motion) {
    const bool is_deposit = motion.extrusion_mm > 0.0 && (motion.end - motion.start).head<2>().norm() > 0.0;
    if (!is_deposit) {
      is_joined_ = false;
      return;
    }
    if (layers_.empty() || isNext(motion)) begin(motion);
    add(motion);
  }

  std::vector<LayerPreview> layers() && {
    for (LayerPreview& layer : layers_) layer.layers = static_cast<std::int32_t>(layers_.size());
    return std::move(layers_);
  }

 private:
  bool isNext(const GcodeMotion& motion) const {
    if (motion.layer) return motion.layer != layer_;
    return std::abs(motion.end.z() - z_mm_) > kSameHeight;
  }

  void begin(const GcodeMotion& motion) {
    layer_ = motion.layer;
    z_mm_ = motion.end.z();
    LayerPreview layer;
    layer.layer = static_cast<std::int32_t>(layers_.size());
    layer.z_m = z_mm_ * kMetres;
    layers_.push_back(std::move(layer));
    is_joined_ = false;
  }

  void add(const GcodeMotion& motion) {
    LayerPreview& layer = layers_.back();
    if (points_ >= kMostPoints) {
      layer.is_cut_short = true;
      return;
    }
    const auto put = [&](const Point3& point) {
      layer.lines.back().push_back(static_cast<float>(point.x() * kMetres));
      layer.lines.back().push_back(static_cast<float>(point.y() * kMetres));
      ++points_;
    };
    if (!is_joined_) {
      layer.lines.emplace_back();
      put(motion.start);
    }
    put(motion.end);
    is_joined_ = true;
  }

  std::vector<LayerPreview> layers_;
  std::optional<int> layer_;
  double z_mm_ = 0.0;
  bool is_joined_ = false;
  std::size_t points_ = 0;
};

}  // namespace

std::vector<LayerPreview> layersOf(const std::string& program, const std::atomic<bool>& is_unwanted) {
  std::error_code error;
  const auto bytes = std::filesystem::file_size(program, error);
  if (!error && bytes > kMostBytes)
    throw InvalidInput(program + " has " + std::to_string(bytes) + " bytes; expected at most " +
                       std::to_string(kMostBytes) + " to be drawn");
  LayerGatherer gatherer;
  GcodeHandlers handlers;
  handlers.motion = [&](const GcodeMotion& motion) {
    if (is_unwanted) throw InvalidInput(program + " is not wanted any more");
    gatherer.take(motion);
  };
  readGcodeFile(program, {}, handlers);
  return std::move(gatherer).layers();
}

}  // namespace lamina
