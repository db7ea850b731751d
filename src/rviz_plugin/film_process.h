#pragma once

#include <QProcess>
#include <QString>
#include <QTimer>

#include <functional>

namespace devo_evo
{
/// Which film is to be made.
struct FilmOrder
{
  QString folder;  ///< of the experiment
  QString individual;
  QString path;  ///< of the film
  QString colour;
  double speed = 1.0;
};

/// Records a film by `devo_evo render`, as a process of its own, which needs neither display nor ROS.
class FilmProcess
{
public:
  struct Callbacks
  {
    std::function<void(int done, int total)> advances;  ///< pictures
    std::function<void(const QString& error)> ends;     ///< empty: the film is there
  };

  explicit FilmProcess(Callbacks callbacks);

  /// Ends the film that is being made.
  ~FilmProcess();
  FilmProcess(const FilmProcess&) = delete;
  FilmProcess& operator=(const FilmProcess&) = delete;

  bool running() const { return process_.state() != QProcess::NotRunning; }

  /// @pre none is being made.
  void start(const FilmOrder& order);

  /// Gives the film up; nothing is left of it.
  void cancel();

private:
  void read();
  void finish(int status, QProcess::ExitStatus how);

  const Callbacks callbacks_;
  QProcess process_;
  QTimer patience_;    ///< with a process that was asked to end
  QString line_;       ///< what it has said since the last line's end
  QString complaint_;  ///< the lines that tell no progress
  bool cancelled_ = false;
};
}  // namespace devo_evo
