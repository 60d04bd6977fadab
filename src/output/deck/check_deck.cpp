// One element of a material, compressed at a constant rate, with the answer beside it.

#include <fmt/format.h>

#include "model/pad/foam/foam_rules.hpp"
#include "output/deck/deck_text.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

constexpr double side = 0.01;            // m
constexpr double share_of_curve = 0.9;   // of the last strain of the curve
constexpr double rate_without_any = 10;  // 1/s, for a curve that holds at all rates

constexpr int corners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

/// The compression of a cube on nodes 1 to 8: the bottom is held, the top moves along z alone. In units of
/// the deck.
struct Compression {
  double length = 0, depth = 0, end = 0;  ///< side, displacement of the top, and when it is reached
};

std::string ls_dyna_cube(double length) {
  std::string nodes = "*NODE\n$    NID               X               Y               Z\n";
  std::string held = "*BOUNDARY_SPC_NODE\n$      NID       CID      DOFX      DOFY      DOFZ\n";
  for (int i = 0; i < 8; ++i) {
    const bool on_top = i >= 4;
    nodes += fmt::format("{:>8}{:>16.9g}{:>16.9g}{:>16.9g}\n", i + 1, corners[i % 4][0] * length,
                         corners[i % 4][1] * length, on_top ? length : 0.0);
    held += fmt::format("{:>10}{:>10}{:>10}{:>10}{:>10}\n", i + 1, 0, 1, 1, on_top ? 0 : 1);
  }
  return nodes +
         "*ELEMENT_SOLID\n$    EID     PID      N1      N2      N3      N4      N5      N6      N7      N8\n"
         "       1       1       1       2       3       4       5       6       7       8\n" +
         held;
}

std::string top_moves(int curve_id) {
  std::string text = "*BOUNDARY_PRESCRIBED_MOTION_NODE\n$      NID       DOF       VAD      LCID        SF\n";
  for (int node = 5; node <= 8; ++node)
    text += fmt::format("{:>10}{:>10}{:>10}{:>10}{:>10}\n", node, 3, 2, curve_id, "-1.0");
  return text;
}

std::string ls_dyna_model(const Material& material, const MaterialDeckOptions& options,
                          const Compression& motion, int curve, const std::string& included) {
  return fmt::format(
             "*TITLE\nOne element of {}\n*INCLUDE\n{}\n"
             "*CONTROL_TERMINATION\n{:>10.4g}\n*DATABASE_BNDOUT\n{:>10.4g}\n*DATABASE_ELOUT\n{:>10.4g}\n"
             "*DATABASE_HISTORY_SOLID\n{:>10}\n"
             "*PART\nFoam\n$      PID     SECID       MID\n{:>10}{:>10}{:>10}\n"
             "*SECTION_SOLID\n$    SECID    ELFORM\n{:>10}{:>10}\n",
             plain_ascii(material.name), included, motion.end, motion.end / 100, motion.end / 100, 1, 1, 1,
             options.first_id, 1, 1) +
         ls_dyna_cube(motion.length) + top_moves(curve) +
         define_curve("Displacement of the top against time", curve,
                      "$               TIME       DISPLACEMENT",
                      number_field(0) + number_field(0) + "\n" + number_field(2 * motion.end) +
                          number_field(2 * motion.depth) + "\n") +
         "*END\n";
}

std::string abaqus_model(const Material& material, const Compression& motion, const std::string& included) {
  std::string nodes = "*NODE, NSET=CUBE\n";
  for (int i = 0; i < 8; ++i)
    nodes += fmt::format("{}, {:.9g}, {:.9g}, {:.9g}\n", i + 1, corners[i % 4][0] * motion.length,
                         corners[i % 4][1] * motion.length, i >= 4 ? motion.length : 0.0);
  return fmt::format(
      "*HEADING\nOne element of {}\n{}*ELEMENT, TYPE=C3D8R, ELSET=FOAM\n1, 1, 2, 3, 4, 5, 6, 7, 8\n"
      "*NSET, NSET=BOTTOM\n1, 2, 3, 4\n*NSET, NSET=TOP\n5, 6, 7, 8\n"
      "*INCLUDE, INPUT={}\n*SOLID SECTION, ELSET=FOAM, MATERIAL={}\n"
      "*AMPLITUDE, NAME=MOTION\n0., 0., {:.9g}, 1.\n*STEP\n*DYNAMIC, EXPLICIT\n, {:.9g}\n"
      "*BOUNDARY\nCUBE, 1, 2\nBOTTOM, 3, 3\n*BOUNDARY, AMPLITUDE=MOTION\nTOP, 3, 3, {:.9g}\n"
      "*OUTPUT, HISTORY, TIME INTERVAL={:.9g}\n*NODE OUTPUT, NSET=TOP\nRF3\n*END STEP\n",
      plain_ascii(material.name), nodes, included, abaqus_name(material), motion.end, motion.end,
      -motion.depth, motion.end / 100);
}

}  // namespace

std::string material_check_deck(const Material& material, const MaterialDeckOptions& options,
                                const std::string& included) {
  const MaterialPoints points = deck_points(material, options);
  const PointsAtRate& tested = points.loading.back();
  const bool has_rates = points.loading.size() > 1;
  const double rate = has_rates ? tested.rate : rate_without_any;
  const double last = share_of_curve * tested.curve.strain.back();
  const UnitSystem& units = options.units;
  const bool is_abaqus = options.format.starts_with("abaqus");
  const auto in = [&](double value, const char* si_unit) { return value_in(units, value, si_unit); };
  const Compression motion{in(side, "m"), in(last * side, "m"), in(last / rate, "s")};
  const char* const mark = is_abaqus ? "**" : "$";
  std::string text = is_abaqus ? "" : "*KEYWORD\n";
  const auto note = [&](const std::string& line) { text += comment(mark, line); };
  note(fmt::format("One element of {}, compressed at {:g} 1/s to a nominal strain of {:.4g}.", material.name,
                   rate, last));
  note(fmt::format(
      "NOT RUN IN THIS SOLVER: written to the rules of the solver's manual and read back by Dashpad only. "
      "Run it and compare the total force on the four upper nodes ({}) with this table. Its forces are "
      "the deck's curve, linear between points, times the area of the face. Poisson's ratio is 0, so the "
      "sides may be held.{}",
      is_abaqus ? "RF3" : "bndout",
      options.format == "abaqus-hyperfoam" ? " Abaqus takes a hyperfoam as a smooth function, fitted to its "
                                             "points, so the force may differ by "
                                             "the misfit."
                                           : ""));
  text += fmt::format("{} {:>14}{:>16}{:>16}\n", mark, fmt::format("time ({})", units.time), "nominal strain",
                      fmt::format("force ({})", units.force));
  constexpr int lines = 9;
  for (int i = 1; i <= lines; ++i) {
    const double strain = last * i / lines;
    text += fmt::format(
        "{} {:>14.6g}{:>16.6g}{:>16.6g}\n", mark, in(strain / rate, "s"), strain,
        in(side * side * on_straight_lines(tested.curve.strain, tested.curve.stress, strain), "N"));
  }
  if (is_abaqus) return text + abaqus_model(material, motion, included);
  const int curve = options.first_id + static_cast<int>(points.loading.size()) + 1;
  return text + ls_dyna_model(material, options, motion, curve, included);
}

}  // namespace dashpad::output
