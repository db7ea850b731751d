#include "rviz_plugin/lineage_panel.h"

#include "devo_evo/experiment/report_text.h"
#include "devo_evo/render/shown_robot.h"
#include "rviz_plugin/widgets.h"

#include <pluginlib/class_list_macros.hpp>
#include <ros/names.h>

#include <QFormLayout>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace devo_evo
{
namespace
{
constexpr std::chrono::seconds REFRESH_PERIOD{ 2 };
constexpr std::chrono::milliseconds ORDER_DELAY{ 150 };
constexpr std::chrono::milliseconds SETTLING{ 300 };
constexpr int64_t CHAMPION = -1;

/// The name of a node in rviz's namespace.
std::string resolved(const QString& name)
{
  return ros::names::resolve(name.toStdString());
}
}  // namespace

LineagePanel::LineagePanel(QWidget* parent)
  : rviz::Panel(parent)
  , experiment_(named("experiment", new QLineEdit))
  , trial_(named("trial", new QComboBox))
  , plot_(named("plot", new LineagePlot))
  , slider_(named("ancestor", new QSlider(Qt::Horizontal)))
  , description_(makeMessage("description"))
  , pause_(named("pause", new QPushButton("Pause")))
  , speed_(named("speed", new QDoubleSpinBox))
  , colour_(named("colour", new QComboBox))
  , film_(new FilmBox({ [this] { return filmOrder(); }, [this] { Q_EMIT configChanged(); } }))
  , errors_(makeErrorMessage("errors"))
{
  slider_->setEnabled(false);
  auto* column = new QVBoxLayout(this);
  column->addLayout(makeExperimentRow());
  column->addWidget(plot_, 1);
  column->addWidget(slider_);
  column->addWidget(description_);
  column->addLayout(makePlayerRow());
  column->addWidget(film_);
  column->addWidget(errors_);
  listTrials();
  showErrors();
  connectControls();
}

LineagePanel::~LineagePanel()
{
  // They outlive us, and a field that loses the focus as it goes says that it has been edited.
  for (QWidget* control : findChildren<QWidget*>())
  {
    control->blockSignals(true);
  }
}

QLayout* LineagePanel::makeExperimentRow()
{
  experiment_->setPlaceholderText("the running one, or the player's");
  experiment_->setClearButtonEnabled(true);
  experiment_->setToolTip(
      "Folder of an experiment, as an absolute path; empty: that of the player, or the running one");
  trial_->setToolTip("Whose champion's lineage is shown");
  auto* row = new QFormLayout;
  row->addRow("Experiment", experiment_);
  row->addRow("Champion of", trial_);
  return row;
}

QLayout* LineagePanel::makePlayerRow()
{
  speed_->setRange(0.001, 100.0);
  speed_->setDecimals(3);
  speed_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  speed_->setValue(1.0);
  speed_->setKeyboardTracking(false);
  speed_->setPrefix("speed ");
  speed_->setToolTip("Simulated time over real time");
  for (const char* name : { "resting_length", "remaining_development", "phase", "present_length" })
  {
    colour_->addItem(QString(name).replace('_', ' '), name);
  }
  colour_->setToolTip("What the colours of voxels tell");
  auto* row = new QHBoxLayout;
  row->addWidget(pause_);
  row->addWidget(speed_);
  row->addWidget(colour_, 1);
  return row;
}

void LineagePanel::connectControls()
{
  for (QTimer* timer : { &order_delay_, &settling_ })
  {
    timer->setSingleShot(true);
  }
  connect(&refresh_, &QTimer::timeout, [this] { readLineage(); });
  connect(&order_delay_, &QTimer::timeout, [this] { orderRobot(); });
  connect(&settling_, &QTimer::timeout, [this] { takeState(); });
  connect(experiment_, &QLineEdit::editingFinished,
          [this]
          {
            if (experiment_->isModified())
            {
              experiment_->setModified(false);
              changeExperiment();
            }
          });
  connect(experiment_, &QLineEdit::textChanged,
          [this](const QString& text)
          {
            if (text.isEmpty() && experiment_->isModified())  // by its button
            {
              experiment_->setModified(false);
              changeExperiment();
            }
          });
  connect(trial_, QOverload<int>::of(&QComboBox::activated), [this] { changeExperiment(); });
  connect(slider_, &QSlider::valueChanged, [this](int position) { choose(static_cast<size_t>(position)); });
  plot_->onChosen([this](size_t position) { choose(position); });
  connect(pause_, &QPushButton::clicked,
          [this]
          {
            if (client_)
            {
              client_->setPaused(!(client_->last() && client_->last()->paused));
            }
          });
  connect(speed_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), [this] { orderLook(); });
  connect(colour_, QOverload<int>::of(&QComboBox::activated), [this] { orderLook(); });
}

