// The options that say what the columns of compression tests are.

#include "test_columns.hpp"

#include <fmt/format.h>

namespace dashpad::app {

bool TestColumnsRequest::has_columns() const {
  return thickness || area ||
         !(columns.strain + columns.stress + columns.strain_unit + columns.stress_unit + columns.time +
           columns.time_unit)
              .empty();
}

void add_test_columns(CLI::App& app, TestColumnsRequest& request) {
  add_option(app, "--rate RATE", request.rates,
             "Strain rate, such as \"0.01 1/s\", of a table with one test; one for each of several tables");
  add_option(app, "--strain COLUMN", request.columns.strain, "Strain or displacement column of a table");
  add_option(app, "--stress COLUMN", request.columns.stress, "Stress or force column of a table");
  add_option(app, "--strain-unit UNIT", request.columns.strain_unit,
             "Strain or displacement unit, such as fraction, percent, microstrain or mm");
  add_option(app, "--stress-unit UNIT", request.columns.stress_unit,
             "Stress or force unit, such as kPa or N");
  add_option(app, "--thickness LENGTH", request.thickness, "Specimen thickness, needed for displacements");
  add_option(app, "--area AREA", request.area, "Specimen area, such as \"25 cm2\", needed for forces");
}

std::vector<double> rates_of(const TestColumnsRequest& request, std::size_t files,
                             std::vector<std::string>& errors) {
  std::vector<double> rates;
  for (const std::string& text : request.rates)
    rates.push_back(positive_quantity_of("--rate", text, "1/s", errors).value_or(1));
  if (rates.size() > files)
    errors.push_back(fmt::format("--rate: more rates ({}) than files ({})", rates.size(), files));
  return rates;
}

input::StressStrainColumns columns_of(const TestColumnsRequest& request, std::vector<std::string>& errors) {
  input::StressStrainColumns columns = request.columns;
  columns.thickness = positive_quantity_of("--thickness", request.thickness, "m", errors);
  columns.area = positive_quantity_of("--area", request.area, "m2", errors);
  return columns;
}

}  // namespace dashpad::app
