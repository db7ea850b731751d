#pragma once

#include "devo_evo/picture/pictures.h"

#include <CLI/CLI.hpp>

#include <memory>
#include <string>

namespace devo_evo
{
/// --out, --width, --height, --rate, --speed and --colour of the commands that make pictures and films.
class PictureOptions
{
public:
  explicit PictureOptions(CLI::App& app);

  const std::string& path() const { return given_->path; }

  /// @throw InvalidInput
  PictureFormat format() const;

private:
  struct Given
  {
    std::string path;
    std::string colouring = "resting_length";
    PictureFormat format;
  };

  std::shared_ptr<Given> given_ = std::make_shared<Given>();  // CLI11 keeps references to what it sets
};

/// A film was given up because of a signal.
class FilmInterrupted : public std::exception
{
};

/// Shows on standard error how far a film is, and gives it up once a signal was noted.
/// @throw FilmInterrupted
FilmProgress showFilmProgress(const std::string& path);

/// Makes a film; a signal ends it. @return exit status.
int makeFilm(const std::string& path, const std::function<void(const FilmProgress&)>& make);
}  // namespace devo_evo
