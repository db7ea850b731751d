#include "rviz_plugin/film_process.h"

#include <QRegularExpression>
#include <QStringList>

#include <chrono>
#include <utility>

#include <dlfcn.h>

namespace devo_evo
{
namespace
{
constexpr std::chrono::seconds PATIENCE{ 5 };
constexpr int LONGEST_COMPLAINT = 500;  // [characters]

/// The tool lies where nodes do, in a folder beside this library.
QString toolPath()
{
  Dl_info library{};
  dladdr(reinterpret_cast<void*>(&toolPath), &library);
  const QString path = QString::fromLocal8Bit(library.dli_fname);
  return path.left(path.lastIndexOf('/')) + "/devo_evo/devo_evo";
}
}  // namespace

FilmProcess::FilmProcess(Callbacks callbacks) : callbacks_(std::move(callbacks))
{
  process_.setStandardInputFile(QProcess::nullDevice());
  process_.setStandardOutputFile(QProcess::nullDevice());
  patience_.setSingleShot(true);
  QObject::connect(&patience_, &QTimer::timeout, [this] { process_.kill(); });
  QObject::connect(&process_, &QProcess::readyReadStandardError, [this] { read(); });
  QObject::connect(&process_, QOverload<int, QProcess::ExitStatus>::of(&QProcess::finished),
                   [this](int status, QProcess::ExitStatus how) { finish(status, how); });
  QObject::connect(&process_, &QProcess::errorOccurred,
                   [this](QProcess::ProcessError error)
                   {
                     if (error == QProcess::FailedToStart)
                     {
                       callbacks_.ends(process_.program() + " cannot be started: " + process_.errorString());
                     }
                   });
}

FilmProcess::~FilmProcess()
{
  process_.disconnect();
  if (running())
  {
    process_.terminate();  // it takes what it has written so far away
    if (!process_.waitForFinished(1000))
    {
      process_.kill();
      process_.waitForFinished(1000);
    }
  }
}

void FilmProcess::start(const FilmOrder& order)
{
  line_.clear();
  complaint_.clear();
  cancelled_ = false;
  process_.start(toolPath(), { "render", order.folder, "--individual", order.individual, "--out", order.path,
                               "--colour", order.colour, "--speed", QString::number(order.speed, 'g', 17) });
}

void FilmProcess::cancel()
{
  cancelled_ = true;
  process_.terminate();
  patience_.start(PATIENCE);
}

void FilmProcess::read()
{
  static const QRegularExpression progress(": picture (\\d+) of (\\d+);");
  line_ += QString::fromUtf8(process_.readAllStandardError());
  QStringList lines = line_.split('\n');
  line_ = lines.takeLast();
  for (const QString& line : lines)
  {
    const QRegularExpressionMatch match = progress.match(line);
    if (match.hasMatch())
    {
      callbacks_.advances(match.captured(1).toInt(), match.captured(2).toInt());
    }
    else
    {
      complaint_ += (complaint_.isEmpty() ? "" : "\n") + line;
    }
  }
}

void FilmProcess::finish(int status, QProcess::ExitStatus how)
{
  patience_.stop();
  read();
  if (how == QProcess::NormalExit && status == 0)
  {
    callbacks_.ends("");
  }
  else if (cancelled_)
  {
    callbacks_.ends("cancelled; there is no film");
  }
  else
  {
    const bool silent = complaint_.isEmpty();
    callbacks_.ends(silent ? "devo_evo render ended with status " + QString::number(status)
                           : complaint_.left(LONGEST_COMPLAINT));
  }
}
}  // namespace devo_evo
