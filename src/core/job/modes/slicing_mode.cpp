// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/modes/slicing_mode.hpp"

#include <filesystem>
#include <map>

#include "job/modes/part_planning.hpp"

namespace lamina {
namespace {

std::map<std::string, SlicingMode> builtInModes() {
  const SlicingMode plane{planPlanar, LayerShape::Plane, FirstLayer::OwnHeight, DepositedOn::Bed};
  return {
      {"adapted", {planAdapted, LayerShape::Bent, FirstLayer::OwnHeight, DepositedOn::Bed}},
      {"conformal", {planConformal, LayerShape::Bent, FirstLayer::SameHeight, DepositedOn::Base}},
      {"curved", {planCurved, LayerShape::Bent, FirstLayer::SameHeight, DepositedOn::Bed}},
      {"heightfield", {planHeightField, LayerShape::Bent, FirstLayer::OwnHeight, DepositedOn::Bed}},
      {"inclined", plane},  // as planar; validate requires an angle
      {"multi_direction", {planMultiDirection, LayerShape::Bent, FirstLayer::OwnHeight, DepositedOn::Bed}},
      {"planar", plane},
      {"volumetric", {planVolumetric, LayerShape::Bent, FirstLayer::OwnHeight, DepositedOn::Bed}},
  };
}

}  // namespace

std::string PlanningRequest::partName() const { return std::filesystem::path(job.part).stem().string(); }

Registry<SlicingMode>& slicingModes() {
  static Registry<SlicingMode> registry("slicing.mode", builtInModes());
  return registry;
}

std::vector<std::string> slicingModeNames() {
  std::vector<std::string> names = slicingModes().names();
  names.emplace_back(kAutoMode);
  return names;
}

bool hasPlaneLayers(const std::string& mode) {
  return mode != kAutoMode && slicingModes().find(mode).shape == LayerShape::Plane;
}

}  // namespace lamina
