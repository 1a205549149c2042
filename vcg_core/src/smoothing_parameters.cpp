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

}  // namespace

void SmoothingParameters::validate() const {
  require_positive("sigma_c", sigma_c);
  require_positive("sigma_s", sigma_s);
  require_positive("sigma_n", sigma_n);
  require_positive("rho", rho);
  if (iterations < 1) reject("iterations", iterations, "1 or more");
  if (threads < 0) reject("threads", threads, "0 (one for each processor) or more");
}

}  // namespace vcg_core
