#include "cli/tool_process.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace devo_evo
{
namespace
{
const char* const GENOMES = TEST_DATA_DIR "/genomes.jsonl";

/// Without display, as on a server.
const ToolProcess::Environment NO_DISPLAY = { { "DISPLAY", "" }, { "XAUTHORITY", "" } };

ToolResult run(const std::vector<std::string>& arguments)
{
  return runTool(arguments, "", NO_DISPLAY);
}

/// A folder with a short experiment in it.
class ExperimentFolder
{
public:
  explicit ExperimentFolder(const std::string& treatment)
  {
    status_ = run({ "evolve", "--treatment", treatment, "--population", "4", "--generations", "3", "--lifetime", "0.2",
                    "--output", path() })
                  .status;
  }

  std::string path() const { return folder_.file("run"); }
  std::string file(const std::string& name) const { return folder_.file(name); }
  bool made() const { return status_ == 0; }

private:
  TemporaryFolder folder_;
  int status_ = 1;
};

bool isPng(const std::string& path)
{
  return contentOf(path).rfind("\x89PNG", 0) == 0;
}

TEST(ToolRender, DrawsARobotOfAFileWithoutADisplay)
{
  const TemporaryFolder folder;
  const std::string path = folder.file("robot.png");
  const ToolResult result =
      run({ "render", GENOMES, "--individual", "golden-000", "--lifetime", "0.2", "--time", "0.1", "--out", path });
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_TRUE(isPng(path));
}

TEST(ToolRender, MakesStripsRowsAndFilmsOfAnExperiment)
{
  const ExperimentFolder experiment("evo_devo"), other("evo");
  ASSERT_TRUE(experiment.made() && other.made());
  const std::vector<std::string> small = { "--width", "320", "--height", "180" };
  const auto render = [&](std::vector<std::string> arguments)
  {
    arguments.insert(arguments.end(), small.begin(), small.end());
    return run(arguments);
  };
  EXPECT_EQ(render({ "render", experiment.path(), "--strip", "--out", experiment.file("s.png") }).status, 0);
  EXPECT_EQ(render({ "render", experiment.path(), "--gaits", "--out", experiment.file("g.png") }).status, 0);
  EXPECT_EQ(render({ "render", experiment.path(), "--out", experiment.file("pictures/") }).status, 0);
  EXPECT_EQ(render({ "render", experiment.path(), "--lineage", "--out", experiment.file("l.mp4") }).status, 0);
  EXPECT_EQ(render({ "render", experiment.path(), "--beside", other.path(), "--out", experiment.file("b.gif") }).status,
            0);
  const ToolResult overview = render({ "overview", experiment.path(), "--out", experiment.file("o.mp4") });
  EXPECT_EQ(overview.status, 0) << overview.err;
  EXPECT_NE(overview.err.find("picture"), std::string::npos) << "it says how far it is";
  EXPECT_TRUE(isPng(experiment.file("s.png")) && isPng(experiment.file("g.png")));
  EXPECT_TRUE(isPng(experiment.file("pictures/00000.png")) && isPng(experiment.file("pictures/00005.png")));
  for (const char* film : { "l.mp4", "b.gif", "o.mp4" })
  {
    EXPECT_GT(std::filesystem::file_size(experiment.file(film)), 1000u) << film;
  }
}

TEST(ToolRender, SaysWhatIsWrongWithItsInput)
{
  const ExperimentFolder experiment("evo");
  ASSERT_TRUE(experiment.made());
  const std::string png = experiment.file("x.png"), film = experiment.file("x.mp4");
  struct Case
  {
    std::vector<std::string> arguments;
    int status;
    const char* message;
  };
  const std::vector<Case> cases = {
    { { "render", experiment.path(), "--individual", "1/99999", "--out", png }, 2, "99999" },
    { { "render", experiment.path(), "--individual", "7", "--out", png }, 2, "no valid champion" },
    { { "render", experiment.path(), "--individual", "x/y", "--out", png }, 2, "x/y" },
    { { "render", experiment.path(), "--out", "picture.avi" }, 2, ".png" },
    { { "render", experiment.path(), "--out", "/nowhere/x.mp4" }, 1, "/nowhere" },
    { { "render", experiment.path(), "--time", "5", "--out", png }, 2, "0 to 0.2" },
    { { "render", experiment.path(), "--colour", "pink", "--out", png }, 2, "pink" },
    { { "render", experiment.path(), "--strip", "--poses", "1", "--out", png }, 2, "poses" },
    { { "render", experiment.path(), "--lineage", "--count", "1", "--out", film }, 2, "count" },
    { { "render", "/nowhere", "--out", png }, 2, "/nowhere" },
    { { "render", GENOMES, "--individual", "nobody", "--out", png }, 2, "nobody" },
    { { "render", GENOMES, "--lineage", "--out", film }, 2, "output folder" },
    { { "overview", "/nowhere", "--out", film }, 2, "/nowhere" },
    { { "overview", experiment.path(), "--count", "1", "--out", film }, 2, "count" },
  };
  for (const Case& wrong : cases)
  {
    const ToolResult result = run(wrong.arguments);
    EXPECT_EQ(result.status, wrong.status) << result.err;
    EXPECT_NE(result.err.find(wrong.message), std::string::npos) << result.err;
  }
  EXPECT_FALSE(std::filesystem::exists(png) || std::filesystem::exists(film));
}

TEST(ToolRender, NeedsNoFfmpegForPictures)
{
  const TemporaryFolder folder;
  const ToolProcess::Environment no_path = { { "PATH", "/nowhere" }, { "DISPLAY", "" } };
  const std::vector<std::string> robot = { "render", GENOMES, "--lifetime", "0.1", "--width", "320", "--out" };
  const auto with = [&](const std::string& out)
  {
    std::vector<std::string> arguments = robot;
    arguments.push_back(folder.file(out));
    return runTool(arguments, "", no_path);
  };
  EXPECT_EQ(with("robot.png").status, 0);
  EXPECT_EQ(with("frames/").status, 0);
  const ToolResult film = with("film.mp4");
  EXPECT_EQ(film.status, 1);
  EXPECT_NE(film.err.find("ffmpeg"), std::string::npos) << film.err;
}
}  // namespace
}  // namespace devo_evo
