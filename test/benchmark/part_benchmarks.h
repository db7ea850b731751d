#pragma once

namespace devo_evo
{
/// Registers, for every instruction set, what tells where the time goes and what bounds it:
///   parts/<instruction set>/until_<part>   a step of the kernel that ends after the part
///   parts/<instruction set>/kernel         the whole kernel, as it is used
///   loop/<instruction set>/listings:<n>    lives without measures, collisions listed n times in each step
///   limits/<instruction set>/<operation>/<independent or dependent>   how long the processor takes for one operation
void registerPartBenchmarks();
}  // namespace devo_evo
