#pragma once

#include <QLabel>
#include <QString>

namespace devo_evo
{
/// The widget, under a name by which others can find it.
template <class Widget>
Widget* named(const char* name, Widget* widget)
{
  widget->setObjectName(name);
  return widget;
}

/// A text of several lines that can be copied; hidden until there is one.
QLabel* makeMessage(const char* name);

/// The same for what has gone wrong.
QLabel* makeErrorMessage(const char* name);

/// Shows a text; an empty one takes no place.
void setMessage(QLabel& label, const QString& text);
}  // namespace devo_evo
