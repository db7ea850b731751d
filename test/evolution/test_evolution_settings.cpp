#include "devo_evo/evolution/settings.h"

#include "devo_evo/evolution/individual.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace devo_evo;

namespace
{
std::string complaint(const EvolutionSettings& settings)
{
  try
  {
    settings.validate();
  }
  catch (const InvalidInput& error)
  {
    return error.what();
  }
  return "";
}
}  // namespace

TEST(EvolutionSettings, namesAreReadBack)
{
  for (const TreatmentSpec& spec : TREATMENTS)
  {
    EXPECT_EQ(spec.treatment, parseTreatment(toString(spec.treatment)));
    EXPECT_EQ(spec.name, toString(spec.treatment));
  }
  EXPECT_EQ("evo, evo_devo, evo_devo_body or evo_devo_control", treatmentNames());
  for (const Selection selection : { Selection::AFPO, Selection::NEUTRAL, Selection::RANDOM_SEARCH })
  {
    EXPECT_EQ(selection, parseSelection(toString(selection)));
  }
  for (const Profile profile : { Profile::PAPER, Profile::RELEASED_CODE })
  {
    EXPECT_EQ(profile, parseProfile(toString(profile)));
  }
}

TEST(EvolutionSettings, unknownNamesAreRefused)
{
  EXPECT_THROW(parseTreatment("Evo"), InvalidInput);
  EXPECT_THROW(parseTreatment(""), InvalidInput);
  EXPECT_THROW(parseProfile("code"), InvalidInput);
  EXPECT_THROW(parseSelection("none"), InvalidInput);
}

TEST(EvolutionSettings, phasesMayTakeAQuarterCycleInThePaperAndAWholeOneInTheReleasedCode)
{
  EvolutionSettings settings;
  EXPECT_EQ(0.25, settings.phaseLimit());
  settings.profile = Profile::RELEASED_CODE;
  EXPECT_EQ(1.0, settings.phaseLimit());
}

TEST(EvolutionSettings, theArmNamesTreatmentProfileAndMutationRate)
{
  EvolutionSettings settings;
  EXPECT_EQ("evo_devo/paper/self_adaptive", settings.arm());
  settings.treatment = Treatment::EVO;
  settings.profile = Profile::RELEASED_CODE;
  settings.mutation_rate = 0.5;
  EXPECT_EQ("evo/released_code/0.5", settings.arm());
  settings.mutation_rate = 1.0 / 48;
  EXPECT_EQ("evo/released_code/0.020833333333333332", settings.arm());
  settings.mutation_rate = -0.0;
  EXPECT_EQ("evo/released_code/0", settings.arm());
}

TEST(EvolutionSettings, defaultsAreValid)
{
  EXPECT_EQ("", complaint(EvolutionSettings()));
}

TEST(EvolutionSettings, complaintsNameFieldValueAndRange)
{
  EvolutionSettings settings;
  settings.population = 1;
  EXPECT_EQ("population is 1; it must lie within 2 to 10000", complaint(settings));

  settings = EvolutionSettings();
  settings.random_injections = -1;
  EXPECT_EQ("random_injections is -1; it must lie within 0 to 1000", complaint(settings));

  settings = EvolutionSettings();
  settings.seed = -7;
  EXPECT_EQ("seed is -7; it must lie within 0 to 9223372036854775807", complaint(settings));

  settings = EvolutionSettings();
  settings.mutation_rate = 1.5;
  EXPECT_EQ("mutation_rate is 1.5; it must be self_adaptive or lie within 0 to 1", complaint(settings));

  settings = EvolutionSettings();
  settings.meta_mutation_sigma = NAN;
  EXPECT_EQ("meta_mutation_sigma is nan; it must lie within 0 to 1", complaint(settings));
}

TEST(Individual, isNamedByTrialAndId)
{
  EXPECT_EQ("3/1042", individualName(3, 1042));
}
