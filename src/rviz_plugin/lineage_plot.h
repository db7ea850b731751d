#pragma once

#include "devo_evo/archive/archive.h"
#include "devo_evo/render/lineage_curves.h"

#include <QWidget>

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace devo_evo
{
/// Fitness, W_L and W_Phi along a lineage over the generation of birth, one below the other, with one ancestor marked;
/// a click or a drag chooses another.
class LineagePlot : public QWidget
{
public:
  explicit LineagePlot(QWidget* parent = nullptr);

  /// @param lineage oldest first; empty: there is nothing to plot. @param curves as long as there is.
  void setLineage(const std::vector<ArchivedIndividual>& lineage, const std::optional<LineageCurves>& curves);
  void setChosen(size_t position);

  /// Called when the user chooses an ancestor, with its position in the lineage.
  void onChosen(std::function<void(size_t)> callback) { chosen_callback_ = std::move(callback); }

  /// Where an ancestor stands within the widget [pixels].
  double xOf(size_t position) const;

  QSize sizeHint() const override { return { 320, 330 }; }
  QSize minimumSizeHint() const override { return { 200, 210 }; }

protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;

private:
  QRectF area(size_t row) const;
  double generation(size_t position) const;
  void paintAxes(QPainter& painter, const QRectF& area, const LineageCurve& curve, const AxisRange& values,
                 bool lowest) const;
  void paintCurve(QPainter& painter, const QRectF& area, const LineageCurve& curve, const AxisRange& values) const;
  void chooseAt(double x);

  std::vector<ArchivedIndividual> lineage_;
  LineageCurves curves_;
  AxisRange generations_;
  size_t chosen_ = 0;
  std::function<void(size_t)> chosen_callback_;
};
}  // namespace devo_evo
