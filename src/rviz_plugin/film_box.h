#pragma once

#include "rviz_plugin/film_process.h"

#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QWidget>

#include <functional>
#include <optional>

namespace devo_evo
{
/// Where a film goes, a button to record or cancel it, its progress, and what came of it.
class FilmBox : public QWidget
{
public:
  struct Callbacks
  {
    std::function<FilmOrder()> order;  ///< the film to be made, but for its path
    std::function<void()> changed;     ///< the path
  };

  explicit FilmBox(Callbacks callbacks, QWidget* parent = nullptr);

  /// @param path of the film unless the user gives one; empty: there is nothing to be filmed.
  void offer(const QString& path);

  QString path() const { return path_->text(); }
  void setPath(const QString& path) { path_->setText(path); }

private:
  void recordOrCancel();
  void end(const QString& error);
  void tell(const QString& note, const QString& error);

  const Callbacks callbacks_;
  QLineEdit* const path_;
  QPushButton* const record_;
  QProgressBar* const progress_;
  QLabel* const note_;
  QLabel* const error_;
  QString recorded_path_;
  FilmProcess film_;
};
}  // namespace devo_evo
