#include "rviz_plugin/lineage_plot.h"

#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace devo_evo
{
namespace
{
// Around the axes of one plot [pixels].
constexpr double LEFT = 40.0, RIGHT = 12.0, ABOVE = 20.0, BELOW = 6.0;
constexpr double LOWEST = 34.0;  // below the lowest one, for the generations
constexpr double TICK = 4.0;

QPointF placeIn(const QRectF& area, const AxisRange& xs, double x, const AxisRange& ys, double y)
{
  return { area.left() + area.width() * (x - xs.low) / (xs.high - xs.low),
           area.bottom() - area.height() * (y - ys.low) / (ys.high - ys.low) };
}

QColor colourOf(const LineageCurve& curve)
{
  return QColor::fromRgbF(curve.colour[0], curve.colour[1], curve.colour[2]);
}
}  // namespace

LineagePlot::LineagePlot(QWidget* parent) : QWidget(parent)
{
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setToolTip("Click or drag to choose an ancestor");
}

void LineagePlot::setLineage(const std::vector<ArchivedIndividual>& lineage, const std::optional<LineageCurves>& curves)
{
  lineage_ = lineage;
  curves_ = curves.value_or(LineageCurves());
  generations_ = lineage_.empty() ? AxisRange() : generationsOf(lineage_);
  chosen_ = lineage_.empty() ? 0 : std::min(chosen_, lineage_.size() - 1);
  update();
}

void LineagePlot::setChosen(size_t position)
{
  chosen_ = position;
  update();
}

double LineagePlot::generation(size_t position) const
{
  return static_cast<double>(lineage_[position].individual.generation);
}

double LineagePlot::xOf(size_t position) const
{
  return placeIn(area(0), generations_, generation(position), AxisRange(), 0.0).x();
}

/// Within the axes of a row.
QRectF LineagePlot::area(size_t row) const
{
  const double row_height = (height() - LOWEST) / static_cast<double>(curves_.size());
  return { LEFT, static_cast<double>(row) * row_height + ABOVE, width() - LEFT - RIGHT, row_height - ABOVE - BELOW };
}

void LineagePlot::paintEvent(QPaintEvent* /*event*/)
{
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), palette().base());
  QFont font = painter.font();
  font.setPixelSize(11);
  painter.setFont(font);
  if (lineage_.empty())
  {
    painter.setPen(palette().color(QPalette::Disabled, QPalette::Text));
    painter.drawText(rect(), Qt::AlignCenter, "no lineage");
    return;
  }
  for (size_t row = 0; row < curves_.size(); ++row)
  {
    const LineageCurve& curve = curves_[row];
    const AxisRange values = rangeOf(curve, lineage_);
    paintAxes(painter, area(row), curve, values, row + 1 == curves_.size());
    paintCurve(painter, area(row), curve, values);
  }
}

void LineagePlot::paintAxes(QPainter& painter, const QRectF& area, const LineageCurve& curve, const AxisRange& values,
                            bool lowest) const
{
  const QColor text = palette().color(QPalette::Text);
  QColor faint = text;
  faint.setAlphaF(0.12);
  painter.setPen(text);
  painter.drawLine(area.topLeft(), area.bottomLeft());
  painter.drawLine(area.bottomLeft(), area.bottomRight());
  painter.drawText(QRectF(area.left(), area.top() - ABOVE, area.width(), ABOVE), Qt::AlignLeft | Qt::AlignVCenter,
                   QString::fromStdString(curve.title));
  for (const AxisTick& tick : roundTicks(values, 3))
  {
    const double y = placeIn(area, generations_, generations_.low, values, tick.value).y();
    painter.setPen(faint);
    painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
    painter.setPen(text);
    painter.drawText(QRectF(0.0, y - 8.0, LEFT - TICK - 2.0, 16.0), Qt::AlignRight | Qt::AlignVCenter,
                     QString::fromStdString(tick.text));
  }
  for (const AxisTick& tick : roundTicks(generations_, 4))
  {
    const double x = placeIn(area, generations_, tick.value, values, values.low).x();
    painter.drawLine(QPointF(x, area.bottom()), QPointF(x, area.bottom() + TICK));
    if (lowest)
    {
      painter.drawText(QRectF(x - 40.0, area.bottom() + TICK, 80.0, 14.0), Qt::AlignCenter,
                       QString::fromStdString(tick.text));
    }
  }
  if (lowest)
  {
    painter.drawText(QRectF(area.left(), area.bottom() + 18.0, area.width(), 16.0), Qt::AlignRight | Qt::AlignVCenter,
                     "generation of birth");
  }
}

void LineagePlot::paintCurve(QPainter& painter, const QRectF& area, const LineageCurve& curve,
                             const AxisRange& values) const
{
  QPolygonF line;
  for (size_t i = 0; i < lineage_.size(); ++i)
  {
    const double value = curve.value(lineage_[i]);
    if (std::isfinite(value))
    {
      line << placeIn(area, generations_, generation(i), values, value);
    }
  }
  painter.setPen(QPen(colourOf(curve), 1.6));
  painter.drawPolyline(line);
  const double value = curve.value(lineage_[chosen_]);
  const QPointF here =
      placeIn(area, generations_, generation(chosen_), values, std::isfinite(value) ? value : values.low);
  QColor mark = palette().color(QPalette::Text);
  mark.setAlphaF(0.4);
  painter.setPen(QPen(mark, 1.0));
  painter.drawLine(QPointF(here.x(), area.top()), QPointF(here.x(), area.bottom()));
  painter.setPen(QPen(palette().color(QPalette::Base), 1.5));
  painter.setBrush(colourOf(curve));
  painter.drawEllipse(here, 5.0, 5.0);
  painter.setBrush(Qt::NoBrush);
}

void LineagePlot::mousePressEvent(QMouseEvent* event)
{
  chooseAt(event->localPos().x());
}

void LineagePlot::mouseMoveEvent(QMouseEvent* event)
{
  if (event->buttons() != Qt::NoButton)
  {
    chooseAt(event->localPos().x());
  }
}

/// Chooses the ancestor that is nearest.
void LineagePlot::chooseAt(double x)
{
  if (lineage_.empty())
  {
    return;
  }
  size_t nearest = 0;
  for (size_t i = 1; i < lineage_.size(); ++i)
  {
    nearest = std::abs(xOf(i) - x) < std::abs(xOf(nearest) - x) ? i : nearest;
  }
  if (nearest != chosen_)
  {
    setChosen(nearest);
    if (chosen_callback_)
    {
      chosen_callback_(nearest);
    }
  }
}
}  // namespace devo_evo
