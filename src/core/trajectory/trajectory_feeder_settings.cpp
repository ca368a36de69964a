// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/trajectory/trajectory_feeder_settings.hpp"

#include <string>

#include "lamina/toolpath/job_override.hpp"

namespace lamina {

void describe(SettingsSchema& schema, TrajectoryFeederSettings& settings) {
  schema.number("feeder.rate_hz", settings.rate_hz, {1.0, 10000.0},
                "Points of a joint trajectory per second.");
  schema.integer("feeder.points", settings.points, {1.0, 100000.0},
                 "Points that are sent to the controller at once.");
  schema.number("feeder.ahead_s", settings.ahead_s, {0.0, 60.0},
                "How much motion the controller has waiting at least.");
  schema.number("feeder.reaction_s", settings.reaction_s, {0.0, 10.0},
                "From a pause or abort to the first point that differs for it.");
  schema.number("feeder.feed_most", settings.feed_most, {1.0, boundsOf(OverrideKind::Feed).most},
                "Greatest share of the planned speeds that a change of the feed may ask for.");
  schema.number("feeder.override_ramp_s", settings.override_ramp_s, {0.0, 60.0},
                "Time in which a change of flow or power by all that is planned takes effect.");
  for (const char* key : {"rate_hz", "points", "ahead_s", "reaction_s"})
    schema.renamed(std::string("hand_over.") + key, std::string("feeder.") + key);
}

}  // namespace lamina
