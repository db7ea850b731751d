#include "archive/founder_table.h"

#include "archive/genome_table.h"
#include "archive/schema.h"

namespace devo_evo
{
void writeFounders(Connection& connection, const EvolutionSettings& settings)
{
  if (!settings.founders)
  {
    return;
  }
  int64_t id = 0;
  for (const Genome& founder : *settings.founders)
  {
    const GenomeBlobs blobs(founder);
    connection
        .query(
            "INSERT OR REPLACE INTO founders (id, size_gene_initial, size_gene_final, phase_initial, phase_final, "
            "mutation_rate) VALUES (?, ?, ?, ?, ?, ?)",
            id++, blobs.size_gene_initial, blobs.size_gene_final, blobs.phase_initial, blobs.phase_final,
            blobs.mutation_rate)
        .run();
  }
}

std::shared_ptr<const std::vector<Genome>> readFounders(Connection& connection, int voxel_count)
{
  auto founders = std::make_shared<std::vector<Genome>>();
  if (hasTable(connection, "founders"))
  {
    Query query = connection.query(
        "SELECT id, size_gene_initial, size_gene_final, phase_initial, phase_final, mutation_rate "
        "FROM founders ORDER BY id");
    while (query.next())
    {
      if (query.natural() != static_cast<int64_t>(founders->size()))
      {
        throw DamagedArchive("founder " + std::to_string(founders->size()) + " is missing");
      }
      founders->push_back(readGenome(query, voxel_count));
    }
  }
  return founders->empty() ? nullptr : founders;
}
}  // namespace devo_evo
