// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/planning/plan_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "planning/travel/comb_area.hpp"
#include "planning/travel/travel.hpp"

namespace lamina {

/// Makes the travels within one layer: straight, or combed inside the part, retracted and lifted by the
/// settings. The area for combing is computed when it is first needed.
class LayerTravels {
 public:
  LayerTravels(const TravelSettings& settings, double bead_width_mm)
      : settings_(settings), bead_width_mm_(bead_width_mm) {}

  /// @param material  material of the layer; must outlive the object
  void setMaterial(const Regions& material) { material_ = &material; }
  /// Adds a top skin that was deposited.
  void addSeen(const Regions& top_skin);
  /// All top skins that were deposited.
  const Regions& seen() const { return seen_; }
  void setSeen(const Regions& top_skins);

  /// The travel between two points of the layer, none if they are the same.
  std::optional<Path> between(const Point3& from, const Point3& to, TravelOver over);

 private:
  const CombArea& area();
  std::optional<Polyline> combed(const Point2& from, const Point2& to);
  bool crossesSeen(const Polyline& way) const;
  Path along(const Polyline& way, double z) const;

  const TravelSettings& settings_;
  double bead_width_mm_;
  const Regions* material_ = nullptr;
  Regions seen_;
  std::optional<CombArea> area_;
};

}  // namespace lamina