void LineagePanel::onInitialize()
{
  jobs_ = std::make_unique<BackgroundJobs>();
  connectPlayer();
  refresh_.start(REFRESH_PERIOD);
  QTimer::singleShot(0, this, [this] { readLineage(); });  // once the configuration is loaded
}

// ---- configuration -------------------------------------------------------------------------------------------------

void LineagePanel::load(const rviz::Config& config)
{
  rviz::Panel::load(config);
  QString text;
  int number = 0;
  float speed = 0.0f;
  if (config.mapGetString("Player", &text) && text != player_)
  {
    player_ = text;
    connectPlayer();
  }
  if (config.mapGetString("Experiment", &text))
  {
    experiment_->setText(text);
    impose_ = impose_ || !text.isEmpty();
  }
  if (config.mapGetInt("Trial", &number) && number > 0)
  {
    trial_->addItem("trial " + QString::number(number), number);
    trial_->setCurrentIndex(trial_->count() - 1);
    impose_ = true;
  }
  if (config.mapGetInt("Ancestor", &number) && number != CHAMPION)
  {
    wanted_id_ = number;
    impose_ = true;
  }
  const QSignalBlocker quiet(speed_);
  if (config.mapGetFloat("Speed", &speed))
  {
    speed_->setValue(static_cast<double>(speed));
    impose_ = true;
  }
  if (config.mapGetString("Colour", &text) && colour_->findData(text) >= 0)
  {
    colour_->setCurrentIndex(colour_->findData(text));
    impose_ = true;
  }
  if (config.mapGetString("Film", &text))
  {
    film_->setPath(text);
  }
  ++choice_;
}

void LineagePanel::save(rviz::Config config) const
{
  rviz::Panel::save(config);
  config.mapSetValue("Player", player_);
  config.mapSetValue("Experiment", experiment_->text());
  const bool ancestor = !follows_ && !view_.individuals.empty();
  config.mapSetValue("Trial", static_cast<int>(ancestor ? view_.trial : chosenTrial().value_or(0)));
  config.mapSetValue("Ancestor", static_cast<int>(ancestor ? view_.individuals[chosen_].individual.id : CHAMPION));
  config.mapSetValue("Speed", speed_->value());
  config.mapSetValue("Colour", colour_->currentData());
  config.mapSetValue("Film", film_->path());
}

// ---- experiment and lineage ----------------------------------------------------------------------------------------

void LineagePanel::changeExperiment()
{
  ++choice_;
  follows_ = true;
  wanted_id_ = CHAMPION;
  order_when_read_ = true;
  order_delay_.stop();
  readLineage();
  Q_EMIT configChanged();
}

/// In the background; one reading at a time.
void LineagePanel::readLineage()
{
  if (reading_ || !jobs_)
  {
    return;
  }
  reading_ = true;
  const auto job = [this, choice = choice_, folder = experiment_->text().toStdString(), player = resolved(player_),
                    trial = chosenTrial(), known = view_]() -> BackgroundJobs::Outcome
  {
    Reading reading;
    try
    {
      reading.view = readLineageView(folder.empty() ? folderOf(player) : folder, trial, known);
    }
    catch (const std::exception& error)
    {
      reading.error = error.what();
    }
    return [this, reading, choice] { takeReading(reading, choice); };
  };
  jobs_->run(job);
}

void LineagePanel::takeReading(const Reading& reading, int64_t choice)
{
  reading_ = false;
  if (choice != choice_)  // something else has been chosen meanwhile
  {
    readLineage();
    return;
  }
  read_error_ = QString::fromStdString(reading.error);
  if (reading.error.empty())
  {
    takeView(reading.view);
  }
  else if (order_when_read_)  // what is still there is of another experiment
  {
    view_ = LineageView();
    markChosen();
  }
  showErrors();
}

