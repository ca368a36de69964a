// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/report/loop_report.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/picture/chart.hpp"
#include "lamina/picture/html.hpp"

namespace lamina {
namespace {

// Pages show pictures 520 px wide: drawn twice as large, their letters could not be read.
constexpr int kChartWidth = 620;
constexpr int kChartHeight = 290;
constexpr std::size_t kMostRows = 120;  // of the picture of all layers
constexpr double kScaleHeight = 40.0;   // px, below that picture
constexpr Colour kBlue{0.13, 0.42, 0.70};
constexpr Colour kOrange{0.85, 0.37, 0.05};
constexpr Colour kGrey{0.55, 0.58, 0.62};
constexpr Colour kNotMeasured{0.66, 0.66, 0.66};

std::string formatted(const char* format, double value) {
  char text[48];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

template <class Figure>
ChartSeries byLayer(const LoopRecord& record, const char* label, const Colour& colour, Figure figure) {
  ChartSeries series{label, {}, colour, 2.5, 1.6};
  for (const LayerRecord& layer : record.layers())
    series.points.emplace_back(static_cast<double>(layer.figures.layer), figure(layer.figures));
  return series;
}

std::string errorChart(const LoopRecord& record) {
  Chart chart{"Height error by layer", "layer", "mm", {}};
  chart.series.push_back(
      byLayer(record, "mean (positive: too low)", kGrey, [](const auto& f) { return f.mean_error_mm; }));
  chart.series.push_back(
      byLayer(record, "RMSE without mean", kOrange, [](const auto& f) { return f.flatness_mm; }));
  chart.series.push_back(byLayer(record, "RMSE", kBlue, [](const auto& f) { return f.rmse_mm; }));
  return chartPng(chart, kChartWidth, kChartHeight);
}

std::string gainChart(const LoopRecord& record) {
  Chart chart{"Growth over commanded growth by layer", "layer", "gain", {}};
  chart.series.push_back(byLayer(record, "least", kGrey, [](const auto& f) { return f.gain_least; }));
  chart.series.push_back(byLayer(record, "greatest", kOrange, [](const auto& f) { return f.gain_greatest; }));
  chart.series.push_back(byLayer(record, "mean", kBlue, [](const auto& f) { return f.gain_mean; }));
  return chartPng(chart, kChartWidth, kChartHeight);
}

template <class Value>
std::string cellChart(const LoopRecord& record, const char* title, const char* unit, Value value) {
  Chart chart{title, "mm deposited, as the nozzle comes by", unit, {}};
  ChartSeries series{"", {}, kBlue, 0.0, 1.4};
  double passed_mm = 0.0;
  for (const CellOutcome& cell : record.cells()) {
    const double length_mm = cell.along_mm.norm();
    series.points.emplace_back(passed_mm + 0.5 * length_mm, value(cell));
    passed_mm += length_mm;
  }
  chart.series.push_back(std::move(series));
  return chartPng(chart, kChartWidth, kChartHeight);
}

std::string hexColour(const Colour& colour) {
  char text[8];
  const auto part = [](double value) { return static_cast<int>(std::lround(255.0 * value)); };
  std::snprintf(text, sizeof text, "#%02x%02x%02x", part(colour.red), part(colour.green), part(colour.blue));
  return text;
}

/// Ends of the colours: hardly anything lies beyond.
double colouredUpTo(const LoopRecord& record) {
  std::vector<float> magnitudes;
  for (const LayerRecord& layer : record.layers())
    for (const float error : layer.error_mm)
      if (layer.figures.is_measured) magnitudes.push_back(std::abs(error));
  if (magnitudes.empty()) return 1.0;
  const auto most =
      magnitudes.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(magnitudes.size() - 1));
  std::nth_element(magnitudes.begin(), most, magnitudes.end());
  return std::max(1e-3, static_cast<double>(*most));
}

/// From too low, on the left, to too high; beside it the colour of layers that were not measured.
std::string colourScale(double y, double most_mm) {
  constexpr int kSteps = 40;
  constexpr double kStep = 12.0;  // px
  const auto named = [&](double x, const char* anchor, const std::string& text) {
    return "<text x=\"" + formatted("%.0f", x) + "\" y=\"" + formatted("%.0f", y + 24.0) +
           "\" font-size=\"11\" text-anchor=\"" + anchor + "\">" + text + "</text>";
  };
  std::string svg;
  for (int i = 0; i < kSteps; ++i)
    svg += "<rect x=\"" + formatted("%.0f", 40.0 + kStep * i) + "\" y=\"" + formatted("%.0f", y) +
           "\" width=\"12.2\" height=\"10\" fill=\"" +
           hexColour(colourAt(ColourMap::Diverging, (i + 0.5) / kSteps)) + "\"/>";
  const double end = 40.0 + kStep * kSteps;
  svg += "<rect x=\"" + formatted("%.0f", end + 60.0) + "\" y=\"" + formatted("%.0f", y) +
         "\" width=\"60\" height=\"10\" fill=\"" + hexColour(kNotMeasured) + "\"/>";
  return svg + named(40.0, "start", formatted("%.2f mm too low", most_mm)) +
         named(40.0 + 0.5 * kStep * kSteps, "middle", "as planned") +
         named(end, "end", formatted("%.2f mm too high", most_mm)) +
         named(end + 60.0, "start", "not measured") + "\n";
}

/// All layers above each other, the first at the bottom; pieces of each from left to right.
std::string deviationDrawing(const LoopRecord& record, double most_mm) {
  const std::size_t layers = record.layers().size();
  const std::size_t rows = std::min(layers, kMostRows);
  const double row_px = std::clamp(480.0 / static_cast<double>(rows), 3.0, 24.0);
  constexpr double kPiece = 5.0;  // px
  const double width = kPiece * static_cast<double>(LayerRecord::kPieces);
  const double height = row_px * static_cast<double>(rows);
  const std::size_t named_each = std::max<std::size_t>(1, (rows + 11) / 12);
  std::string svg = "<svg viewBox=\"0 0 " + formatted("%.0f", width + 40.0) + " " +
                    formatted("%.0f", height + kScaleHeight) +
                    "\" role=\"img\" aria-label=\"error along each layer\" shape-rendering=\"crispEdges\">\n";
  for (std::size_t row = 0; row < rows; ++row) {
    const LayerRecord& layer = record.layers()[row * layers / rows];
    const double y = height - row_px * static_cast<double>(row + 1);
    for (std::size_t piece = 0; piece < LayerRecord::kPieces; ++piece) {
      // Too low is blue, as in pictures of deviation: measured less planned there.
      const double fraction = 0.5 - 0.5 * static_cast<double>(layer.error_mm[piece]) / most_mm;
      const Colour colour =
          layer.figures.is_measured ? colourAt(ColourMap::Diverging, fraction) : kNotMeasured;
      svg += "<rect x=\"" + formatted("%.0f", 40.0 + kPiece * static_cast<double>(piece)) + "\" y=\"" +
             formatted("%.1f", y) + "\" width=\"5.2\" height=\"" + formatted("%.1f", row_px + 0.2) +
             "\" fill=\"" + hexColour(colour) + "\"/>";
    }
    if (row % named_each == 0)
      svg += "<text x=\"34\" y=\"" + formatted("%.1f", y + std::max(row_px, 9.0)) +
             "\" font-size=\"11\" text-anchor=\"end\">" + std::to_string(layer.figures.layer) + "</text>";
    svg += "\n";
  }
  return svg + colourScale(height + 8.0, most_mm) + "</svg>\n";
}

std::string alarmsOf(const LayerRecord& layer) {
  std::string text;
  for (const RaisedAlarm& alarm : layer.alarms)
    text += (text.empty() ? "" : " ") + std::to_string(static_cast<int>(alarm.alarm));
  return text;
}

std::vector<std::string> rowOf(const LayerRecord& layer) {
  const LayerFigures& figures = layer.figures;
  return {std::to_string(figures.layer),
          toString(layer.state),
          formatted("%.4f", figures.rmse_mm),
          formatted("%.4f", figures.flatness_mm),
          formatted("%.4f", figures.mean_error_mm),
          formatted("%.3f", figures.coverage),
          formatted("%.3f", figures.limited_share),
          formatted("%.3f", figures.contested_share),
          formatted("%.4f", figures.gain_mean),
          formatted("%.4f", figures.gain_least),
          formatted("%.4f", figures.gain_greatest),
          alarmsOf(layer),
          layer.map_digest};
}

const std::vector<std::string>& columns() {
  static const std::vector<std::string> names = {
      "layer",         "state",         "rmse_mm",         "flatness_mm", "mean_error_mm",
      "coverage",      "limited_share", "contested_share", "gain_mean",   "gain_least",
      "gain_greatest", "alarms",        "map_digest"};
  return names;
}

HtmlTable alarmTable(const LoopRecord& record) {
  HtmlTable table{{"layer", "alarm", "what"}, {}, 0};
  for (const LayerRecord& layer : record.layers())
    for (const RaisedAlarm& alarm : layer.alarms)
      table.rows.push_back(
          {std::to_string(layer.figures.layer), std::to_string(static_cast<int>(alarm.alarm)), alarm.reason});
  return table;
}

std::string summaryOf(const LoopRecord& record) {
  const LayerFigures& last = record.layers().back().figures;
  const auto measured = std::count_if(record.layers().begin(), record.layers().end(),
                                      [](const LayerRecord& layer) { return layer.figures.is_measured; });
  return std::to_string(record.layers().size()) + " layers, " + std::to_string(measured) +
         " of them measured. Last layer: RMSE " + formatted("%.3f", last.rmse_mm) + " mm, mean " +
         formatted("%.3f", last.mean_error_mm) + " mm (planned less measured: positive is too low), " +
         formatted("%.0f", 100.0 * last.coverage) + " % seen, gain " + formatted("%.3f", last.gain_mean) +
         ". Toolpath " + record.toolpathId() + ".";
}

}  // namespace

std::string loopReport(const LoopRecord& record) {
  HtmlPage page("Layer heights of " + record.partName());
  if (record.layers().empty()) {
    page.paragraph("No layer was done.");
    return page.text();
  }
  page.paragraph(summaryOf(record));
  page.heading("Errors and gains");
  page.pictures({errorChart(record), gainChart(record)}, {"height error by layer", "gain by layer"});
  const double most_mm = colouredUpTo(record);
  page.heading("Error along each layer");
  page.paragraph(
      "A strip for each layer, from left to right as the nozzle comes by, the first layer at the bottom.");
  page.drawing(deviationDrawing(record, most_mm));
  page.heading("Last layer");
  page.pictures(
      {cellChart(record, "Error e, planned less measured", "mm", [](const auto& c) { return c.error_mm; }),
       cellChart(record, "Correction m of the amount", "relative", [](const auto& c) { return c.amount; })},
      {"error along the last layer", "correction along the last layer"});
  const HtmlTable alarms = alarmTable(record);
  if (!alarms.rows.empty()) page.heading("Alarms");
  page.table(alarms);
  page.heading("Numbers");
  HtmlTable table{columns(), {}, 0};
  for (const LayerRecord& layer : record.layers()) table.rows.push_back(rowOf(layer));
  page.table(table);
  return page.text();
}

std::string loopLayersCsv(const LoopRecord& record) {
  const auto joined = [](const std::vector<std::string>& fields) {
    std::string line;
    for (const std::string& field : fields) line += (line.empty() ? "" : ",") + field;
    return line + "\n";
  };
  std::string text = joined(columns());
  for (const LayerRecord& layer : record.layers()) text += joined(rowOf(layer));
  return text;
}

void saveLoopReport(const std::string& folder, const LoopRecord& record) {
  if (record.layers().empty()) return;
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure) throw FileError("cannot make the folder " + folder + ": " + failure.message());
  writeFile(folder + "/loop_report.html", loopReport(record));
  writeFile(folder + "/loop_layers.csv", loopLayersCsv(record));
}

}  // namespace lamina
