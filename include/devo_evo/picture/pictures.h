#pragma once

#include "devo_evo/picture/image.h"
#include "devo_evo/picture/life_scene.h"
#include "devo_evo/picture/lineage.h"
#include "devo_evo/render/colouring.h"
#include "devo_evo/render/shown_robot.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace devo_evo
{
/// Size and pace of pictures and films.
struct PictureFormat
{
  int width = 1280, height = 720;  ///< [pixels]
  int pictures_per_s = 25;         ///< of a film
  double speed = 1.0;              ///< seconds of life per second of film
  Colouring colouring = Colouring::RESTING_LENGTH;

  /// @throw InvalidInput naming the field, its value and its range.
  void validate() const;
};

/// Told how many pictures of how many are done; may throw to give up: no film is left then.
using FilmProgress = std::function<void(int64_t done, int64_t total)>;

/// One robot's life so far, with instruments, at a time of its life [s since birth].
/// @throw InvalidInput if the time is not within its life; PictureError if the simulation diverges before.
Image pictureOfLife(const ShownRobot& robot, double time_since_birth, const PictureFormat& format);

/// A film of one robot's life.
void filmLife(const ShownRobot& robot, const std::string& path, const PictureFormat& format,
              const FilmProgress& progress);

/// A film of several robots' lives at the same time, side by side, from left to right.
/// @param titles of the robots, one each.
void filmSideBySide(const std::vector<ShownRobot>& robots, const std::vector<std::string>& titles,
                    const std::string& path, const PictureFormat& format, const FilmProgress& progress);

/// A film of lives one after the other, with the curves of the lineage beside them.
/// @param positions  of those who are shown, ascending.
/// @param speeds     of each, instead of the format's; empty: the format's for all.
/// @param title_s    how long a title with the experiment's name is shown before [s]; 0: none.
void filmLineage(const Archive& archive, const Lineage& lineage, const std::vector<size_t>& positions,
                 const std::vector<double>& speeds, double title_s, const std::string& path,
                 const PictureFormat& format, const FilmProgress& progress);

/// As the paper's Supplementary Video S1: from the founder to the champion of the best trial, by steps of progress,
/// ancestors at double speed and the champion at the format's.
void filmOverview(const Archive& archive, int64_t count, const std::string& path, const PictureFormat& format,
                  const FilmProgress& progress);

/// One life as in the paper's Fig. 1: poses at equal times from left to right, the length of one part over life, and
/// velocity as arrows.
/// @param poses 2 to 24. @param part whose length is shown, a voxel or a leg (Appearance::partName()); none: the
/// visible one that develops most.
/// @param width of the picture [pixels]. @throw InvalidInput, PictureError
Image stripOfLife(const ShownRobot& robot, int poses, std::optional<int> part, int width, Colouring colouring);

/// Rows of robots as in the paper's Fig. 2, among the ancestors of an experiment's champions: trotting, galloping,
/// developing from galloper to roller, rolling from birth. A row that nobody fills says so.
/// @throw InvalidInput if they are not soft bodies.
Image gaitRows(const Archive& archive, int width, Colouring colouring);
}  // namespace devo_evo