void LineagePanel::takeView(const LineageView& view)
{
  const bool same_experiment = view.folder == view_.folder && !view_.individuals.empty();
  const bool wanted = wanted_id_ != CHAMPION;
  const int64_t trial = wanted || !same_experiment ? view.trial : view_.trial;
  const int64_t id = wanted ? wanted_id_ : same_experiment ? view_.individuals[chosen_].individual.id : -1;
  const bool keeps = wanted || (same_experiment && !follows_);
  const LineageView before = std::exchange(view_, view);
  const std::optional<size_t> position = positionOf(trial, id);
  if (keeps && !position && !wanted)
  {
    view_ = before;  // another line or trial leads; who is looked at is not of it
    view_.trials = view.trials;
  }
  else
  {
    follows_ = !(keeps && position);
    chosen_ = follows_ ? view_.individuals.size() - 1 : *position;
    if (wanted && !position)
    {
      read_error_ = "individual " + QString::number(view.trial) + "/" + QString::number(wanted_id_) +
                    " is no ancestor of the champion; the champion is shown";
    }
  }
  wanted_id_ = CHAMPION;
  listTrials();
  markChosen();
  if (std::exchange(order_when_read_, false))
  {
    orderRobot();
  }
  imposeSettings();
  takeState();
}

/// Makes the list of trials that of the experiment, and leaves the choice as it is.
void LineagePanel::listTrials()
{
  const std::optional<int64_t> chosen = chosenTrial();
  std::vector<int64_t> trials = view_.trials;
  if (chosen && std::find(trials.begin(), trials.end(), *chosen) == trials.end())
  {
    trials.push_back(*chosen);
  }
  if (trial_->count() == static_cast<int>(trials.size()) + 1)
  {
    return;  // an open list would close
  }
  trial_->clear();
  trial_->addItem("best trial", 0);
  for (const int64_t trial : trials)
  {
    trial_->addItem("trial " + QString::number(trial), static_cast<qlonglong>(trial));
  }
  trial_->setCurrentIndex(trial_->findData(static_cast<qlonglong>(chosen.value_or(0))));
}

/// None: the best.
std::optional<int64_t> LineagePanel::chosenTrial() const
{
  const int64_t trial = trial_->currentData().toLongLong();
  return trial > 0 ? std::optional<int64_t>(trial) : std::nullopt;
}

std::optional<size_t> LineagePanel::positionOf(int64_t trial, int64_t id) const
{
  const auto found = std::find_if(view_.individuals.begin(), view_.individuals.end(),
                                  [&](const ArchivedIndividual& ancestor) { return ancestor.individual.id == id; });
  return trial != view_.trial || found == view_.individuals.end()
             ? std::nullopt
             : std::optional<size_t>(static_cast<size_t>(found - view_.individuals.begin()));
}

/// By the user.
void LineagePanel::choose(size_t position)
{
  if (position >= view_.individuals.size())
  {
    return;
  }
  chosen_ = position;
  follows_ = position + 1 == view_.individuals.size();
  markChosen();
  order_delay_.start(ORDER_DELAY);
  Q_EMIT configChanged();
}

void LineagePanel::markChosen()
{
  const QSignalBlocker quiet(slider_);
  const bool known = !view_.individuals.empty();
  chosen_ = known ? chosen_ : 0;
  slider_->setEnabled(known);
  slider_->setRange(0, known ? static_cast<int>(view_.individuals.size()) - 1 : 0);
  slider_->setValue(static_cast<int>(chosen_));
  plot_->setLineage(view_.individuals,
                    view_.body ? std::optional<LineageCurves>(lineageCurves(*view_.body)) : std::nullopt);
  plot_->setChosen(chosen_);
  describeChosen();
}

