#include "cli/short_lives.h"

#include "devo_evo/soft_body/text.h"

#include <algorithm>
#include <map>
#include <sstream>

namespace devo_evo
{
namespace
{
using Json = nlohmann::json;
using Words = std::vector<std::string>;

/// Parent by child, both as ids; "" for those without.
using Tree = std::map<std::string, std::string>;

std::vector<std::string> splitAt(const std::string& text, char separator)
{
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);)
  {
    parts.push_back(part);
  }
  return parts;
}

/// The tree that lines of Newick with labels "trial/id" tell.
Tree readNewick(const std::string& text)
{
  Tree tree;
  for (const std::string& line : splitAt(text, '\n'))
  {
    std::vector<std::vector<std::string>> open(1);  // labels whose parent is not known yet, by depth
    for (size_t place = 0; place < line.size(); ++place)
    {
      const char character = line[place];
      if (character == '(')
      {
        open.emplace_back();
      }
      else if (character != ',' && character != ')' && character != ';')
      {
        const size_t end = line.find_first_of(",);", place);
        const std::string label = line.substr(place, line.find(':', place) - place);
        const std::string id = label.substr(label.find('/') + 1);
        tree[id] = "";
        if (place > 0 && line[place - 1] == ')')
        {
          for (const std::string& child : open.back())
          {
            tree[child] = id;
          }
          open.pop_back();
        }
        open.back().push_back(id);
        place = end - 1;
      }
    }
  }
  return tree;
}

/// The tree of a table with a column of ids and one of parents.
Tree readTable(const std::string& text, size_t id, size_t parent)
{
  Tree tree;
  const auto lines = splitAt(text, '\n');
  for (size_t i = 1; i < lines.size(); ++i)
  {
    const auto fields = splitAt(lines[i], ',');
    tree[fields.at(id)] = fields.at(parent);
  }
  return tree;
}

class ExportCommand : public ShortLives
{
protected:
  ToolResult exported(const Words& options) const
  {
    Words words = { "export", output_ };
    words.insert(words.end(), options.begin(), options.end());
    return runTool(words);
  }

  std::string textOf(const Words& options) const
  {
    const ToolResult result = exported(options);
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.err, "");
    return result.out;
  }

  std::string stateHashOf(const std::string& name) const
  {
    const auto parts = splitAt(name, '/');
    return textIn(output_, "SELECT lower(hex(state_hash)) FROM individuals WHERE trial = " + parts.at(0) +
                               " AND id = " + parts.at(1));
  }

  /// The state hashes of the robots of a file, by their names.
  std::map<std::string, std::string> livesOf(const std::string& file, const std::string& parameters) const
  {
    const ToolResult result = runTool({ "evaluate", file, "--config", parameters });
    EXPECT_EQ(result.status, 0) << result.err;
    std::map<std::string, std::string> hashes;
    for (const std::string& line : splitAt(result.out, '\n'))
    {
      const Json evaluation = Json::parse(line);
      hashes[evaluation.at("id")] = evaluation.at("state_hash");
    }
    return hashes;
  }

  /// Somebody of a branch that died out, whose genome is not stored.
  std::string someoneDead() const
  {
    return "1/" + textIn(output_,
                         "SELECT max(id) FROM individuals WHERE trial = 1 AND parent IS NOT NULL AND id NOT "
                         "IN (SELECT id FROM genomes WHERE trial = 1)");
  }

  std::string champion() const
  {
    return "2/" + textIn(output_, "SELECT id FROM champions WHERE trial = 2 ORDER BY generation DESC LIMIT 1");
  }

  const std::string parameters_ = folder_.file("parameters.yaml");
};

