#pragma once

#include "devo_evo/evolution/body.h"
#include "devo_evo/evolution/random.h"
#include "devo_evo/evolution/settings.h"
#include "devo_evo/soft_body/developmental_program.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace devo_evo
{
/// What is inherited: the developmental program and, where they evolve, one mutation rate per number of a part (of soft
/// bodies: per voxel).
struct Genome
{
  DevelopmentalProgram program;
  std::vector<double> mutation_rate;  ///< in the program's order [1, 1/48 to 1]; empty unless self-adaptive

  bool operator==(const Genome& other) const;
};

/// One of the arrays of a developmental program as evolution sees it.
struct TraitSpec
{
  std::string name;                                   ///< as in files, for example "size_gene_initial"
  std::vector<double> DevelopmentalProgram::*values;  ///< where it stands
  double minimum;                                     ///< values lie within minimum to maximum
  double maximum;
  double mutation_sigma;   ///< standard deviation of a mutation
  std::vector<int> image;  ///< as in GenomePart

  bool mirrored() const { return !image.empty(); }
};

/// The traits that evolve, in the order of mutation: the initial and final array of morphology, then those of control;
/// of what does not develop, the initial one alone.
std::vector<TraitSpec> evolvingTraits(const GenomeLayout& layout);

/// A founder or an injected individual: every evolving trait uniform within its limits and mirrored as it must be;
/// mutation rates as the profile says (docs/evolution.md).
Genome randomGenome(const EvolutionSettings& settings, const GenomeLayout& layout, RandomStream& random);

/// What one reproduction did, for tests and analyses.
struct MutationRecord
{
  std::vector<std::string> traits;  ///< names of the traits selected for mutation
};

/// A child: a copy of the parent with mutation rates and then traits mutated (docs/evolution.md; paper, Methods).
/// @param parent valid for the settings.
/// @param layout of the body for these settings.
/// @param record if given, told what was done.
Genome mutate(const Genome& parent, const EvolutionSettings& settings, const GenomeLayout& layout, RandomStream& random,
              MutationRecord* record = nullptr);

/// The same with given traits, some of those that evolve, in place of all: a walk in a part of the space of genomes. By
/// the operator of chosen arrays.
Genome mutateTraits(const Genome& parent, const std::vector<TraitSpec>& traits, const EvolutionSettings& settings,
                    const GenomeLayout& layout, RandomStream& random, MutationRecord* record = nullptr);

/// A copy of the parent in which one voxel of one of the traits, each equally likely, is mutated; of a mirrored trait,
/// one voxel of the half that is copied, and its image. Mutation rates stay as they are.
Genome mutateOneVoxel(const Genome& parent, const std::vector<TraitSpec>& traits, const GenomeLayout& layout,
                      RandomStream& random);

/// The only way in which individuals come to be: a pure function, so that an individual can be had again from its
/// parent or, if it has none, from the settings.
/// @param generation in which it is born.
/// @param parent     its parent's genome; nullptr for a founder or an injected individual.
Genome bornGenome(const EvolutionSettings& settings, const GenomeLayout& layout, int64_t trial, int64_t generation,
                  int64_t id, const Genome* parent);

/// Whether the program has the arrays of this layout, with numbers that can be simulated.
/// @throw InvalidInput naming array, index and value, or the array's size and the size it must have.
void validate(const DevelopmentalProgram& program, const GenomeLayout& layout);

/// Whether the genome fits the body and could evolve under these settings.
/// @throw InvalidInput as for the program alone, also if a number exceeds the limits of evolution or is not mirrored as
///        it must be, final values differ from initial ones without development, or mutation rates are missing, out of
///        range or not to be there.
void validate(const Genome& genome, const EvolutionSettings& settings, const GenomeLayout& layout);

/// 128-bit hashes: first half of SHA-256 over the arrays, each its length as a 64-bit integer and then its values, all
/// in little endian. The arrays are those of the program in the order of its fields, for a genome followed by the
/// mutation rates. Equal programs behave equally, so the first is the key of evaluations already made.
using Hash128 = std::array<uint8_t, 16>;
Hash128 phenotypeHash(const DevelopmentalProgram& program);
Hash128 genomeHash(const Genome& genome);
std::string toHex(const Hash128& hash);
}  // namespace devo_evo
