#pragma once

namespace devo_evo
{
/// Registers, for every instruction set, what tells where the time goes and what bounds it:
///   parts/<instruction set>               the kernel, and steps of it that end after each of its parts
///   loop/<instruction set>/listings:<n>   lives without measures, collisions listed n times in each step
///   limits/<instruction set>/<operation>/<independent or dependent>   how long the processor takes for one operation
void registerPartBenchmarks();
}  // namespace devo_evo
