// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rviz/panel.h>

namespace lamina {

class LayersContent;

/// The panel of layers as RViz loads it: the content, saved and loaded with RViz's configuration.
class LayersPanel : public rviz::Panel {
 public:
  explicit LayersPanel(QWidget* parent = nullptr);

  void load(const rviz::Config& config) override;
  void save(rviz::Config config) const override;

 private:
  LayersContent* content_;
};

}  // namespace lamina
