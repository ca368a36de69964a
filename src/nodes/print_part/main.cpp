// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>

#include <cstdio>
#include <string>

#include "lamina/base/error.hpp"
#include "parameters.hpp"
#include "print_part.hpp"
#include "shutdown.hpp"

int main(int argc, char** argv) {
  lamina::runNode(argc, argv, {"print_part", lamina::OnSignal::Request}, [] {
    lamina::PrintPartSettings settings;
    lamina::SettingsSchema schema;
    describe(schema, settings);
    lamina::applyParameters(schema, ros::NodeHandle("~"));
    const lamina::PrintReport report = lamina::PrintPart(ros::NodeHandle(), settings).run();
    std::fputs(lamina::summaryText(report).c_str(), stdout);
    const std::string fault = lamina::measurementFault(report);
    if (!fault.empty()) throw lamina::Error(lamina::ErrorCode::DeviceError, fault);
  });
}
