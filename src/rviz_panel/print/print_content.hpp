// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QTimer>
#include <QWidget>
#include <functional>
#include <string>
#include <vector>

#include "drawing/background_reader.hpp"
#include "drawing/layer_display.hpp"
#include "print/machine_watch.hpp"
#include "print/print_form.hpp"
#include "print/slice_client.hpp"
#include "print/stream_client.hpp"

class QCheckBox;
class QLabel;
class QPushButton;

namespace lamina {

class LayerSlider;
class PrintFormWidget;
class RoleLegend;
class RunStrip;

/// All of the panel that slices and prints, in any window: the form, the slice, the layers by role, the print
/// and what the machine reports. What is shown is the program as it was written. ROS must have been started.
///
/// Publishes `printed_layers` (visualization_msgs/MarkerArray), in the frame of the bed
class PrintContent : public QWidget {
 public:
  explicit PrintContent(QWidget* parent);
  ~PrintContent() override;

  PrintForm form() const;
  /// Shows a form that was saved (`textsOf`), or reports why it cannot.
  void load(const std::vector<SettingText>& texts);

  std::function<void()> changed;               ///< the form
  std::function<void(const Box3& box)> shown;  ///< a part that stands elsewhere than before [mm, bed frame]

 private:
  QWidget* makeHolds();
  void connectClients();
  void choosePart();
  void slice();
  void endSlice(const RunOutcome& outcome);
  void draw(const std::string& program);
  void showDrawn(DrawnPart part);
  void print();
  void showProgress(const PrintProgress& progress);
  void showReport(const WatchedState& report);

  PrintFormWidget* form_;
  RunStrip* slicing_;
  RoleLegend* legend_;
  LayerSlider* slider_;
  QCheckBox* follows_;
  RunStrip* printing_;
  QPushButton* hold_ = nullptr;
  QPushButton* go_on_ = nullptr;
  QLabel* machine_;
  std::string program_;  ///< that Print streams; empty while there is none
  SliceClient slice_client_;
  StreamClient stream_client_;
  MachineWatch watch_;
  LayerDisplay display_;
  BackgroundReader reader_;
  QTimer poll_;
};

}  // namespace lamina
