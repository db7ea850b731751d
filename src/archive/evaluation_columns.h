#pragma once

#include "archive/connection.h"
#include "devo_evo/soft_body/evaluation.h"

#include <optional>
#include <tuple>

namespace devo_evo
{
/// The columns that hold an evaluation, in tables of individuals and of what is simulated for analyses.
#define DEVO_EVO_EVALUATION_COLUMNS                                                                  \
  "valid, fitness, displacement_y_voxels, displacement_xy_voxels, first_top_contact_since_birth_s, " \
  "fell_over_since_birth_s, turns, airborne_fraction, state_hash, divergence_step, divergence_bond, divergence_strain"

/// What is bound to them, in their order.
using EvaluationValues =
    std::tuple<int, double, double, double, std::optional<double>, std::optional<double>, double, double,
               std::optional<Blob>, std::optional<int64_t>, std::optional<int64_t>, std::optional<double>>;
EvaluationValues evaluationValues(const Evaluation& evaluation);

/// Reads them, from the present row's next column on; without velocity windows.
Evaluation readEvaluation(Query& query);
}  // namespace devo_evo
