#pragma once

#include "rviz_plugin/background_jobs.h"
#include "rviz_plugin/film_box.h"
#include "rviz_plugin/lineage_plot.h"
#include "rviz_plugin/lineage_reading.h"
#include "rviz_plugin/player_client.h"

#include <rviz/panel.h>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QSlider>
#include <QTimer>

#include <memory>
#include <optional>
#include <string>

namespace devo_evo
{
/// Leads through the lineages of an experiment, which may be running: chooses trial and ancestor, has a player show it,
/// and records films. Whatever may take long (the archive, services, the ROS master, films) is done elsewhere than in
/// rviz's own thread. docs/nodes.md, "Panel".
class LineagePanel : public rviz::Panel
{
public:
  explicit LineagePanel(QWidget* parent = nullptr);
  ~LineagePanel() override;
  LineagePanel(const LineagePanel&) = delete;
  LineagePanel& operator=(const LineagePanel&) = delete;

  void onInitialize() override;
  void load(const rviz::Config& config) override;
  void save(rviz::Config config) const override;

private:
  /// What is read of an experiment.
  struct Reading
  {
    LineageView view;
    std::string error;  ///< empty: view is what was asked for
  };

  QLayout* makeExperimentRow();
  QLayout* makePlayerRow();
  void connectControls();

  void readLineage();
  void takeReading(const Reading& reading, int64_t choice);
  void takeView(const LineageView& view);
  void changeExperiment();
  void listTrials();
  void choose(size_t position);
  void markChosen();
  void describeChosen();
  std::optional<size_t> positionOf(int64_t trial, int64_t id) const;
  std::optional<int64_t> chosenTrial() const;
  std::string chosenIndividual() const;

  void connectPlayer();
  void orderRobot();
  void orderLook();
  void imposeSettings();
  void takeState();
  void takeAnswer(const std::string& error);
  bool settled() const;

  FilmOrder filmOrder() const;
  void showErrors();

  QLineEdit* const experiment_;
  QComboBox* const trial_;
  LineagePlot* const plot_;
  QSlider* const slider_;
  QLabel* const description_;
  QPushButton* const pause_;
  QDoubleSpinBox* const speed_;
  QComboBox* const colour_;
  FilmBox* const film_;
  QLabel* const errors_;

  QString player_ = "player";  ///< name of the node, in rviz's namespace unless it begins with a slash
  LineageView view_;
  size_t chosen_ = 0;       ///< position in the lineage
  bool follows_ = true;     ///< whether it is to be the champion, whoever that becomes
  int64_t wanted_id_ = -1;  ///< from the configuration: the ancestor to choose once the lineage is known; -1: none
  bool impose_ = false;     ///< whether the player is still to be told what the configuration says
  bool order_when_read_ = false;
  bool reading_ = false;
  int64_t choice_ = 0;  ///< counts changes of what is to be read
  QString read_error_, order_error_;

  QTimer refresh_;
  QTimer order_delay_;  ///< until a slider has come to rest
  QTimer settling_;     ///< until the player has done what it was told
  std::unique_ptr<PlayerClient> client_;
  std::unique_ptr<BackgroundJobs> jobs_;
};
}  // namespace devo_evo
