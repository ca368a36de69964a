// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Frames on tf, in the namespace in which the nodes run. `machine_transforms` computes the transforms
/// between them, and `trajectory_publisher` publishes the transforms.
namespace lamina::names {

inline constexpr char kWorldFrame[] = "world";
inline constexpr char kBaseFrame[] = "base_link";  ///< frame of the machine
inline constexpr char kBedFrame[] = "bed";         ///< frame of the bed or table on which the part stands
inline constexpr char kPartFrame[] = "part";       ///< frame of the toolpath
inline constexpr char kNozzleFrame[] = "nozzle";   ///< frame at the tip of the nozzle
inline constexpr char kSensorFrame[] = "sensor";

}  // namespace lamina::names
