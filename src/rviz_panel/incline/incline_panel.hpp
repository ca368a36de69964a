// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rviz/panel.h>

namespace lamina {

class PanelContent;

/// The panel as RViz loads it: the content, saved and loaded with RViz's configuration, and the camera led to
/// what it shows.
class InclinePanel : public rviz::Panel {
 public:
  explicit InclinePanel(QWidget* parent = nullptr);

  void load(const rviz::Config& config) override;
  void save(rviz::Config config) const override;

 private:
  PanelContent* content_;
};

}  // namespace lamina
