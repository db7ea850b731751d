// Numbers are read and written the same under every locale: here under one that writes 0.5 as 0,5 and 1000 as 1.000.

#include "devo_evo/experiment/json_lines.h"
#include "devo_evo/bodies/bodies.h"
#include "devo_evo/experiment/parameters.h"
#include "devo_evo/experiment/report_text.h"

#include <gtest/gtest.h>

#include <array>
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <locale>
#include <sstream>

namespace devo_evo
{
namespace
{
/// What a C++ program would use that asks for a German locale.
class GermanPunctuation : public std::numpunct<char>
{
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

/// Makes the C++ locale German, and the C locale too where one can be had.
class GermanLocale : public ::testing::Test
{
protected:
  GermanLocale()
  {
    std::string pattern = std::filesystem::temp_directory_path().string() + "/devo_evo_XXXXXX";
    folder_ = mkdtemp(pattern.data());
    std::ofstream(folder_ + "/source") << "LC_NUMERIC\ndecimal_point \",\"\nthousands_sep \".\"\ngrouping 3;3\n"
                                          "END LC_NUMERIC\n";
    const std::string command =
        "localedef -c -i " + folder_ + "/source -f UTF-8 " + folder_ + "/de_DE.UTF-8 >/dev/null 2>&1";
    EXPECT_NE(std::system(command.c_str()), -1);  // it warns of all that a locale could define besides
    setenv("LOCPATH", folder_.c_str(), 1);
    std::setlocale(LC_NUMERIC, "de_DE.UTF-8");
    std::locale::global(std::locale(std::locale(), new GermanPunctuation));
  }

  ~GermanLocale() override
  {
    std::locale::global(std::locale::classic());
    std::setlocale(LC_NUMERIC, "C");
    unsetenv("LOCPATH");
    std::filesystem::remove_all(folder_);
  }

  std::string folder_;
};

TEST_F(GermanLocale, IsInForce)
{
  std::ostringstream stream;
  stream << 1234.5;
  EXPECT_EQ(stream.str(), "1.234,5");
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "%.1f", 0.5);
  if (std::string(text.data()) != "0,5")
  {
    GTEST_SKIP() << "this machine cannot make a C locale (package locales); the C++ locale alone is German";
  }
}

TEST_F(GermanLocale, DoesNotChangeParameters)
{
  std::ofstream(folder_ + "/p.yaml") << "lifetime: 2.5\ngenerations: 12345\n";
  Parameters parameters;
  loadParameters(parameters, folder_ + "/p.yaml");
  setParameter(parameters, "gravity", std::string("1.625"), "test");
  EXPECT_EQ(parameterSpec("lifetime").get(parameters), "2.5");
  EXPECT_EQ(parameterSpec("generations").get(parameters), "12345");
  EXPECT_EQ(parameterSpec("gravity").get(parameters), "1.625");
  EXPECT_THROW(setParameter(parameters, "gravity", std::string("1,625"), "test"), InvalidInput);
}

TEST_F(GermanLocale, DoesNotChangeJsonLines)
{
  SoftBodySettings settings;
  settings.grid_x = settings.grid_y = settings.grid_z = 1;
  std::istringstream input(R"({"id": 12345, "size_gene_initial": [0.5], "phase_initial_cycles": [-0.125]})");
  const auto robot = RobotReader(input, "input", *makeSoftBody(settings)).next();
  ASSERT_TRUE(robot.has_value());
  EXPECT_EQ(robot->genome.program.morphology_initial.front(), 0.5);
  EXPECT_EQ(robot->genome.program.control_initial.front(), -0.125);

  Evaluation evaluation;
  evaluation.valid = true;
  evaluation.fitness = 1234.5;
  const std::string json = evaluationToJson(robot->id, evaluation, *makeSoftBody(settings));
  EXPECT_NE(json.find("\"id\":12345,"), std::string::npos) << json;
  EXPECT_NE(json.find("\"fitness\":1234.5,"), std::string::npos) << json;
}

TEST_F(GermanLocale, DoesNotChangeWhatPeopleRead)
{
  EXPECT_EQ(fixedText(1234.5, 1), "1234.5");
  ExperimentSettings settings;
  settings.evolution.mutation_rate = 0.5;
  EXPECT_EQ(settings.evolution.arm(), "evo_devo/paper/0.5");
}
}  // namespace
}  // namespace devo_evo
