#include "devo_evo/experiment/scale.h"

#include "devo_evo/soft_body/text.h"

#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <sstream>

using namespace devo_evo;

TEST(Scales, areWhatTheDocumentationSays)
{
  std::ostringstream page;
  page << std::ifstream(PROJECT_DIR "/docs/study.md").rdbuf();
  std::istringstream lines(page.str());
  const std::vector<Scale> scales = { Scale::QUICK, Scale::OVERNIGHT, Scale::PAPER };
  int compared = 0;
  for (std::string line; std::getline(lines, line);)
  {
    std::smatch row;
    if (!std::regex_match(line, row, std::regex(R"(\| `(\w+)` \| (\S+)(?: s)? \| (\S+)(?: s)? \| (\S+)(?: s)? \|)")))
    {
      continue;
    }
    for (size_t i = 0; i < scales.size(); ++i)
    {
      EXPECT_EQ(parameterSpec(row[1]).get(parametersAtScale(scales[i])), row[i + 2]) << line;
      ++compared;
    }
  }
  EXPECT_GE(compared, 3 * 12);
}

TEST(Scales, changeNoPhysicsAndNoOperator)
{
  for (const Scale scale : { Scale::QUICK, Scale::OVERNIGHT, Scale::PAPER })
  {
    const Parameters parameters = parametersAtScale(scale);
    EXPECT_EQ(parameters.study.scale, scale);
    for (const ParameterSpec& spec : parameterSpecs())
    {
      if (spec.group == "physics" || (spec.group == "evolution" && spec.name != "population"))
      {
        EXPECT_EQ(spec.get(parameters), spec.default_text) << spec.name;
      }
    }
  }
}

TEST(StudyParts, areReadByNameAndRunInTheirOrder)
{
  EXPECT_EQ(toString(parseStudyParts("sweep,main,walks,main")), "main,walks,sweep");
  EXPECT_TRUE(parseStudyParts("").empty());
  EXPECT_THROW(parseStudyParts("main,"), InvalidInput);
  EXPECT_THROW(parseStudyParts("dance"), InvalidInput);
  EXPECT_EQ(toString(partsOf(StudySettings())),
            "main,removed,walks,lineages,traces,robustness,impact,baselines,sweep,"
            "rigid");
}

TEST(Lists, areReadHoweverTheyAreWritten)
{
  const auto slopes = [](const ParameterValue& value)
  {
    Parameters parameters;
    setParameter(parameters, "slopes", value, "test");
    return parameterSpec("slopes").get(parameters);
  };
  EXPECT_EQ(slopes(std::string("-0.1, 0.25")), "-0.1,0.25");
  EXPECT_EQ(slopes(std::string("[1, 2]")), "1,2");
  EXPECT_EQ(slopes(std::string("")), "");
  EXPECT_EQ(slopes(0.5), "0.5");
  EXPECT_EQ(slopes(std::vector<int64_t>{ 1, 2 }), "1,2");
  for (const std::string wrong : { "1;2", "nan", "11", "1,,2", "0x10" })
  {
    EXPECT_THROW(slopes(wrong), InvalidInput) << wrong;
  }
  Parameters parameters;
  EXPECT_THROW(setParameter(parameters, "sweep_48ths", std::string("1.5"), "test"), InvalidInput);
}
