#pragma once

#include "archive/connection.h"

#include <string>

namespace devo_evo
{
/// The columns that hold an evaluation, in tables of individuals and of what is simulated for analyses: valid, fitness,
/// the body's measures, state_hash, its measures of failure.
std::string evaluationColumns(const Body& body);

/// As many marks of parameters: "?, ?, ...".
std::string evaluationMarks(const Body& body);

/// Binds an evaluation to the query's next parameters.
void bindEvaluation(Query& query, const Body& body, const Evaluation& evaluation);

/// Reads them, from the present row's next column on; without velocity windows.
Evaluation readEvaluation(Query& query, const Body& body);
}  // namespace devo_evo
