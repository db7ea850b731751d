#include "archive/founder_table.h"

#include "archive/genome_table.h"
#include "archive/schema.h"

namespace devo_evo
{
void writeFounders(Connection& connection, const EvolutionSettings& settings, const GenomeLayout& layout)
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
        .query("INSERT OR REPLACE INTO founders (id, " + genomeColumns(layout) + ") VALUES (?, ?, ?, ?, ?, ?)", id++,
               blobs.morphology_initial, blobs.morphology_final, blobs.control_initial, blobs.control_final,
               blobs.mutation_rate)
        .run();
  }
}

std::shared_ptr<const std::vector<Genome>> readFounders(Connection& connection, const GenomeLayout& layout)
{
  auto founders = std::make_shared<std::vector<Genome>>();
  if (hasTable(connection, "founders"))
  {
    Query query = connection.query("SELECT id, " + genomeColumns(layout) + " FROM founders ORDER BY id");
    while (query.next())
    {
      if (query.natural() != static_cast<int64_t>(founders->size()))
      {
        throw DamagedArchive("founder " + std::to_string(founders->size()) + " is missing");
      }
      founders->push_back(readGenome(query, layout));
    }
  }
  return founders->empty() ? nullptr : founders;
}
}  // namespace devo_evo
