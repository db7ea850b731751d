#include "ros/conversions.h"

#include "devo_evo/soft_body/simulation.h"
#include "ros/message_fields.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <limits>

namespace devo_evo
{
namespace
{
using test::setValue;
using test::valueOf;
using test::valuesOf;

constexpr double NONE = Evaluation::NONE;
constexpr double INF = std::numeric_limits<double>::infinity();

/// Every field differs from its default and from its neighbours.
SoftBodySettings unusualSettings()
{
  SoftBodySettings settings;
  settings.grid_x = 2;
  settings.grid_y = 3;
  settings.grid_z = 1;
  settings.lifetime = 1.25;
  settings.voxel_size = 0.011;
  settings.density = 1.1e6;
  settings.youngs_modulus = 5.1e6;
  settings.poissons_ratio = 0.31;
  settings.static_friction = 1.2;
  settings.dynamic_friction = 0.4;
  settings.gravity = 9.0;
  settings.slope = -0.1;
  settings.bond_damping = 0.9;
  settings.contact_damping = 0.7;
  settings.global_damping = 0.02;
  settings.time_step_fraction = 0.3;
  settings.actuation_frequency = 3.5;
  settings.actuation_amplitude = 0.12;
  settings.self_collision = false;
  settings.sideways_bend_test = true;
  return settings;
}

const Body& unusualBody()
{
  static const std::shared_ptr<const Body> body = makeSoftBody(unusualSettings());
  return *body;
}

DevelopmentalProgram programFor(const SoftBodySettings& settings)
{
  const auto count = static_cast<size_t>(settings.voxelCount());
  DevelopmentalProgram program;
  for (size_t i = 0; i < count; ++i)
  {
    const double value = static_cast<double>(i + 1) / static_cast<double>(count + 1);
    program.morphology_initial.push_back(value);
    program.morphology_final.push_back(-value);
    program.control_initial.push_back(value / 3.0);
    program.control_final.push_back(-value / 7.0);
  }
  return program;
}

Evaluation soundEvaluation()
{
  Evaluation evaluation;
  evaluation.valid = true;
  evaluation.fitness = -0.125;
  evaluation.displacement_y_voxels = -0.375;
  evaluation.displacement_xy_voxels = 0.5;
  evaluation.first_top_contact_since_birth_s = 0.3;
  evaluation.turns = 1.0 / 3.0;
  evaluation.airborne_fraction = 0.25;
  evaluation.velocity_body_lengths_per_s = { 0.1, -0.2, -0.3 };
  evaluation.state_hash = 0xffffffffffffffff;
  return evaluation;
}

Evaluation divergedEvaluation()
{
  Evaluation evaluation;
  evaluation.divergence = Divergence{ 123, 4, INF };
  return evaluation;
}

void expectEqual(const Evaluation& a, const Evaluation& b)
{
  EXPECT_EQ(a.valid, b.valid);
  EXPECT_EQ(std::memcmp(&a.fitness, &b.fitness, sizeof(double)), 0);
  EXPECT_EQ(std::memcmp(&a.displacement_y_voxels, &b.displacement_y_voxels, sizeof(double)), 0);
  EXPECT_EQ(std::memcmp(&a.displacement_xy_voxels, &b.displacement_xy_voxels, sizeof(double)), 0);
  EXPECT_EQ(a.first_top_contact_since_birth_s, b.first_top_contact_since_birth_s);
  EXPECT_EQ(a.fell_over_since_birth_s, b.fell_over_since_birth_s);
  EXPECT_EQ(std::memcmp(&a.turns, &b.turns, sizeof(double)), 0);
  EXPECT_EQ(std::memcmp(&a.airborne_fraction, &b.airborne_fraction, sizeof(double)), 0);
  EXPECT_EQ(a.velocity_body_lengths_per_s, b.velocity_body_lengths_per_s);
  EXPECT_EQ(a.state_hash, b.state_hash);
  ASSERT_EQ(a.divergence.has_value(), b.divergence.has_value());
  if (a.divergence)
  {
    EXPECT_EQ(a.divergence->step, b.divergence->step);
    EXPECT_EQ(a.divergence->bond, b.divergence->bond);
    EXPECT_EQ(a.divergence->strain, b.divergence->strain);
  }
}

std::string complaint(const std::function<void()>& function)
{
  try
  {
    function();
  }
  catch (const InvalidInput& e)
  {
    return e.what();
  }
  return "";
}

TEST(Conversions, SettingsComeBackAsTheyWere)
{
  const SoftBodySettings settings = unusualSettings();
  const SoftBodySettings back = fromMsg(toMsg(BodySettings(settings))).soft;
  for (const auto& field : softBodyIntegers())
  {
    EXPECT_EQ(back.*field.value, settings.*field.value) << field.name;
  }
  for (const auto& field : softBodyReals())
  {
    EXPECT_EQ(back.*field.value, settings.*field.value) << field.name;
  }
  EXPECT_EQ(back.self_collision, settings.self_collision);
  EXPECT_EQ(back.sideways_bend_test, settings.sideways_bend_test);
}

TEST(Conversions, SettingsOfARigidBodyComeBackAsTheyWere)
{
  RigidBodySettings settings;
  settings.slope = 3.25;
  settings.light_distance = 1.0 / 3.0;
  const BodySettings back = fromMsg(toMsg(BodySettings(settings)));
  EXPECT_EQ(back.kind, BodyKind::RIGID);
  for (const auto& field : rigidBodyReals())
  {
    EXPECT_EQ(back.rigid.*field.value, settings.*field.value) << field.name;
  }
}

TEST(Conversions, SettingsOutOfRangeAreRefusedByName)
{
  EvaluationSettings message = toMsg(BodySettings());
  setValue(message, "grid", "4x2000000000x3");  // an overflow
  EXPECT_EQ(complaint([&] { fromMsg(message); }).find("grid is \"4x2000000000x3\"; it must be"), 0u);
  for (const char* const nonsense : { "nan", "inf", "-inf", "-1", "", "one" })
  {
    for (const char* const name : { "lifetime", "density", "gravity", "time_step_fraction", "actuation_amplitude" })
    {
      message = toMsg(BodySettings());
      setValue(message, name, nonsense);
      EXPECT_THROW(fromMsg(message), InvalidInput) << name << " " << nonsense;
    }
  }
}

TEST(Conversions, SettingsOfNoBodyAreRefused)
{
  const std::vector<std::function<void(EvaluationSettings&)>> corruptions = {
    [](EvaluationSettings& message) { setValue(message, "body", "liquid"); },
    [](EvaluationSettings& message) { setValue(message, "body", "rigid"); },
    [](EvaluationSettings& message) { message.names.pop_back(); },
    [](EvaluationSettings& message) { message.names[0] = message.names[1]; },
    [](EvaluationSettings& message) { message.names[2] = "gravitation"; },
    [](EvaluationSettings& message)
    {
      message.names.push_back("rigid_slope");
      message.values.push_back("1");
    },
    [](EvaluationSettings& message)
    {
      message.names.clear();
      message.values.clear();
    },
  };
  for (size_t i = 0; i < corruptions.size(); ++i)
  {
    EvaluationSettings message = toMsg(BodySettings());
    corruptions[i](message);
    EXPECT_THROW(fromMsg(message), InvalidInput) << "corruption " << i;
  }
}

TEST(Conversions, AGenomeComesBackAsItWas)
{
  const SoftBodySettings settings = unusualSettings();
  const Genome genome{ programFor(settings), std::vector<double>(6, 0.5) };
  EXPECT_TRUE(fromMsg(toMsg(genome, unusualBody()), unusualBody()) == genome);
}

TEST(Conversions, AGenomeThatDoesNotFitIsRefused)
{
  const SoftBodySettings settings = unusualSettings();
  const Genome genome{ programFor(settings), {} };
  const std::vector<std::function<void(RobotGenome&)>> corruptions = {
    [](RobotGenome& message) { valuesOf(message, "size_gene_initial").push_back(0.0); },
    [](RobotGenome& message) { valuesOf(message, "size_gene_final").clear(); },
    [](RobotGenome& message) { valuesOf(message, "phase_initial")[3] = NONE; },
    [](RobotGenome& message) { valuesOf(message, "phase_final")[5] = 1.1; },
    [](RobotGenome& message) { message.arrays[1].name = "size_gene"; },
    [](RobotGenome& message) { message.arrays.push_back(message.arrays[0]); },
    [](RobotGenome& message) { message.arrays.pop_back(); },
    [](RobotGenome& message) { message.body = "rigid"; },
    [](RobotGenome& message) { message.mutation_rate = { 0.5 }; },
    [](RobotGenome& message) { message.mutation_rate.assign(6, NONE); },
  };
  for (const auto& corrupt : corruptions)
  {
    RobotGenome message = toMsg(genome, unusualBody());
    corrupt(message);
    EXPECT_THROW(fromMsg(message, unusualBody()), InvalidInput);
  }
}

TEST(Conversions, AGenomeOfTheOtherBodyIsRefusedByName)
{
  const std::shared_ptr<const Body> rigid = makeRigidBody(RigidBodySettings());
  const Genome soft{ programFor(unusualSettings()), {} };
  EXPECT_EQ(complaint([&] { fromMsg(toMsg(soft, unusualBody()), *rigid); }),
            "the genome is one of a \"soft\" body where one of a rigid body is needed");
}

TEST(Conversions, ARigidEvaluationComesBackAsItWas)
{
  RigidBodySettings settings;
  settings.lifetime = 1.25;
  const std::shared_ptr<const Body> body = makeRigidBody(settings);
  const DevelopmentalProgram program = {
    { 1, 1, 0.5, 0.5 }, { 0, 0, 0, 0 }, std::vector<double>(8, 0.5), std::vector<double>(8, -0.5)
  };
  const Evaluation evaluation = body->evaluate({ program }, InstructionSet::SCALAR).front();
  ASSERT_TRUE(evaluation.valid);
  RobotEvaluation message = toMsg(evaluation, 1, 2, *body);
  const Evaluation back = fromMsg(message, *body);
  expectEqual(back, evaluation);
  for (const Measure& measure : body->measures())
  {
    const double given = measure.get(evaluation), got = measure.get(back);
    EXPECT_TRUE(given == got || (std::isnan(given) && std::isnan(got))) << measure.name;
  }
  EXPECT_EQ(message.velocity.size(), 3u);
  valueOf(message.measures, "leg_contact") = 1.5;
  EXPECT_THROW(fromMsg(message, *body), InvalidInput);
}

TEST(Conversions, EvaluationsComeBackAsTheyWere)
{
  for (const Evaluation& evaluation : { soundEvaluation(), divergedEvaluation() })
  {
    const RobotEvaluation message = toMsg(evaluation, 3, 1042, unusualBody());
    EXPECT_EQ(message.trial, 3);
    EXPECT_EQ(message.id, 1042);
    expectEqual(fromMsg(message, unusualBody()), evaluation);
  }
}

TEST(Conversions, TrueEvaluationsAreAcceptedWhateverTheLifetime)
{
  for (const double lifetime : { 0.02, 0.5, 0.500001, 0.7, 1.0 })
  {
    SoftBodySettings settings = unusualSettings();
    settings.lifetime = lifetime;
    const Evaluation evaluation = evaluate(settings, { programFor(settings) }).front();
    ASSERT_TRUE(evaluation.valid);
    const std::shared_ptr<const Body> body = makeSoftBody(settings);
    expectEqual(fromMsg(toMsg(evaluation, 1, 1, *body), *body), evaluation);
  }
}

TEST(Conversions, MeasuresThatNoEvaluationHasAreRefused)
{
  const std::vector<std::function<void(RobotEvaluation&)>> corruptions = {
    [](RobotEvaluation& message) { message.fitness = INF; },
    [](RobotEvaluation& message) { valueOf(message.measures, "displacement_y_voxels") = 17.0; },
    [](RobotEvaluation& message) { valueOf(message.measures, "displacement_xy_voxels") = NONE; },
    [](RobotEvaluation& message) { valueOf(message.measures, "first_top_contact_since_birth_s") = -1.0; },
    [](RobotEvaluation& message) { valueOf(message.measures, "fell_over_since_birth_s") = INF; },
    [](RobotEvaluation& message) { valueOf(message.measures, "turns") = NONE; },
    [](RobotEvaluation& message) { valueOf(message.measures, "airborne_fraction") = -0.1; },
    [](RobotEvaluation& message) { message.velocity[1] = NONE; },
    [](RobotEvaluation& message) { message.velocity.resize(1000); },
    [](RobotEvaluation& message) { message.failure.resize(3); },
    [](RobotEvaluation& message) { message.measures.pop_back(); },
    [](RobotEvaluation& message) { message.measures[0].name = "displacement"; },
    [](RobotEvaluation& message) { message.valid = false; },
  };
  for (size_t i = 0; i < corruptions.size(); ++i)
  {
    RobotEvaluation message = toMsg(soundEvaluation(), 1, 1, unusualBody());
    corruptions[i](message);
    EXPECT_THROW(fromMsg(message, unusualBody()), InvalidInput) << "corruption " << i;
  }
}

TEST(Conversions, DivergencesThatCannotBeAreRefused)
{
  const std::vector<std::function<void(RobotEvaluation&)>> corruptions = {
    [](RobotEvaluation& message) { valueOf(message.failure, "divergence_step") = 0; },
    [](RobotEvaluation& message) { valueOf(message.failure, "divergence_step") = 1000000000; },
    [](RobotEvaluation& message)
    { valueOf(message.failure, "divergence_bond") = 7; },  // 2x3x1 voxels have 7 bonds, from 0
    [](RobotEvaluation& message) { valueOf(message.failure, "divergence_bond") = -1; },
    [](RobotEvaluation& message) { valueOf(message.failure, "divergence_strain") = 100.0; },
    [](RobotEvaluation& message) { message.fitness = 0.0; },
    [](RobotEvaluation& message) { message.state_hash = 1; },
    [](RobotEvaluation& message) { message.velocity = { 0.0 }; },
    [](RobotEvaluation& message) { message.valid = true; },
  };
  for (size_t i = 0; i < corruptions.size(); ++i)
  {
    RobotEvaluation message = toMsg(divergedEvaluation(), 1, 1, unusualBody());
    corruptions[i](message);
    EXPECT_THROW(fromMsg(message, unusualBody()), InvalidInput) << "corruption " << i;
  }
}

TEST(Conversions, ARequestComesBackAsItWas)
{
  const SoftBodySettings settings = unusualSettings();
  const std::vector<EvaluationRequest> robots = { { 1, 5, programFor(settings) }, { 2, 7, programFor(settings) } };
  const EvaluateGenomes::Request request = toRequest(robots, BodySettings(settings), unusualBody(), 99);
  EXPECT_EQ(request.engine_fingerprint, 99u);
  const auto back = robotsOf(request, *makeBody(fromMsg(request.settings)));
  ASSERT_EQ(back.size(), 2u);
  EXPECT_EQ(back[1].trial, 2);
  EXPECT_EQ(back[1].id, 7);
  EXPECT_TRUE(back[1].program == robots[1].program);
}

TEST(Conversions, ARequestIsRefusedWithItsFaultNamed)
{
  const SoftBodySettings settings = unusualSettings();
  const EvaluateGenomes::Request sound =
      toRequest({ { 1, 5, programFor(settings) } }, BodySettings(settings), unusualBody(), 0);

  EvaluateGenomes::Request request = sound;
  request.id.push_back(6);
  EXPECT_EQ(complaint([&] { robotsOf(request, unusualBody()); }), "trial, id and genomes must have the same size");

  request = sound;
  request.genomes.resize(65, sound.genomes[0]);
  EXPECT_EQ(complaint([&] { robotsOf(request, unusualBody()); }), "65 genomes in one request; at most 64 are allowed");

  request = sound;
  valuesOf(request.genomes[0], "phase_final")[2] = 2.0;
  EXPECT_EQ(complaint([&] { robotsOf(request, unusualBody()); }),
            "robot 1/5: phase_final[2] is 2; it must lie within -1 to 1");
}

TEST(Conversions, AReasonForQuarantineIsATextWithoutRobots)
{
  const SoftBodySettings settings = unusualSettings();
  EvaluateGenomes::Request request = toRequest({}, BodySettings(settings), unusualBody(), 0);
  EXPECT_EQ(quarantineOf(request), std::nullopt);
  request.quarantine = "wrong";
  EXPECT_EQ(quarantineOf(request), "wrong");
  for (const std::string& text : { std::string(256, 'x'), std::string("two\nlines") })
  {
    request.quarantine = text;
    EXPECT_EQ(complaint([&] { quarantineOf(request); }), "quarantine must be at most 255 printable ASCII characters");
  }
  request = toRequest({ { 1, 5, programFor(settings) } }, BodySettings(settings), unusualBody(), 0);
  request.quarantine = "wrong";
  EXPECT_EQ(complaint([&] { quarantineOf(request); }),
            "a request with robots for a simulator that is to be quarantined");
}

TEST(Conversions, TelemetryTellsWhenEachWindowEnds)
{
  const SoftBodySettings settings = unusualSettings();  // a lifetime of 1.25 s
  const VelocityTelemetry telemetry =
      telemetryOf({ 2, 9, programFor(settings) }, soundEvaluation(), unusualBody(), "/simulator");
  EXPECT_EQ(telemetry.trial, 2);
  EXPECT_EQ(telemetry.id, 9);
  EXPECT_EQ(telemetry.header.frame_id, "world");
  EXPECT_EQ(telemetry.window_end, (std::vector<double>{ 0.5, 1.0, 1.25 }));
  EXPECT_EQ(telemetry.velocity, (std::vector<double>{ 0.1, -0.2, -0.3 }));
  EXPECT_EQ(telemetry.mean_velocity, -0.125 / 1.25);

  const VelocityTelemetry none = telemetryOf({ 2, 9, programFor(settings) }, divergedEvaluation(), unusualBody(), "/s");
  EXPECT_FALSE(none.valid);
  EXPECT_TRUE(none.velocity.empty() && none.window_end.empty());
  EXPECT_TRUE(std::isnan(none.mean_velocity));
}

TEST(Conversions, AnIndividualKeepsItsPlaceInTheLineage)
{
  ExperimentSettings settings;
  settings.body.soft = unusualSettings();
  ArchivedIndividual archived;
  archived.individual = { 3, 1042, 17, 40, 2, { programFor(unusualSettings()), {} }, soundEvaluation() };
  archived.has_genome = true;
  archived.morphology_window = 0.25;
  archived.control_window = 0.75;
  const EvolvedRobot message = toMsg(archived, settings);
  EXPECT_EQ(message.trial, 3);
  EXPECT_EQ(message.id, 1042);
  EXPECT_EQ(message.parent, 17);
  EXPECT_EQ(message.born, 40);
  EXPECT_EQ(message.age, 2);
  EXPECT_EQ(message.treatment, "evo_devo");
  EXPECT_EQ(message.morphology_window, 0.25);
  EXPECT_EQ(message.control_window, 0.75);
  EXPECT_EQ(message.evaluation.id, 1042);
  EXPECT_EQ(message.evaluation.fitness, -0.125);
}

TEST(Conversions, AnnouncementsOfNonsenseAreRefused)
{
  SimulatorAnnouncement sound;
  sound.name = "/devo_evo/simulator_1";
  sound.service = "/devo_evo/simulator_1/evaluate";
  sound.host = "laptop";
  sound.version = "0.1.0 (abc)";
  sound.instruction_set = "avx2";
  sound.lanes = 4;
  sound.period = 0.5;
  EXPECT_EQ(complaint([&] { validate(sound); }), "");
  const std::vector<std::function<void(SimulatorAnnouncement&)>> corruptions = {
    [](SimulatorAnnouncement& message) { message.name.clear(); },
    [](SimulatorAnnouncement& message) { message.name = "/" + std::string(1000, 'x'); },
    [](SimulatorAnnouncement& message) { message.name = "relative"; },
    [](SimulatorAnnouncement& message) { message.service = "/not a name"; },
    [](SimulatorAnnouncement& message) { message.host = "\x1b[2J"; },
    [](SimulatorAnnouncement& message) { message.engines.resize(100); },
    [](SimulatorAnnouncement& message) { message.lanes = 0; },
    [](SimulatorAnnouncement& message) { message.lanes = 65; },
    [](SimulatorAnnouncement& message) { message.period = NONE; },
    [](SimulatorAnnouncement& message) { message.period = 0.0; },
    [](SimulatorAnnouncement& message) { message.evaluations = -1; },
  };
  for (size_t i = 0; i < corruptions.size(); ++i)
  {
    SimulatorAnnouncement message = sound;
    corruptions[i](message);
    EXPECT_THROW(validate(message), InvalidInput) << "corruption " << i;
  }
}
}  // namespace
}  // namespace devo_evo