TEST_F(ExportCommand, RobotsComeBackFromJsonAndVxaToTheSameLife)
{
  for (const std::string& name : { champion(), someoneDead() })
  {
    for (const std::string format : { "json", "vxa" })
    {
      const std::string file = folder_.file("robot." + format), back = folder_.file("back.jsonl");
      textOf({ "--individual", name, "--format", format, "--out", file, "--parameters", parameters_ });
      const ToolResult import = runTool({ "import", file, "--out", back, "--config", parameters_ });
      ASSERT_EQ(import.status, 0) << import.err;
      const std::map<std::string, std::string> expected = { { name, stateHashOf(name) } };
      EXPECT_EQ(livesOf(back, parameters_), expected) << format;
      EXPECT_EQ(contentOf(back), textOf({ "--individual", name })) << format;
    }
  }
}

TEST_F(ExportCommand, AVxaFileBringsItsParametersAlong)
{
  const std::string file = folder_.file("robot.vxa"), back = folder_.file("back.jsonl");
  textOf({ "--individual", "2", "--format", "vxa", "--out", file });
  const ToolResult refused = runTool({ "import", file, "--out", back });
  EXPECT_EQ(refused.status, 2);
  EXPECT_TRUE(contains(refused.err, "grid is 2x2x1 in " + file + " and 4x4x3 in ours, "));
  EXPECT_TRUE(contains(refused.err, "lifetime is 0.1 in " + file + " and 10 in ours; give --parameters FILE"));
  EXPECT_FALSE(std::filesystem::exists(back));

  EXPECT_EQ(runTool({ "import", file, "--out", back, "--parameters", parameters_ }).status, 0);
  EXPECT_EQ(livesOf(back, parameters_).at(champion()), stateHashOf(champion()));
  EXPECT_EQ(runTool({ "import", file, "--grid", "2x2x1", "--lifetime", "0.1" }).out, contentOf(back));
}

TEST_F(ExportCommand, AWholeLineageComesBackToTheSameLives)
{
  const std::string file = folder_.file("lineage.jsonl");
  textOf({ "--lineage", champion(), "--format", "json", "--out", file, "--parameters", parameters_ });
  const auto lives = livesOf(file, parameters_);
  EXPECT_EQ(lives.size(), readTable(textOf({ "--lineage", "2" }), 1, 2).size());
  EXPECT_EQ(lives.count(champion()), 1u);
  for (const auto& [name, state_hash] : lives)
  {
    EXPECT_EQ(state_hash, stateHashOf(name)) << name;
  }
}

TEST_F(ExportCommand, EveryFormatTellsTheTreeOfTheArchive)
{
  Tree archived;
  for (const std::string& each :
       splitAt(textIn(output_, "SELECT group_concat(id || ' ' || ifnull(parent, '')) FROM individuals WHERE trial = 1"),
               ','))
  {
    archived[each.substr(0, each.find(' '))] = each.substr(each.find(' ') + 1);
  }
  ASSERT_EQ(archived.size(), 29u);
  EXPECT_EQ(readNewick(textOf({ "--phylogeny", "1", "--format", "newick" })), archived);
  EXPECT_EQ(readTable(textOf({ "--phylogeny", "1" }), 1, 2), archived);
  Tree listed;
  for (const auto& [id, ancestors] : readTable(textOf({ "--phylogeny", "1", "--format", "alife" }), 0, 1))
  {
    ASSERT_EQ(ancestors.front(), '[');
    ASSERT_EQ(ancestors.back(), ']');
    const std::string ancestor = ancestors.substr(1, ancestors.size() - 2);
    listed[id] = ancestor == "none" ? "" : ancestor;
  }
  EXPECT_EQ(listed, archived);
}

TEST_F(ExportCommand, ALineageIsAChainInEveryFormat)
{
  for (const std::string format : { "csv", "newick", "alife" })
  {
    const std::string text = textOf({ "--lineage", "1", "--format", format });
    const bool newick = format == "newick";
    const auto lines = splitAt(text, '\n');
    const size_t robots = newick ? readNewick(text).size() : lines.size() - 1;
    EXPECT_EQ(robots, splitAt(textOf({ "--lineage", "1", "--format", "json" }), '\n').size());
    EXPECT_EQ(newick ? lines.size() : 1u, 1u);
  }
}

