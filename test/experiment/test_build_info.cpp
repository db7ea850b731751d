#include "devo_evo/experiment/build_info.h"
#include "devo_evo/bodies/bodies.h"

#include "devo_evo/soft_body/simulation.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace devo_evo
{
namespace
{
TEST(BuildInfo, VersionIsThatOfThePackage)
{
  std::ifstream file(PROJECT_DIR "/package.xml");
  std::stringstream manifest;
  manifest << file.rdbuf();
  EXPECT_NE(manifest.str().find("<version>" + buildInfo().version + "</version>"), std::string::npos)
      << "built from version " << buildInfo().version;
}

TEST(BuildInfo, CommitIsAbbreviatedAndNamesChangedSources)
{
  std::string commit = buildInfo().commit;
  const size_t dirty = commit.find("-dirty");
  if (dirty != std::string::npos)
  {
    EXPECT_EQ(dirty + 6, commit.size());
    commit.resize(dirty);
  }
  EXPECT_EQ(commit.find_first_not_of("0123456789abcdef"), std::string::npos) << commit;
}

TEST(BuildInfo, VersionTextNamesVersionAndCommit)
{
  EXPECT_EQ(versionText().rfind(buildInfo().version, 0), 0U);
  EXPECT_NE(versionText().find(buildInfo().commit), std::string::npos);
}

TEST(BuildInfo, ProvenanceSaysWhereAndWithWhat)
{
  const Provenance provenance = localProvenance("scalar", *makeSoftBody(SoftBodySettings()));
  EXPECT_EQ(provenance.version, versionText());
  EXPECT_NE(provenance.compiler.find("-O"), std::string::npos) << provenance.compiler;
  EXPECT_FALSE(provenance.processor.empty());
  EXPECT_EQ(provenance.instruction_set, "scalar");
  EXPECT_FALSE(provenance.host.empty());
  EXPECT_EQ(provenance.engine_fingerprint, engineFingerprint(InstructionSet::SCALAR));
}
}  // namespace
}  // namespace devo_evo
