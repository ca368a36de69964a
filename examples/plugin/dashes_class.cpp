// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// The same plug-in as a class that the nodes find through pluginlib; plugins.xml names it.
#include <lamina/base/plugin.hpp>
#include <pluginlib/class_list_macros.hpp>

extern "C" void lamina_register();

namespace lamina_dashes {

class Dashes : public lamina::Plugin {
 public:
  void addEntries() override { lamina_register(); }
};

}  // namespace lamina_dashes

PLUGINLIB_EXPORT_CLASS(lamina_dashes::Dashes, lamina::Plugin)
