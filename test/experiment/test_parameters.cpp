#include "devo_evo/experiment/parameters.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <limits>
#include <set>

namespace devo_evo
{
namespace
{
/// What an action complains of; "" if it does not.
template <class Action>
std::string complaint(const Action& action)
{
  try
  {
    action();
  }
  catch (const InvalidInput& error)
  {
    return error.what();
  }
  return "";
}

std::string complaintOfSetting(const std::string& name, const ParameterValue& value)
{
  Parameters parameters;
  return complaint([&] { setParameter(parameters, name, value, "--" + name); });
}

/// The parameter's value as text after setting it.
std::string after(const std::string& name, const ParameterValue& value)
{
  Parameters parameters;
  setParameter(parameters, name, value, "test");
  return parameterSpec(name).get(parameters);
}

class YamlFile : public ::testing::Test
{
protected:
  void write(const std::string& content) { std::ofstream(path_, std::ios::binary) << content; }

  /// The complaint about a file of this content, without the file's folder.
  std::string complaintOf(const std::string& content)
  {
    write(content);
    const std::string message = complaint([this] { loadParameters(parameters_, path_); });
    return message.rfind(folder_, 0) == 0 ? message.substr(folder_.size()) : message;
  }

  const std::string folder_ = ::testing::TempDir();
  const std::string name_ = ::testing::UnitTest::GetInstance()->current_test_info()->name() + std::string(".yaml");
  const std::string path_ = folder_ + name_;
  Parameters parameters_;
};

std::string contentOf(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
}

TEST(ParameterTable, NamesAreUniqueAndDescribed)
{
  std::set<std::string> names;
  for (const ParameterSpec& spec : parameterSpecs())
  {
    EXPECT_TRUE(names.insert(spec.name).second) << spec.name;
    ASSERT_FALSE(spec.description.empty()) << spec.name;
    EXPECT_EQ(spec.description.back(), '.') << spec.name;
    EXPECT_FALSE(spec.allowed.empty()) << spec.name;
  }
}

TEST(ParameterTable, HoldsEveryBoundedFieldOfTheSettings)
{
  for (const auto& field : softBodyReals())
  {
    EXPECT_NO_THROW(parameterSpec(field.name)) << field.name;
  }
  for (const auto& field : evolutionIntegers())
  {
    EXPECT_NO_THROW(parameterSpec(field.name)) << field.name;
  }
  for (const auto& field : evolutionReals())
  {
    EXPECT_NO_THROW(parameterSpec(field.name)) << field.name;
  }
  for (const auto& field : experimentIntegers())
  {
    EXPECT_NO_THROW(parameterSpec(field.name)) << field.name;
  }
}

TEST(ParameterTable, EveryDefaultReadsBackAsItself)
{
  for (const ParameterSpec& spec : parameterSpecs())
  {
    EXPECT_EQ(after(spec.name, spec.default_text), spec.default_text) << spec.name;
  }
}

TEST(ParameterTable, DefaultsAreThePapers)
{
  EXPECT_EQ(parameterSpec("treatment").default_text, "evo_devo");
  EXPECT_EQ(parameterSpec("profile").default_text, "paper");
  EXPECT_EQ(parameterSpec("mutation_rate").default_text, "self_adaptive");
  EXPECT_EQ(parameterSpec("population").default_text, "30");
  EXPECT_EQ(parameterSpec("lifetime").default_text, "10");
  EXPECT_EQ(parameterSpec("grid").default_text, "4x4x3");
  EXPECT_EQ(parameterSpec("youngs_modulus").default_text, "5e+06");
}

TEST(SettingAParameter, TakesTypedValuesAndText)
{
  EXPECT_EQ(after("generations", int64_t{ 500 }), "500");
  EXPECT_EQ(after("generations", std::string("500")), "500");
  EXPECT_EQ(after("lifetime", 2.5), "2.5");
  EXPECT_EQ(after("lifetime", int64_t{ 2 }), "2");
  EXPECT_EQ(after("lifetime", std::string("2.5e0")), "2.5");
  EXPECT_EQ(after("self_collision", false), "false");
  EXPECT_EQ(after("self_collision", std::string("false")), "false");
  EXPECT_EQ(after("grid", std::vector<int64_t>{ 2, 3, 1 }), "2x3x1");
  EXPECT_EQ(after("grid", std::string("2x3x1")), "2x3x1");
  EXPECT_EQ(after("treatment", std::string("evo")), "evo");
  EXPECT_EQ(after("profile", std::string("released_code")), "released_code");
  EXPECT_EQ(after("seed", std::string("9223372036854775807")), "9223372036854775807");
  EXPECT_EQ(after("output", std::string("/tmp/a b")), "/tmp/a b");
  EXPECT_EQ(after("founders", std::string("/tmp/a b.jsonl")), "/tmp/a b.jsonl");
}

TEST(SettingAParameter, LosesNoDigits)
{
  EXPECT_EQ(after("gravity", 0.1 + 0.2), "0.30000000000000004");
  EXPECT_EQ(after("mutation_rate", 1.0 / 48), "0.020833333333333332");
}

TEST(SettingAParameter, TakesAFixedMutationRateOrSelfAdaptiveOnes)
{
  Parameters parameters;
  setParameter(parameters, "mutation_rate", std::string("0.5"), "test");
  EXPECT_EQ(parameters.experiment.evolution.mutation_rate, 0.5);
  setParameter(parameters, "mutation_rate", std::string("self_adaptive"), "test");
  EXPECT_FALSE(parameters.experiment.evolution.mutation_rate.has_value());
  EXPECT_EQ(after("mutation_rate", int64_t{ 0 }), "0");
  EXPECT_EQ(after("mutation_rate", -0.0), "0");
}

TEST(SettingAParameter, SaysWhatIsWrongWhereAndWhatWouldBeRight)
{
  EXPECT_EQ(complaintOfSetting("lifetime", 2000.0),
            "--lifetime: lifetime is 2000; it must be a number within 0.001 to 1000 s");
  EXPECT_EQ(complaintOfSetting("generations", std::string("many")),
            "--generations: generations is \"many\"; it must be a whole number within 0 to 1000000");
  EXPECT_EQ(complaintOfSetting("treatment", std::string("evodevo")),
            "--treatment: treatment is \"evodevo\"; it must be evo, evo_devo, evo_devo_body or evo_devo_control");
  EXPECT_EQ(complaintOfSetting("grid", std::vector<int64_t>{ 4, 4 }),
            "--grid: grid is [4, 4]; it must be written like 4x4x3 or [4, 4, 3], each within 1 to 64 voxels");
}

TEST(SettingAParameter, RefusesWrongTypesAndChangesNothing)
{
  const std::vector<std::pair<std::string, ParameterValue>> wrong = {
    { "generations", 2.5 },
    { "generations", true },
    { "generations", std::string("20.0") },
    { "generations", std::string("") },
    { "generations", std::string(" 20") },
    { "generations", std::string("20 ") },
    { "seed", std::string("9223372036854775808") },
    { "lifetime", true },
    { "lifetime", std::string("0,5") },
    { "lifetime", std::string("10s") },
    { "lifetime", std::string("0x10") },
    { "self_collision", int64_t{ 1 } },
    { "self_collision", std::string("yes") },
    { "treatment", int64_t{ 1 } },
    { "founders", std::string("~/robots.jsonl") },
    { "output", true },
    { "output", std::string("~/results") },
    { "grid", std::string("4x4") },
    { "grid", std::string("4x4x3x2") },
    { "grid", std::string("4x4x") },
    { "grid", std::string("4X4X3") },
    { "grid", int64_t{ 4 } },
    { "mutation_rate", std::string("adaptive") },
    { "instruction_set", std::string("sse") },
  };
  for (const auto& each : wrong)
  {
    Parameters parameters;
    const std::string message = complaint([&] { setParameter(parameters, each.first, each.second, "test"); });
    EXPECT_NE(message.find(each.first + " is "), std::string::npos) << each.first << ": " << message;
    const ParameterSpec& spec = parameterSpec(each.first);
    EXPECT_EQ(spec.get(parameters), spec.default_text) << each.first;
  }
}

TEST(SettingAParameter, RefusesNumbersOutOfRange)
{
  EXPECT_NE(complaintOfSetting("trials", int64_t{ 0 }), "");
  EXPECT_NE(complaintOfSetting("population", int64_t{ 10001 }), "");
  EXPECT_NE(complaintOfSetting("population", int64_t{ 4294967326 }), "");  // 30 after losing its upper half
  EXPECT_NE(complaintOfSetting("seed", int64_t{ -1 }), "");
  EXPECT_NE(complaintOfSetting("mutation_rate", 1.0001), "");
  EXPECT_NE(complaintOfSetting("grid", std::string("4x4x0")), "");
  EXPECT_NE(complaintOfSetting("grid", std::string("4x65x3")), "");
}

TEST(SettingAParameter, RefusesWhatIsNotFinite)
{
  for (const std::string name : { "lifetime", "gravity", "mutation_rate", "batch_timeout" })
  {
    EXPECT_NE(complaintOfSetting(name, std::numeric_limits<double>::quiet_NaN()), "") << name;
    EXPECT_NE(complaintOfSetting(name, std::numeric_limits<double>::infinity()), "") << name;
    EXPECT_NE(complaintOfSetting(name, std::string("nan")), "") << name;
    EXPECT_NE(complaintOfSetting(name, std::string("inf")), "") << name;
    EXPECT_NE(complaintOfSetting(name, std::string("1e999")), "") << name;
  }
}

TEST(SettingAParameter, NamesTheClosestParameterForAnUnknownOne)
{
  EXPECT_EQ(complaintOfSetting("lifetme", 1.0),
            "--lifetme: there is no parameter \"lifetme\"; the closest is lifetime");
  EXPECT_EQ(complaintOfSetting(std::string(1000000, 'n'), 1.0).substr(1000002),
            ": there is no parameter \"" + std::string(80, 'n') + "...\"; the closest is announcement_period");
  EXPECT_NE(complaintOfSetting("generation", 1.0).find("the closest is generations"), std::string::npos);
  EXPECT_NE(complaintOfSetting("mutation-rate", 1.0).find("the closest is mutation_rate"), std::string::npos);
}

TEST_F(YamlFile, SetsWhatItHoldsAndNothingElse)
{
  write("treatment: evo\ngrid: [2, 2, 2]\nlifetime: 1.5   # seconds\nself_collision: false\nseed: \"7\"\n");
  loadParameters(parameters_, path_);
  EXPECT_EQ(parameters_.experiment.evolution.treatment, Treatment::EVO);
  EXPECT_EQ(parameters_.experiment.body.soft.voxelCount(), 8);
  EXPECT_EQ(parameters_.experiment.body.soft.lifetime, 1.5);
  EXPECT_FALSE(parameters_.experiment.body.soft.self_collision);
  EXPECT_EQ(parameters_.experiment.evolution.seed, 7);
  EXPECT_EQ(parameters_.experiment.evolution.population, 30);
}

TEST_F(YamlFile, MayBeEmpty)
{
  EXPECT_EQ(complaintOf(""), "");
  EXPECT_EQ(complaintOf("# nothing but a comment\n"), "");
}

TEST_F(YamlFile, ComplaintsNameFileAndLine)
{
  EXPECT_EQ(complaintOf("trials: 2\nlifetime: -1\n"),
            name_ + ":2: lifetime is \"-1\"; it must be a number within 0.001 to 1000 s");
  EXPECT_EQ(complaintOf("# a comment\n\nlifetyme: 1\n"),
            name_ + ":3: there is no parameter \"lifetyme\"; the closest is lifetime");
  EXPECT_EQ(complaintOf("seed: 1\ntrials: 2\nseed: 3\n"), name_ + ":3: seed is given twice, first in " + path_ + ":1");
  EXPECT_EQ(complaintOf("seed:\n"), name_ +
                                        ":1: seed has no value; it must be a whole number within 0 to "
                                        "9223372036854775807");
  EXPECT_EQ(complaintOf("gravity: { x: 1 }\n"), name_ + ":1: gravity is a map; it must be a number within 0 to 1000");
  EXPECT_EQ(complaintOf("grid: [4, 4, 3.5]\n"), name_ +
                                                    ":1: grid is \"[4, 4, 3.5]\"; it must be written like 4x4x3 "
                                                    "or [4, 4, 3], each within 1 to 64 voxels");
}

TEST_F(YamlFile, MalformedOnesAreRefusedWithTheLine)
{
  EXPECT_EQ(complaintOf("trials: 2\ngrid: [4, 4\n").rfind(name_ + ":", 0), 0u);
  EXPECT_NE(complaintOf("trials: 2\n\tseed: 1\n").find(":2: malformed YAML: "), std::string::npos);
  EXPECT_NE(complaintOf("- trials\n- seed\n").find("\"name: value\""), std::string::npos);
  EXPECT_NE(complaintOf("just words\n").find("\"name: value\""), std::string::npos);
  EXPECT_NE(complaintOf("trials: 2\n---\nseed: 1\n").find(":2: a second document"), std::string::npos);
  // yaml-cpp reads endlessly many documents in this.
  EXPECT_NE(complaintOf(", trials: 2\n").find(":1: malformed YAML: a document cannot begin like this"),
            std::string::npos);
}

TEST_F(YamlFile, UnreadableOnesAreNamed)
{
  EXPECT_EQ(complaint([this] { loadParameters(parameters_, "/nonexistent/file.yaml"); }),
            "/nonexistent/file.yaml: it cannot be read: No such file or directory");
  EXPECT_NE(complaint([this] { loadParameters(parameters_, folder_); }).find("it is a folder"), std::string::npos);
}

TEST_F(YamlFile, HugeOnesAreRefusedUnread)
{
  const std::string comment = "trials: 2 #" + std::string(size_t{ 1 } << 20, '.');
  EXPECT_EQ(complaintOf(comment), name_ + ": it has more than 1048576 bytes; a file of parameters needs far less");
  EXPECT_EQ(complaintOf(comment.substr(0, size_t{ 1 } << 20)), "");
  EXPECT_NE(complaint([this] { loadParameters(parameters_, "/dev/zero"); }).find("more than"), std::string::npos);
}

TEST_F(YamlFile, ComplaintsStayShortAndCyclesEnd)
{
  const std::string long_text(100000, 'x');
  EXPECT_LT(complaintOf("trials: " + long_text).size(), 300u);
  EXPECT_LT(complaintOf("? " + long_text + "\n: 1\n").size(), 300u);
  EXPECT_LT(complaintOf("grid: " + std::string(100000, '[')).size(), 300u);
  EXPECT_NE(complaintOf("grid: &cycle [*cycle, *cycle, *cycle]\n"), "");
}

TEST(Parameters, TheFileOfTheRigidBodyHasAllOfItsParametersAtTheirDefaults)
{
  const std::string path = PROJECT_DIR "/config/rigid.yaml";
  const std::string content = contentOf(path);
  Parameters parameters;
  loadParameters(parameters, path);
  EXPECT_EQ(parameters.experiment.body.kind, BodyKind::RIGID);
  for (const ParameterSpec& spec : parameterSpecs())
  {
    if (spec.body == BodyKind::RIGID)
    {
      EXPECT_EQ(spec.get(parameters), spec.default_text) << spec.name;
      EXPECT_NE(content.find("\n" + spec.name + ": "), std::string::npos) << spec.name;
    }
  }
}

TEST(Documentation, TheConfigurationFileListsEveryParameterAtItsDefault)
{
  const std::string path = PROJECT_DIR "/config/experiment.yaml";
  EXPECT_EQ(contentOf(path), parametersAsYaml()) << "run: devo_evo parameters --yaml > config/experiment.yaml";

  const Parameters defaults;
  Parameters loaded;
  loadParameters(loaded, path);
  for (const ParameterSpec& spec : parameterSpecs())
  {
    EXPECT_NE(contentOf(path).find("\n" + spec.name + ": "), std::string::npos) << spec.name;
    EXPECT_EQ(spec.get(loaded), spec.get(defaults)) << spec.name;
  }
}

TEST(Documentation, ThePageOnParametersIsUpToDate)
{
  EXPECT_EQ(contentOf(PROJECT_DIR "/docs/parameters.md"), parametersAsMarkdown())
      << "run: devo_evo parameters --markdown > docs/parameters.md";
}

TEST(ExperimentSettingsValidation, WantsAnAbsoluteOutput)
{
  ExperimentSettings settings;
  settings.output = "/tmp/x";
  EXPECT_NO_THROW(settings.validate());
  for (const std::string output : { "", "x", "./x", "~/x" })
  {
    settings.output = output;
    EXPECT_EQ(complaint([&] { settings.validate(); }), "output is \"" + output + "\"; it must be an absolute path");
  }
}

TEST(ExperimentSettingsValidation, ChecksRanges)
{
  ExperimentSettings settings;
  settings.output = "/tmp/x";
  settings.trials = 0;
  EXPECT_EQ(complaint([&] { settings.validate(); }), "trials is 0; it must lie within 1 to 10000");
}

TEST(DefaultOutput, TellsArmsAndSeedsApart)
{
  ExperimentSettings settings;
  const std::string home = std::getenv("HOME") ? std::getenv("HOME") : "";
  setenv("HOME", "/home/somebody", 1);
  EXPECT_EQ(defaultOutput(settings), "/home/somebody/devo_evo/evo_devo-paper-self_adaptive-seed-1");
  settings.evolution.mutation_rate = 0.5;
  settings.evolution.treatment = Treatment::EVO;
  settings.evolution.seed = 42;
  EXPECT_EQ(defaultOutput(settings), "/home/somebody/devo_evo/evo-paper-0.5-seed-42");
  unsetenv("HOME");
  EXPECT_NE(complaint([&] { defaultOutput(settings); }).find("HOME"), std::string::npos);
  setenv("HOME", home.c_str(), 1);
}
}  // namespace
}  // namespace devo_evo
