// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "lamina/process_io/devices/process_device.hpp"

namespace lamina {

/// A device that is a Modbus server, over TCP or a serial line; one request per exchange.
/// @throws InvalidConfig if there are no registers, or they have gaps or do not hold the channels' values
std::unique_ptr<ProcessDevice> makeModbusDevice(const DeviceTable& table);

}  // namespace lamina
