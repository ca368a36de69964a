// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/modes/slicing_mode.hpp"

#include <filesystem>
#include <map>
#include <utility>

#include "job/modes/part_planning.hpp"

namespace lamina {
namespace {

SlicingMode triedByAuto(SlicingMode mode, AutoTrial trial, int turn) {
  mode.auto_trial = trial;
  mode.auto_turn = turn;
  return mode;
}

SlicingMode bent(PlanFunction plan) { return {std::move(plan), LayerShape::Bent}; }

std::map<std::string, SlicingMode> builtInModes() {
  const SlicingMode plane{planPlanar, LayerShape::Plane};
  return {
      {"adapted", triedByAuto(bent(planAdapted), AutoTrial::TiltingHead, 2)},
      {"conformal", {planConformal, LayerShape::Bent, FirstLayer::SameHeight, DepositedOn::Base}},
      {"curved", {planCurved, LayerShape::Bent, FirstLayer::SameHeight}},
      {"heightfield", bent(planHeightField)},
      {"inclined", plane},  // as planar; validate requires an angle
      {"multi_direction", triedByAuto(bent(planMultiDirection), AutoTrial::TiltingHead, 1)},
      {"planar", triedByAuto(plane, AutoTrial::AnyHead, 0)},
      {"volumetric", triedByAuto(bent(planVolumetric), AutoTrial::TiltingHead, 3)},
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
