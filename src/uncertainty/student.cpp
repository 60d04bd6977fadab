#include "uncertainty/student.hpp"

#include <boost/math/distributions/students_t.hpp>

#include "quantities/special_numbers.hpp"

namespace dashpad::uncertainty {

double student_95(double degrees_of_freedom) {
  if (!(degrees_of_freedom > 0)) return infinite;
  return quantile(complement(boost::math::students_t(degrees_of_freedom), 0.025));
}

}  // namespace dashpad::uncertainty
