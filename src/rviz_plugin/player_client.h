#pragma once

#include "rviz_plugin/background_jobs.h"

#include <devo_evo/PlayerState.h>
#include <devo_evo/Show.h>

#include <QTimer>

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace devo_evo
{
/// Gives orders to a player and hears what it shows, without ever waiting: calls are made in the background, and one
/// that gets no answer is given up. Of orders given while another is under way, only the last of a kind is passed on.
class PlayerClient
{
public:
  struct Callbacks
  {
    std::function<void(const PlayerState&)> shows;          ///< whenever the player shows something else, or otherwise
    std::function<void(const std::string& error)> answers;  ///< to an order; empty: it was carried out
  };

  /// @param player resolved name of the node.
  PlayerClient(const std::string& player, Callbacks callbacks);
  ~PlayerClient();
  PlayerClient(const PlayerClient&) = delete;
  PlayerClient& operator=(const PlayerClient&) = delete;

  /// What is empty or 0 stays as it is.
  void show(const Show::Request& request);
  void setPaused(bool paused);

  /// Whether an order has not been answered yet.
  bool busy() const { return under_way_; }

  /// What the player has last said; none while it has not been heard.
  const std::optional<PlayerState>& last() const { return last_; }

private:
  class Link;

  /// What is still to be ordered.
  struct Orders
  {
    std::optional<Show::Request> show;
    std::optional<bool> paused;
  };

  void passOn();
  void answered(const std::string& error);
  void giveUp();
  void hear(const PlayerState& state);

  const Callbacks callbacks_;
  const std::shared_ptr<Link> link_;  ///< shared with jobs
  Orders waiting_;
  bool under_way_ = false;
  std::optional<PlayerState> last_;
  QTimer patience_;      ///< with a call under way
  BackgroundJobs jobs_;  ///< last, so that it ends first
};
}  // namespace devo_evo
