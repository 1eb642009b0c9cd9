#include "math/all_functions.h"

namespace murosimf {

int allFunctionsInEight(const double* in, double* out) {
  using S = Pack<double, 8>;
  S numbers[kInputs], results[kOutputs];
  __builtin_memcpy(numbers, in, sizeof(numbers));
  const int count = allFunctions(numbers, results);
  __builtin_memcpy(out, results, sizeof(S) * static_cast<unsigned>(count));
  return count;
}

}  // namespace murosimf
