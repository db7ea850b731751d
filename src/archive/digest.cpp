#include "archive/digest.h"

#include "archive/bytes.h"
#include "archive/generation_table.h"
#include "soft_body/sha256.h"

namespace devo_evo
{
namespace
{
/// An individual as the digest sees it.
struct Newcomer
{
  int64_t id, parent, generation, age;
  Hash128 genome_hash;
  bool valid;
  double fitness;
  uint64_t state_hash;
};

/// Reads a trial's individuals by id, which is also by generation.
class Newcomers
{
public:
  Newcomers(Connection& connection, int64_t trial)
    : query_(connection.query("SELECT id, parent, generation, age, genome_hash, valid, fitness, state_hash "
                              "FROM individuals WHERE trial = ? ORDER BY id",
                              trial))
  {
    advance();
  }

  std::vector<Newcomer> bornIn(int64_t generation)
  {
    std::vector<Newcomer> newcomers;
    while (present_ && present_->generation == generation)
    {
      newcomers.push_back(*present_);
      advance();
    }
    return newcomers;
  }

private:
  void advance()
  {
    if (!query_.next())
    {
      present_.reset();
      return;
    }
    Newcomer newcomer;
    newcomer.id = query_.natural();
    newcomer.parent = query_.optionalNatural().value_or(Individual::NO_PARENT);
    newcomer.generation = query_.natural();
    newcomer.age = query_.natural();
    newcomer.genome_hash = query_.hash();
    newcomer.valid = query_.natural() != 0;
    newcomer.fitness = query_.optionalReal().value_or(0.0);
    const auto state_hash = query_.optionalBlob(sizeof(uint64_t));
    newcomer.state_hash = state_hash ? hashFromBytes(*state_hash) : 0;
    present_ = newcomer;
  }

  Query query_;
  std::optional<Newcomer> present_;
};

void add(Sha256& sha, const Newcomer& newcomer)
{
  const uint8_t valid = newcomer.valid ? 1 : 0;
  sha.add(newcomer.id).add(newcomer.parent).add(newcomer.age);
  sha.add(newcomer.genome_hash.data(), newcomer.genome_hash.size());
  sha.add(&valid, 1).add(newcomer.fitness).add(newcomer.state_hash);
}

void addTrial(Sha256& sha, Connection& connection, int64_t trial)
{
  Newcomers newcomers(connection, trial);
  Query generations = connection.query("SELECT generation FROM generations WHERE trial = ? ORDER BY generation", trial);
  while (generations.next())
  {
    const int64_t generation = generations.natural();
    const std::vector<Newcomer> born = newcomers.bornIn(generation);
    sha.add(trial).add(generation).add(static_cast<int64_t>(born.size()));
    for (const Newcomer& newcomer : born)
    {
      add(sha, newcomer);
    }
    const std::vector<int64_t> survivors = findSurvivors(connection, trial, generation);
    sha.add(static_cast<int64_t>(survivors.size()));
    for (const int64_t id : survivors)
    {
      sha.add(id);
    }
  }
}

std::string toHexadecimal(const std::array<uint8_t, 32>& hash)
{
  constexpr char DIGITS[] = "0123456789abcdef";
  std::string text;
  for (const uint8_t byte : hash)
  {
    text += { DIGITS[byte >> 4], DIGITS[byte & 15] };
  }
  return text;
}
}  // namespace

std::string computeDigest(Connection& connection)
{
  Sha256 sha;
  sha.add(std::string("devo_evo digest 1\n"));
  for (const int64_t trial : findTrials(connection))
  {
    addTrial(sha, connection, trial);
  }
  return toHexadecimal(sha.finish());
}
}  // namespace devo_evo
