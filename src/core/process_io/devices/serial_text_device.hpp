// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "lamina/process_io/devices/process_device.hpp"

namespace lamina {

/// A device that reads lines of text over a serial line or TCP, one for each channel: channels that have
/// changed, and every channel again from time to time.
/// @throws InvalidConfig if a channel's text has no {value}, or the device has inputs
std::unique_ptr<ProcessDevice> makeSerialTextDevice(const DeviceTable& table);

}  // namespace lamina
