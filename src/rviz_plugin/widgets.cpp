#include "rviz_plugin/widgets.h"

namespace devo_evo
{
QLabel* makeMessage(const char* name)
{
  auto* label = named(name, new QLabel);
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  label->setVisible(false);
  return label;
}

QLabel* makeErrorMessage(const char* name)
{
  QLabel* label = makeMessage(name);
  label->setStyleSheet("color: #b02a1a");
  return label;
}

void setMessage(QLabel& label, const QString& text)
{
  label.setText(text);
  label.setVisible(!text.isEmpty());
}
}  // namespace devo_evo
