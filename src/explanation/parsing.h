#pragma once

#include "devo_evo/explanation/explanation.h"
#include "explanation/documents.h"

#include <vector>

namespace devo_evo
{
/// Rows of the tables of a page (Markdown) whose first column holds names in code style.
std::vector<Explanation> explanationsInPage(const Document& page);

/// Fields and constants of a message or service definition: what the comment above them says.
std::vector<Explanation> explanationsInDefinition(const Document& definition);
}  // namespace devo_evo
