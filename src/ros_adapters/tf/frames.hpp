// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Frames on tf, in the namespace that the nodes run in. `machine_transforms` computes how they stand to each
/// other, `trajectory_publisher` sends that.
namespace lamina::names {

inline constexpr char kWorldFrame[] = "world";
inline constexpr char kBaseFrame[] = "base_link";  ///< of the machine
inline constexpr char kBedFrame[] = "bed";         ///< or table: what the part stands on
inline constexpr char kPartFrame[] = "part";       ///< of the toolpath
inline constexpr char kNozzleFrame[] = "nozzle";   ///< at its tip
inline constexpr char kSensorFrame[] = "sensor";

}  // namespace lamina::names
