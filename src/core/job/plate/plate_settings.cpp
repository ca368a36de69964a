// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/plate/plate_settings.hpp"

namespace lamina {

const char* toString(ObjectLabels labels) {
  switch (labels) {
    case ObjectLabels::None:
      return "none";
    case ObjectLabels::M486:
      return "m486";
    case ObjectLabels::ExcludeObject:
      return "exclude_object";
  }
  return "";
}

void describe(SettingsSchema& schema, PlateSettings& settings) {
  schema.choice<PlateArrangement>(
      "plate.arrange", settings.arrangement,
      {{"none", PlateArrangement::None}, {"rows", PlateArrangement::Rows}, {"pack", PlateArrangement::Pack}},
      "Where parts of a plate stand that have no place of their own.");
  schema.number("plate.spacing_mm", settings.spacing_mm, {0.0, 1e4},
                "Distance between parts that are arranged.");
  schema.choice<PlateOrder>("plate.order", settings.order,
                            {{"by_layer", PlateOrder::ByLayer}, {"by_part", PlateOrder::ByPart}},
                            "Parts of a plate layer by layer, or one after the other.");
  schema.choice<ObjectLabels>("plate.labels", settings.labels,
                              {{"none", ObjectLabels::None},
                               {"m486", ObjectLabels::M486},
                               {"exclude_object", ObjectLabels::ExcludeObject}},
                              "Commands by which a host or firmware can leave out a part of a plate.");
}

}  // namespace lamina
