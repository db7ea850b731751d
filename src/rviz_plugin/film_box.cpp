#include "rviz_plugin/film_box.h"

#include "rviz_plugin/widgets.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

#include <utility>

namespace devo_evo
{
FilmBox::FilmBox(Callbacks callbacks, QWidget* parent)
  : QWidget(parent)
  , callbacks_(std::move(callbacks))
  , path_(named("film", new QLineEdit))
  , record_(named("record", new QPushButton))
  , progress_(named("progress", new QProgressBar))
  , note_(makeMessage("film_note"))
  , error_(makeErrorMessage("film_error"))
  , film_({ [this](int done, int total)
            {
              progress_->setMaximum(total);
              progress_->setValue(done);
            },
            [this](const QString& error) { end(error); } })
{
  path_->setToolTip("Absolute path: .mp4, .gif or .webp, or FOLDER/ for PNG files, which need no ffmpeg");
  record_->setToolTip("Records the life of this robot, in this colour and speed");
  auto* row = new QHBoxLayout;
  row->addWidget(path_, 1);
  row->addWidget(record_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addLayout(row);
  column->addWidget(progress_);
  column->addWidget(note_);
  column->addWidget(error_);
  connect(path_, &QLineEdit::editingFinished, [this] { callbacks_.changed(); });
  connect(record_, &QPushButton::clicked, [this] { recordOrCancel(); });
  end("");
  offer("");
}

void FilmBox::offer(const QString& path)
{
  path_->setPlaceholderText(path.isEmpty() ? "film" : path);
  record_->setEnabled(!path.isEmpty() || film_.running());
}

void FilmBox::recordOrCancel()
{
  if (film_.running())
  {
    film_.cancel();
    return;
  }
  FilmOrder order = callbacks_.order();
  order.path = path_->text().isEmpty() ? path_->placeholderText() : path_->text();
  if (!order.path.startsWith('/'))
  {
    tell("", "film is \"" + order.path + "\"; it must be an absolute path");
    return;
  }
  recorded_path_ = order.path;
  tell("recording " + order.path, "");
  record_->setText("Cancel");
  progress_->setRange(0, 0);
  progress_->setVisible(true);
  film_.start(order);
}

void FilmBox::end(const QString& error)
{
  record_->setText("Record film");
  progress_->setVisible(false);
  const bool made = error.isEmpty() && !recorded_path_.isEmpty();
  tell(made ? "the film is in " + recorded_path_ : "", error);
}

void FilmBox::tell(const QString& note, const QString& error)
{
  setMessage(*note_, note);
  setMessage(*error_, error);
}
}  // namespace devo_evo