void LineagePanel::describeChosen()
{
  if (view_.individuals.empty())
  {
    setMessage(*description_, "");
    film_->offer("");
    return;
  }
  const ArchivedIndividual& ancestor = view_.individuals[chosen_];
  const std::optional<Evaluation>& life = ancestor.individual.evaluation;
  QString text = QString("%1, %2 of %3: born in generation %4, fitness %5, W_L %6, W_Φ %7")
                     .arg(QString::fromStdString(chosenIndividual()))
                     .arg(chosen_ + 1)
                     .arg(view_.individuals.size())
                     .arg(ancestor.individual.generation)
                     .arg(life && life->valid ? QString::fromStdString(view_.body->fitnessText(life->fitness))
                                              : "none (it diverges)")
                     .arg(QString::fromStdString(fixedText(ancestor.morphology_window, 3)))
                     .arg(QString::fromStdString(fixedText(ancestor.control_window, 3)));
  if (client_ && client_->last() && client_->last()->individual != chosenIndividual())
  {
    text += QString("\nThe player shows %1").arg(QString::fromStdString(client_->last()->individual));
  }
  setMessage(*description_, text);
  film_->offer(QString("%1/robot-%2-%3.mp4")
                   .arg(QString::fromStdString(view_.folder))
                   .arg(view_.trial)
                   .arg(ancestor.individual.id));
}

std::string LineagePanel::chosenIndividual() const
{
  return individualName(view_.trial, view_.individuals[chosen_].individual.id);
}

// ---- player --------------------------------------------------------------------------------------------------------

void LineagePanel::connectPlayer()
{
  order_error_ = "waiting for the player " + QString::fromStdString(resolved(player_));
  client_ = std::make_unique<PlayerClient>(
      resolved(player_), PlayerClient::Callbacks{ [this](const PlayerState&)
                                                  {
                                                    order_error_.clear();
                                                    imposeSettings();
                                                    takeState();
                                                    showErrors();
                                                  },
                                                  [this](const std::string& error) { takeAnswer(error); } });
  showErrors();
}

void LineagePanel::orderRobot()
{
  if (!client_ || view_.individuals.empty())
  {
    return;
  }
  Show::Request request;
  request.output = view_.folder;
  request.individual = chosenIndividual();
  if (follows_)
  {
    const std::optional<int64_t> trial = chosenTrial();
    request.individual = toString(RobotChoice{ trial, std::nullopt });
  }
  client_->show(request);
}

void LineagePanel::orderLook()
{
  if (client_)
  {
    Show::Request request;
    request.colour = colour_->currentData().toString().toStdString();
    request.speed = speed_->value();
    client_->show(request);
  }
  Q_EMIT configChanged();
}

/// Tells the player what was loaded from the configuration, once both are there.
void LineagePanel::imposeSettings()
{
  if (impose_ && client_->last() && !view_.individuals.empty())
  {
    impose_ = false;
    orderRobot();
    orderLook();
  }
}

bool LineagePanel::settled() const
{
  return client_ && client_->last() && !client_->busy() && !impose_ && !order_when_read_ && !order_delay_.isActive() &&
         !settling_.isActive();
}

/// Sets the controls to what the player does, unless it is still to be told something else.
void LineagePanel::takeState()
{
  describeChosen();
  if (!settled())
  {
    return;
  }
  const PlayerState& state = *client_->last();
  const QSignalBlocker quiet_speed(speed_);
  pause_->setText(state.paused ? "Play" : "Pause");
  speed_->setValue(state.speed);
  colour_->setCurrentIndex(std::max(0, colour_->findData(QString::fromStdString(state.colour))));
  const std::optional<size_t> position = positionOf(state.trial, state.id);
  if (position && *position != chosen_)
  {
    chosen_ = *position;
    follows_ = chosen_ + 1 == view_.individuals.size();
    markChosen();
  }
}

void LineagePanel::takeAnswer(const std::string& error)
{
  order_error_ = QString::fromStdString(error);
  settling_.start(SETTLING);
  showErrors();
}

// ---- film and errors -----------------------------------------------------------------------------------------------

/// @pre there is a lineage.
FilmOrder LineagePanel::filmOrder() const
{
  return { QString::fromStdString(view_.folder), QString::fromStdString(chosenIndividual()), "",
           colour_->currentData().toString(), speed_->value() };
}

void LineagePanel::showErrors()
{
  QStringList errors = { read_error_, order_error_ };
  errors.removeAll("");
  setMessage(*errors_, errors.join('\n'));
}
}  // namespace devo_evo

PLUGINLIB_EXPORT_CLASS(devo_evo::LineagePanel, rviz::Panel)
