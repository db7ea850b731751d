#include "cli/short_lives.h"

#include "devo_evo/interchange/vxa.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace devo_evo
{
namespace
{
constexpr int DONE = 0, WRONG_INPUT = 2;

class ImportCommand : public ShortLives
{
protected:
  ImportCommand()
  {
    const ToolResult result = runTool({ "export", output_, "--individual", "1/5", "--format", "vxa" });
    EXPECT_EQ(result.status, DONE) << result.err;
    robot_ = result.out;
  }

  ToolResult import(const std::string& content) const
  {
    std::ofstream(file_, std::ios::binary | std::ios::trunc) << content;
    return runTool({ "import", file_, "--out", out_, "--parameters", folder_.file("parameters.yaml") });
  }

  /// Expects content to be refused in these words, in one line, and nothing to be written.
  void expectRefusal(const std::string& content, const std::string& words, const std::string& tag = "") const
  {
    const ToolResult result = import(content);
    EXPECT_EQ(result.status, WRONG_INPUT) << words;
    EXPECT_TRUE(contains(result.err, "devo_evo: error: " + file_ + (tag.empty() ? "" : ", line ")));
    EXPECT_TRUE(contains(result.err, tag));
    EXPECT_TRUE(contains(result.err, words));
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_FALSE(std::filesystem::exists(out_)) << words;
  }

  std::string replaced(const std::string& part, const std::string& by) const
  {
    std::string text = robot_;
    const size_t place = text.find(part);
    EXPECT_NE(place, std::string::npos) << part;
    return place == std::string::npos ? text : text.replace(place, part.size(), by);
  }

  /// Expects the robot's file after a change to be refused with line, tag and words.
  void expectRefusal(const std::string& part, const std::string& by, const std::string& tag,
                     const std::string& words) const
  {
    expectRefusal(replaced(part, by), words, ", <" + tag + ">: ");
  }

  std::string robot_;
  const std::string file_ = folder_.file("robot.vxa");
  const std::string out_ = folder_.file("back.jsonl");
};

TEST_F(ImportCommand, RefusesVxaThatLacksTagsOrRepeatsThem)
{
  expectRefusal("<DtFrac>0.35</DtFrac>", "", "Integration", "<DtFrac> is missing in it");
  expectRefusal("<GravAcc>-9.81</GravAcc>", "", "Gravity", "<GravAcc> is missing in it");
  expectRefusal("<Palette>", "<Palette/><Palette>", "Palette", "it is given twice, first in line ");
  expectRefusal("<PhaseOffset>", "<PhaseOffset/><PhaseOffset>", "PhaseOffset", "it is given twice");
  expectRefusal("<Material ID=\"3\">", "<Material ID=\"9\">", "Palette", "there is no <Material ID=\"3\">");
}

TEST_F(ImportCommand, RefusesVxaWithWrongCountsAndHugeSizes)
{
  expectRefusal("<X_Voxels>2<", "<X_Voxels>3<", "Data", "a layer has 4 voxels");
  expectRefusal("<Z_Voxels>1<", "<Z_Voxels>2<", "Data", "it has 1 layers; <Z_Voxels> asks for 2");
  expectRefusal("[3333]", "[33333]", "Data", "a layer has 5 voxels");
  expectRefusal("<X_Voxels>2<", "<X_Voxels>2147483648<", "X_Voxels", "must lie within 1 to 64");
  expectRefusal("<X_Voxels>2<", "<X_Voxels>-2<", "X_Voxels", "must lie within 1 to 64");
  expectRefusal("<Y_Voxels>2<", "<Y_Voxels>1e300<", "Y_Voxels", "must lie within 1 to 64");
}

TEST_F(ImportCommand, RefusesVxaWithNumbersThatAreNone)
{
  for (const std::string nonsense : { "nan", "inf", "-inf", "1e999", "0x10", "1,5", "", "0.35 0.35", "ten" })
  {
    expectRefusal("<DtFrac>0.35<", "<DtFrac>" + nonsense + "<", "DtFrac", "it must be a finite number");
  }
  expectRefusal("<DtFrac>0.35<", "<DtFrac>0<", "DtFrac", "it must lie within");
  expectRefusal("<Lattice_Dim>0.01<", "<Lattice_Dim>-0.01<", "Lattice_Dim", "must lie within");
  expectRefusal("<TempPeriod>0.25<", "<TempPeriod>0<", "TempPeriod", "must lie within");
  expectRefusal("<DtFrac>0.35<", "<DtFrac><b/>0.35<", "DtFrac", "there is a tag in it");
}

TEST_F(ImportCommand, RefusesByNameWhatIsNotSimulated)
{
  expectRefusal("<FluidDampEnabled>0<", "<FluidDampEnabled>1<", "FluidDampEnabled", "fluid is not simulated here");
  expectRefusal("<NumFixed>0<", "<NumFixed>1<", "NumFixed", "fixed regions (obstacles)");
  expectRefusal("<StickyFloor>0<", "<StickyFloor>1<", "StickyFloor", "a sticky floor is not simulated here");
  expectRefusal("<EquilibriumModeEnabled>0<", "<EquilibriumModeEnabled>1<", "EquilibriumModeEnabled",
                "equilibrium mode");
  expectRefusal("[3333]", "[3353]", "Data", "several materials (obstacles");
  expectRefusal("[3333]", "[5555]", "Data", "which Voxelyze takes for an obstacle");
  expectRefusal("[3333]", "[3303]", "Data", "empty: bodies with missing voxels");
  expectRefusal("\"ASCII_READABLE\"", "\"ZLIB\"", "Structure", "its compression is \"ZLIB\"");
  expectRefusal("<VXC Version", "<Springs/><VXC Version", "Springs", "this is not simulated here");
}

TEST_F(ImportCommand, RefusesHostileXml)
{
  std::string laughs = "<?xml version=\"1.0\"?><!DOCTYPE lolz [<!ENTITY lol \"lol\">";
  for (int i = 1; i < 10; ++i)
  {
    laughs += "<!ENTITY lol" + std::to_string(i) + " \"&lol;&lol;&lol;&lol;&lol;&lol;&lol;&lol;&lol;&lol;\">";
  }
  expectRefusal(laughs + "]><VXA>&lol9;</VXA>", "it has a document type or entities");
  expectRefusal("<!DOCTYPE VXA SYSTEM \"file:///etc/passwd\">" + robot_, "it has a document type or entities");
  expectRefusal(robot_.substr(0, robot_.size() / 2), "malformed XML");
  expectRefusal("<VXA>" + std::string(LARGEST_VXA_FILE, ' ') + "</VXA>", "it has more than 8388608 bytes");
  std::string deep = "<VXA>";
  for (int i = 0; i < 100000; ++i)
  {
    deep += "<a>";
  }
  expectRefusal(deep, "malformed XML");
  expectRefusal("<html><body/></html>", "it is not a VXA file");
  expectRefusal(std::string("<VXA>\0</VXA>", 12), "malformed XML");
}

TEST_F(ImportCommand, RefusesWhatIsNeitherVxaNorJson)
{
  expectRefusal("", "there is no robot in it");
  expectRefusal("\n\n", "there is no robot in it");
  expectRefusal("genome\n", ", line 1, column 1: malformed JSON");
  expectRefusal(std::string("\x89PNG\r\n\x1a\n\0\0", 10), ", line 1, column 1: malformed JSON");
  EXPECT_TRUE(contains(runTool({ "import", folder_.file("nothing") }).err, "No such file"));
  EXPECT_TRUE(contains(runTool({ "import", folder_.file("") }).err, "it is a folder"));
  EXPECT_EQ(runTool({ "import", folder_.file("nothing") }).status, WRONG_INPUT);
  EXPECT_EQ(runTool({ "import", folder_.file("") }).status, WRONG_INPUT);
  EXPECT_EQ(runTool({ "import" }).status, WRONG_INPUT);
}

TEST_F(ImportCommand, RefusesDevicesUnread)
{
  for (const char* const device : { "/dev/zero", "/dev/null" })
  {
    const ToolResult result = runTool({ "import", device });
    EXPECT_EQ(result.status, WRONG_INPUT);
    EXPECT_TRUE(contains(result.err, std::string(device) + ": it is a device"));
  }
}

TEST_F(ImportCommand, ReadsANamedPipe)
{
  const std::string path = folder_.file("pipe");
  ASSERT_EQ(mkfifo(path.c_str(), S_IRUSR | S_IWUSR), 0);
  ToolProcess tool({ "import", path, "--grid", "2x2x1", "--lifetime", "0.1" });
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(30);
  int pipe = -1;
  while (pipe < 0 && std::chrono::steady_clock::now() < deadline)  // until the tool has opened it
  {
    pipe = open(path.c_str(), O_WRONLY | O_NONBLOCK);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  ASSERT_GE(pipe, 0);
  EXPECT_EQ(write(pipe, robot_.data(), robot_.size()), static_cast<ssize_t>(robot_.size()));
  close(pipe);
  EXPECT_EQ(tool.finish(), DONE) << tool.err();
  EXPECT_EQ(tool.out(), runTool({ "export", output_, "--individual", "1/5" }).out);
}

TEST_F(ImportCommand, RefusesToWriteOverAnyOfItsInputs)
{
  const std::string second = folder_.file("second.vxa");
  std::ofstream(file_, std::ios::binary) << robot_;
  std::ofstream(second, std::ios::binary) << robot_;
  for (const std::string& out : { file_, second })
  {
    for (const std::string option : { "--out", "--parameters" })
    {
      const ToolResult result =
          runTool({ "import", file_, second, "--grid", "2x2x1", "--lifetime", "0.1", option, out });
      EXPECT_EQ(result.status, WRONG_INPUT);
      EXPECT_TRUE(contains(result.err, out + " is read or written by this command already"));
      EXPECT_EQ(contentOf(out), robot_);
    }
  }
}

TEST_F(ImportCommand, ReadsStandardInput)
{
  const ToolResult result = runTool({ "import", "-", "--grid", "2x2x1", "--lifetime", "0.1" }, robot_);
  EXPECT_EQ(result.status, DONE) << result.err;
  EXPECT_EQ(result.out, runTool({ "export", output_, "--individual", "1/5" }).out);
}

TEST_F(ImportCommand, TakesSeveralFilesOfTheSameSettingsOnly)
{
  const std::string json = folder_.file("robot.jsonl"), other = folder_.file("other.vxa");
  std::ofstream(file_, std::ios::binary) << robot_;
  ASSERT_EQ(runTool({ "export", output_, "--individual", "1/4", "--out", json }).status, DONE);
  const std::vector<std::string> ours = { "--grid", "2x2x1", "--lifetime", "0.1" };
  std::vector<std::string> words = { "import", json, file_ };
  words.insert(words.end(), ours.begin(), ours.end());
  const ToolResult both = runTool(words);
  EXPECT_EQ(both.status, DONE) << both.err;
  EXPECT_EQ(std::count(both.out.begin(), both.out.end(), '\n'), 2);

  std::ofstream(other, std::ios::binary) << replaced("<GravAcc>-9.81<", "<GravAcc>-9.8<");
  const ToolResult result = runTool({ "import", file_, other });
  EXPECT_EQ(result.status, WRONG_INPUT);
  EXPECT_TRUE(contains(result.err, "gravity is 9.8 in " + other + " and 9.81 in " + file_));
}

/// Founders: from an archive by way of VXA into another experiment, which is checked without the file.
TEST_F(ImportCommand, GivesFoundersThatVerifyNeedsNoFileFor)
{
  ASSERT_EQ(import(robot_).status, DONE);
  const std::string output = folder_.file("from_founder");
  ASSERT_NO_FATAL_FAILURE(evolveShortLives(output, { { "founders", out_ } }));
  std::filesystem::remove(out_);
  EXPECT_EQ(runTool({ "verify", output, "--all" }).status, DONE);
  EXPECT_TRUE(contains(runTool({ "info", output }).out, "\n    founders: 1 given\n"));
  const std::string founder = runTool({ "export", output, "--individual", "2/0", "--format", "vxa" }).out;
  EXPECT_EQ(founder, replaced("<Id>1/5<", "<Id>2/0<"));
}

TEST_F(ImportCommand, FoundersMustFitTheExperiment)
{
  const auto refusal = [this](const std::string& founders, const std::string& grid)
  {
    const std::string path = folder_.file("founders.jsonl");
    std::ofstream(path, std::ios::binary | std::ios::trunc) << founders;
    const ToolResult result = runTool({ "evolve", "--founders", path, "--output", folder_.file("new"), "--grid", grid,
                                        "--population", "2", "--lifetime", "0.1", "--generations", "1" });
    EXPECT_EQ(result.status, WRONG_INPUT) << result.out;
    EXPECT_FALSE(std::filesystem::exists(folder_.file("new")));
    return result.err;
  };
  ASSERT_EQ(import(robot_).status, DONE);
  const std::string robot = contentOf(out_);
  EXPECT_TRUE(contains(refusal(robot, "4x4x3"), "founders.jsonl, line 1"));
  EXPECT_TRUE(contains(refusal(robot + robot + robot, "2x2x1"), "founders"));
  EXPECT_TRUE(contains(refusal("", "2x2x1"), "there is no robot in "));
  EXPECT_TRUE(contains(refusal(robot_, "2x2x1"), "founders.jsonl, line 1"));
}
}  // namespace
}  // namespace devo_evo
