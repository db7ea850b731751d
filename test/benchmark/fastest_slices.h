#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace devo_evo
{
/// CPU time of this thread for something that is repeated, in slices, each at its fastest of all repetitions so far: on
/// a processor that others share, hardly a whole life is left alone, but most slices are at some time.
class FastestSlices
{
public:
  /// A repetition, in which the same steps follow as in the others.
  void begin();

  /// Ends a slice after every hundredth step.
  void took(int64_t step)
  {
    if (step % STEPS == 0)
    {
      endSlice();
    }
  }

  void endSlice();

  double sum() const;    ///< [s]
  double whole() const;  ///< what this repetition has taken [s]

private:
  static constexpr int64_t STEPS = 100;

  std::vector<double> seconds_;
  size_t next_ = 0;
  double begin_ = 0.0;
  double since_ = 0.0;
};
}  // namespace devo_evo
