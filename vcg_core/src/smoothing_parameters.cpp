#include <vcg_core/smoothing_parameters.h>

#include <cmath>
#include <sstream>

#include <vcg_core/errors.h>

namespace vcg_core {

namespace {

template <class Value>
[[noreturn]] void reject(const char* name, Value value, const char* allowed) {
  std::ostringstream message;
  message << name << " is " << value << "; it must be " << allowed;
  throw InvalidParameter(message.str());
}

void require_positive(const char* name, double value) {
  if (!(std::isfinite(value) && value > 0)) reject(name, value, "a finite number greater than 0");
}

void require_up_to(const char* name, double value, double most, const char* allowed) {
  if (!(value > 0 && value <= most)) reject(name, value, allowed);
}

}  // namespace

void SmoothingParameters::validate(int fewest_iterations) const {
  require_positive("sigma_c", sigma_c);
  require_positive("sigma_s", sigma_s);
  require_positive("sigma_n", sigma_n);
  require_positive("rho", rho);
  require_up_to("strength", strength, 10, "greater than 0 and at most 10");
  require_up_to("feature_angle", feature_angle, 90, "greater than 0 and at most 90 (degrees)");
  if (iterations < fewest_iterations)
    reject("iterations", iterations, fewest_iterations == 0 ? "0 (automatic) or more" : "1 or more");
  if (threads < 0) reject("threads", threads, "0 (one for each processor) or more");
}

}  // namespace vcg_core
