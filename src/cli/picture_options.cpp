#include "cli/picture_options.h"

#include "cli/commands.h"
#include "cli/interruption.h"
#include "cli/progress_display.h"
#include "devo_evo/experiment/report_text.h"
#include "devo_evo/soft_body/text.h"

#include <chrono>
#include <iostream>

namespace devo_evo
{
PictureOptions::PictureOptions(CLI::App& app)
{
  app.add_option("--out", given_->path,
                 "what is written: a .png picture; a .mp4, .gif or .webp film; FOLDER/ of PNG files")
      ->type_name("FILE")
      ->required();
  app.add_option("--width", given_->format.width, "of the picture [pixels]")->capture_default_str();
  app.add_option("--height", given_->format.height, "of the picture [pixels]")->capture_default_str();
  app.add_option("--rate", given_->format.pictures_per_s, "pictures per second of a film")->capture_default_str();
  app.add_option("--speed", given_->format.speed, "seconds of life per second of film")->capture_default_str();
  app.add_option("--colour,--color", given_->colouring,
                 "of voxels: resting_length, remaining_development, phase or present_length")
      ->capture_default_str();
}

PictureFormat PictureOptions::format() const
{
  PictureFormat format = given_->format;
  format.colouring = parseColouring(given_->colouring);
  format.validate();
  return format;
}

FilmProgress showFilmProgress(const std::string& path)
{
  const auto display = std::make_shared<ProgressDisplay>();
  const auto start = std::chrono::steady_clock::now();
  return [=](int64_t done, int64_t total)
  {
    if (interruption() != 0)
    {
      display->end();
      throw FilmInterrupted();
    }
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    const double rate = static_cast<double>(done) / taken.count();
    display->show(path + ": picture " + toText(done) + " of " + toText(total) + "; " + fixedText(rate, 1) +
                      " pictures/s, " + durationText(static_cast<double>(total - done) / rate) + " left",
                  done == total);
  };
}

int makeFilm(const std::string& path, const std::function<void(const FilmProgress&)>& make)
{
  noteInterruptions();
  try
  {
    make(showFilmProgress(path));
  }
  catch (const FilmInterrupted&)
  {
    std::cerr << "devo_evo: stopped by " << signalName(interruption()) << "; there is no film\n";
    return 128 + interruption();
  }
  return EXIT_OK;
}
}  // namespace devo_evo