TEST_F(ExportCommand, TracesTellALifeFromTheStartToTheEnd)
{
  const auto moments = splitAt(textOf({ "--individual", "1", "--format", "trace", "--interval", "0.25" }), '\n');
  ASSERT_EQ(moments.size(), 1u + 4u);  // 0, 0.25, 0.5 and 0.6 s
  EXPECT_EQ(moments[0], "time_s,since_birth_s,x_m,y_m,z_m,q_w,q_x,q_y,q_z");
  EXPECT_EQ(moments[1].rfind("0,-0.5,0.01,0.01,0.005,1,0,0,0", 0), 0u) << moments[1];
  const auto voxels = splitAt(textOf({ "--individual", "1", "--format", "voxels", "--interval", "0.25" }), '\n');
  ASSERT_EQ(voxels.size(), 1u + 4u * 4u);
  EXPECT_EQ(splitAt(voxels[0], ',').size(), splitAt(voxels[5], ',').size());
}

TEST_F(ExportCommand, WritesNoLifeThatIsNotTheArchives)
{
  edit(output_, "UPDATE individuals SET state_hash = x'0123456789abcdef' WHERE trial = 1 AND id = 5");
  const ToolResult result = exported({ "--individual", "1/5", "--format", "trace" });
  EXPECT_EQ(result.status, 1);
  EXPECT_TRUE(contains(result.err, "the life of 1/5 ends in another state than the archive says"));
}

TEST_F(ExportCommand, RefusesWhatItCannotExport)
{
  const std::vector<std::pair<Words, std::string>> wrong = {
    { {}, "nothing is named to export" },
    { { "--individual", "1", "--format", "newick" }, "with --individual it must be one of json, vxa, trace, voxels" },
    { { "--phylogeny", "1", "--format", "json" }, "with --phylogeny it must be one of csv, newick, alife" },
    { { "--individual", "1", "--lineage", "1" }, "--lineage" },
    { { "--individual", "1/" }, "\"1/\" names no individual" },
    { { "--individual", "1/-3" }, "\"1/-3\" names no individual" },
    { { "--individual", "1/3x" }, "\"1/3x\" names no individual" },
    { { "--individual", "best" }, "\"best\" names no individual" },
    { { "--individual", "1/9999" }, "1/9999" },
    { { "--individual", "3" }, "trial 3" },
    { { "--lineage", "0/1" }, "0/1" },
    { { "--phylogeny", "3" }, "trial 3" },
    { { "--individual", "1", "--format", "trace", "--interval", "0" }, "the interval of a trace is 0 s" },
    { { "--individual", "1", "--format", "trace", "--interval", "nan" }, "interval" },
    { { "--individual", "1", "--out", archivePath(output_) }, "is read or written by this command already" },
    { { "--parameters", archivePath(output_) }, "is read or written by this command already" },
  };
  for (const auto& [options, words] : wrong)
  {
    const ToolResult result = exported(options);
    EXPECT_EQ(result.status, 2) << ::testing::PrintToString(options);
    EXPECT_TRUE(contains(result.err, words));
    EXPECT_EQ(result.out, "");
  }
  EXPECT_TRUE(contentOf(archivePath(output_)) == original);
}

TEST_F(ExportCommand, FailsWhereItCannotReadOrWrite)
{
  EXPECT_EQ(runTool({ "export", folder_.file("nothing"), "--individual", "1" }).status, 1);
  const ToolResult nowhere = exported({ "--individual", "1", "--out", folder_.file("no/such/folder") });
  EXPECT_EQ(nowhere.status, 1);
  EXPECT_TRUE(contains(nowhere.err, folder_.file("no/such/folder") + " cannot be opened"));
  const ToolResult full = exported({ "--individual", "1", "--out", "/dev/full" });
  EXPECT_EQ(full.status, 1);
  EXPECT_TRUE(contains(full.err, "/dev/full cannot be written"));
}
}  // namespace
}  // namespace devo_evo
