/// The drawing of an impact: well-formed, inside its frame, true to scale, and with the words that it must
/// have, whatever nose, pad and support.

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <regex>
#include <set>

#include <gmock/gmock.h>

#include "dashpad/output/impact.hpp"
#include "example_result.hpp"
#include "output/drawing/pictures.hpp"
#include "output/drawing/scene.hpp"
#include "output/svg/svg.hpp"
#include "quantities/text.hpp"
#include "svg_elements.hpp"

namespace dashpad::output {
namespace {

using test::SvgElement;
using testing::HasSubstr;
using testing::Not;

const UnitSystem& si() { return unit_system("si"); }

std::vector<Nose> every_nose() {
  return {Sphere{.radius = 0.0762},
          FlatDisc{.radius = 0.05},
          Cone{.radius = 0.1, .half_angle = 0.7, .tip_radius = 0.01},
          Ellipsoid{.half_depth = 0.04, .half_length = 0.06, .half_width = 0.05},
          Rod{.radius = 0.03, .tip_radius = 0.05},
          Platen{.length = 0.2, .width = 0.1},
          Cylinder{.radius = 0.06, .length = 0.15},
          Profile{.points = {{0, 0}, {0.01, 0.02}, {0.05, 0.06}}},
          Profile{.of = Profile::Of::area, .points = {{0, 1e-4}, {0.02, 4e-3}}}};
}

/// A history of three entries: at first contact, deepest, on the way back.
Solution made_up(double penetration, double deflection, double body_motion = 0) {
  Solution solution{.summary = test::example_summary(), .history = {}};
  solution.summary.peak_penetration = penetration;
  solution.history.time = {0, 0.01, 0.02};
  solution.history.penetration = {0, penetration, penetration / 2};
  solution.history.support_deflection = {0, deflection, deflection / 2};
  solution.history.body_motion = {0, body_motion, body_motion};
  solution.history.motion = {0, penetration + deflection, penetration};
  return solution;
}

Support spring() { return Support::linear(1e5); }

std::vector<SvgElement> elements_of(const std::string& svg) { return test::svg_elements(svg); }

/// Whether an element is inside one that is cut off at the edge of its picture, or is a definition.
bool is_clipped(const std::vector<SvgElement>& elements, const SvgElement& element) {
  return std::ranges::any_of(element.ancestors, [&](std::size_t i) {
    return elements[i].attributes.contains("clip-path") || elements[i].name == "defs";
  });
}

/// How long a text may be in a wide font, px.
double room_of(const SvgElement& text) {
  std::string seen = text.text;
  for (const auto& [entity, character] :
       {std::pair{"&lt;", "<"}, {"&gt;", ">"}, {"&#39;", "'"}, {"&quot;", "\""}, {"&amp;", "&"}})
    replace_all(seen, entity, character);
  const bool is_heading = text.is_of("dd-heading"), is_bold = is_heading || text.is_of("dd-value");
  const bool is_small = text.is_of("dd-small") || text.is_of("dd-faint");
  const double size = is_heading ? heading_size : is_small ? small_text_size : text_size;
  return text_room(seen, is_bold ? size_for_bold * size : size);
}

/// From where to where a page shows the half of the drawing in which the element is, px.
std::pair<double, double> view_of(const std::vector<SvgElement>& elements, const SvgElement& element) {
  for (const std::size_t i : element.ancestors)
    if (const auto view = elements[i].attributes.find("data-view"); view != elements[i].attributes.end()) {
      double from = 0, width = 0;
      EXPECT_EQ(std::sscanf(view->second.c_str(), "%lf 0 %lf", &from, &width), 2) << view->second;
      return {from, from + width};
    }
  return {0, drawing_width};
}

/// Well-formed, its numbers finite and inside the frame, ids of its own, dimensions as long as they say.
void expect_sound(const std::string& svg) {
  std::vector<SvgElement> elements;
  ASSERT_NO_THROW(elements = elements_of(svg)) << svg;
  const SvgElement& root = elements.front();
  ASSERT_EQ(root.name, "svg");
  EXPECT_THAT(svg, Not(HasSubstr("\x01")));
  double width = 0, height = 0;
  ASSERT_EQ(std::sscanf(root.attributes.at("viewBox").c_str(), "0 0 %lf %lf", &width, &height), 2);
  ASSERT_EQ(width, drawing_width);
  ASSERT_LT(height, 700);
  const double scale = root.number("data-scale");
  ASSERT_TRUE(std::isfinite(scale) && scale > 0);
  const auto expect_inside = [&](double x, double y, const SvgElement& element) {
    const auto [from, to] = view_of(elements, element);
    EXPECT_TRUE(x >= from && x <= to && y >= 0 && y <= height)
        << element.name << " of class " << element.attributes.at("class") << " at " << x << ", " << y
        << ", not between " << from << " and " << to << ": " << element.text;
  };
  std::set<std::string> ids;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const SvgElement& element = elements[i];
    EXPECT_TRUE(element.name != "script" && element.name != "image");
    if (const auto id = element.attributes.find("id"); id != element.attributes.end()) {
      EXPECT_TRUE(ids.insert(id->second).second) << id->second;
    }
    static const std::regex number("^-?[0-9.]+(e[-+][0-9]+)?$");
    for (const char* key : {"x", "y", "x1", "y1", "x2", "y2", "width", "height"})
      if (const auto found = element.attributes.find(key); found != element.attributes.end()) {
        EXPECT_TRUE(std::regex_match(found->second, number)) << key << " = " << found->second;
      }
    if (const auto data = element.attributes.find("d"); data != element.attributes.end()) {
      EXPECT_EQ(data->second.find_first_not_of("MLZV H-.0123456789"), std::string::npos) << data->second;
    }
    if (is_clipped(elements, element)) continue;
    if (element.name == "line") {
      expect_inside(element.number("x1"), element.number("y1"), element);
      expect_inside(element.number("x2"), element.number("y2"), element);
    }
    if (element.name == "text") {
      const double length = room_of(element);
      const double from = element.has("text-anchor", "start") ? 0
                          : element.has("text-anchor", "end") ? 1
                                                              : 0.5;
      expect_inside(element.number("x") - from * length, element.number("y"), element);
      expect_inside(element.number("x") + (1 - from) * length, element.number("y"), element);
    }
    if (element.has("class", "dd-dimension") && element.has("data-to-scale", "yes")) {
      const SvgElement& line = elements[i + 1];
      EXPECT_NEAR(line.number("y2") - line.number("y1"), element.number("data-metres") * scale, 0.02)
          << element.attributes.at("data-of");
    }
  }
  for (const SvgElement& element : elements)
    for (const auto& [key, value] : element.attributes)
      if (value.starts_with("url(#")) {
        EXPECT_TRUE(ids.contains(value.substr(5, value.size() - 6))) << value;
      }
}

/// The element of that dimension.
const SvgElement* dimension(const std::vector<SvgElement>& elements, std::string_view text) {
  for (const SvgElement& element : elements)
    if (element.has("data-of", text)) return &element;
  return nullptr;
}

TEST(ImpactDrawing, KnowsEveryNose) {
  std::set<std::string> drawings;
  for (const Nose& nose : every_nose()) {
    SCOPED_TRACE(name_of(nose));
    ImpactCase impact = test::example_case();
    impact.title.clear();
    impact.impactor.nose = nose;
    const std::string svg = impact_drawing(impact, made_up(0.02, 0.03), si());
    expect_sound(svg);
    EXPECT_THAT(svg, HasSubstr(" on a pad</title>"));
    drawings.insert(svg);
  }
  EXPECT_EQ(drawings.size(), every_nose().size());
}

TEST(ImpactDrawing, KnowsEverySupport) {
  for (int parts = 0; parts < 128; ++parts) {
    ImpactCase impact = test::example_case();
    impact.support = (parts & 1) != 0 ? spring() : Support::through({{0.002, 3000}, {0.02, 3200}});
    const auto if_part = [&](int part, double value) { return (parts & part) != 0 ? value : 0; };
    impact.backing = {.unloading_stiffness = if_part(2, 2e6),
                      .damping = if_part(4, 30),
                      .mass = if_part(8, 1.2),
                      .body_mass = if_part(16, 7.4),
                      .gap = if_part(32, 0.004),
                      .preload = if_part(64, 100)};
    if (!violations(impact).empty()) continue;
    SCOPED_TRACE(parts);
    const std::string svg = impact_drawing(impact, made_up(0.02, 0.03, if_part(16, 0.01)), si());
    expect_sound(svg);
    EXPECT_EQ(svg.find("free body 7.4 kg") != std::string::npos, (parts & 16) != 0);
    EXPECT_EQ(svg.find("body moved") != std::string::npos, (parts & 16) != 0);
    EXPECT_EQ(svg.find("crushable") != std::string::npos, (parts & 2) != 0);
    EXPECT_THAT(svg, HasSubstr("30 mm</text>"));
  }
}

TEST(ImpactDrawing, HasWhatIsMeasured) {
  const std::string svg = impact_drawing(test::example_case(), made_up(0.02, 0.05), si());
  const std::vector<SvgElement> elements = elements_of(svg);
  for (const auto& [of, metres] :
       {std::pair{"thickness", 0.0254}, {"penetration", 0.02}, {"left", 0.0054}, {"deflection", 0.05}}) {
    const SvgElement* found = dimension(elements, of);
    ASSERT_NE(found, nullptr) << of;
    EXPECT_NEAR(found->number("data-metres"), metres, 1e-12);
    EXPECT_TRUE(found->has("data-to-scale", "yes")) << of;
  }
  for (const char* text : {"4.5 kg", "8.94 m/s", "25.4 mm", "20 mm", "5.4 mm", "50 mm", "soft-foam",
                           "fitted up to 0.9", "Greatest penetration, at 10 ms", "Head on a dashboard"})
    EXPECT_THAT(svg, HasSubstr(text));
  EXPECT_THAT(impact_drawing(test::example_case(), made_up(0.02, 0.05), unit_system("us")),
              HasSubstr("1 in<"));
}

TEST(ImpactDrawing, OfAnImpactThatIsCutItIsTheDeepestSoFar) {
  Solution cut = made_up(0.02, 0.05);
  cut.summary.status = Status::time_limit;
  cut.summary.contact_end.reset();
  EXPECT_THAT(impact_drawing(test::example_case(), cut, si()), HasSubstr("Greatest penetration, at 10 ms"))
      << "it had turned";
  cut.history.penetration.back() = 0.021;
  const std::string svg = impact_drawing(test::example_case(), cut, si());
  EXPECT_THAT(svg, HasSubstr("Deepest so far, at 20 ms"));
  EXPECT_THAT(svg, HasSubstr("Right: deepest so far"));
  EXPECT_THAT(svg, Not(HasSubstr("reatest penetration")));
}

TEST(ImpactDrawing, TheNoseEndsWhereThePenetrationDoes) {
  for (const Nose& nose : every_nose()) {
    ImpactCase impact = test::example_case();
    impact.impactor.nose = nose;
    const std::vector<SvgElement> elements = elements_of(impact_drawing(impact, made_up(0.02, 0.03), si()));
    double lowest = 0, tip = 0;
    for (std::size_t i = 0; i < elements.size(); ++i) {
      if (elements[i].has("class", "dd-nose")) {  // the last one is that of the right picture
        lowest = 0;
        const std::string& data = elements[i].attributes.at("d");
        static const std::regex place("[ML](-?[0-9.]+) (-?[0-9.]+)");
        for (std::sregex_iterator found(data.begin(), data.end(), place), end; found != end; ++found)
          lowest = std::max(lowest, std::stod((*found)[2]));
      }
      if (elements[i].has("data-of", "penetration")) tip = elements[i + 1].number("y2");
    }
    EXPECT_NEAR(lowest, tip, 0.02) << name_of(nose);
  }
}

TEST(ImpactDrawing, StruckThroughIsSaidAndDrawn) {
  ImpactCase impact = test::example_case();
  impact.support = Support::rigid();
  Solution solution = made_up(0.0253, 0);
  EXPECT_THAT(impact_drawing(impact, solution, si()), Not(HasSubstr("Less than 0.1 % left")));
  // By the measure for a layer, though no column is closed.
  solution = made_up(0.02539, 0);
  EXPECT_THAT(impact_drawing(impact, solution, si()), HasSubstr(">Less than 0.1 % left</text>"));
  EXPECT_THAT(impact_drawing(impact, solution, si()), HasSubstr("&lt; 0.03 mm</text>"));
  solution.summary = test::bottomed_out_summary();
  const std::string svg = impact_drawing(impact, solution, si());
  expect_sound(svg);
  EXPECT_THAT(svg, HasSubstr(">Bottomed out</text>"));
  EXPECT_THAT(svg, HasSubstr("<line class=\"dd-struck-edge\""));
  EXPECT_THAT(svg, HasSubstr(">0 mm</text>"));
}

TEST(ImpactDrawing, InACraterFirstContactIsBelowTheFace) {
  ImpactCase impact = test::example_case();
  Solution solution = made_up(0.02, 0.03);
  solution.history.penetration.front() = 0.01;
  solution.summary.blows = 3;
  solution.summary.blow = 2;
  const std::string svg = impact_drawing(impact, solution, si());
  expect_sound(svg);
  EXPECT_THAT(svg, HasSubstr("First contact of blow 2"));
  EXPECT_THAT(svg, HasSubstr("Pad: soft-foam"));  // its name is not on the pad, where the nose is
  // The left picture has strained columns already.
  const std::string left = svg.substr(0, svg.find("-right)"));
  EXPECT_THAT(left, HasSubstr("class=\"dd-s5\""));
}

TEST(ImpactDrawing, LayersHaveNamesAndShareThePenetration) {
  for (const std::size_t count : {2U, 3U, 8U}) {
    ImpactCase impact = test::example_case();
    std::vector<PadLayer> layers(count);
    Solution solution = made_up(0.02, 0.01);
    for (std::size_t i = 0; i < count; ++i) {
      layers[i].thickness = 0.04 / static_cast<double>(count);
      layers[i].material = impact.pad.material;
      layers[i].material.name = "foam-" + std::to_string(i);
      solution.history.layer_strain.push_back({0, i == 0 ? 0.7 : 0.4, 0.1});
    }
    set_layers(impact.pad, layers);
    impact.pad.material = {};
    solution.summary.layers.resize(count);
    solution.summary.layers[1].struck_through = 0.01;
    const std::string svg = impact_drawing(impact, solution, si());
    expect_sound(svg);
    for (std::size_t i = 0; i < count; ++i) EXPECT_THAT(svg, HasSubstr("foam-" + std::to_string(i)));
    EXPECT_THAT(svg, HasSubstr(">Strain<"));
    EXPECT_THAT(svg, HasSubstr("Less than 0.1 % left in layer 2"));
    EXPECT_THAT(svg, HasSubstr("hatching-" + std::to_string(count)));
  }
}

TEST(ImpactDrawing, EachLayerHasItsOwnThickness) {
  ImpactCase impact = test::example_case();
  const std::vector<double> thicknesses{0.005, 0.02, 0.011};
  std::vector<PadLayer> layers;
  for (const double thickness : thicknesses)
    layers.push_back({.thickness = thickness, .material = impact.pad.material});
  set_layers(impact.pad, layers);
  const auto elements = elements_of(impact_drawing(impact, made_up(0.01, 0.002), si()));
  std::vector<double> drawn;
  std::vector<std::string> written;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (!elements[i].has("data-of", "thickness")) continue;
    drawn.push_back(elements[i].number("data-metres"));
    for (const SvgElement& element : elements)
      if (element.is_of("dd-value") && !element.ancestors.empty() && element.ancestors.back() == i)
        written.push_back(element.text);
  }
  EXPECT_EQ(drawn, thicknesses);
  EXPECT_EQ(written, (std::vector<std::string>{"5 mm", "20 mm", "11 mm"}));
}

TEST(ImpactDrawing, ASheetFollowsTheNose) {
  ImpactCase impact = test::example_case();
  EXPECT_THAT(impact_drawing(impact, made_up(0.02, 0.03), si()), Not(HasSubstr("class=\"dd-sheet")));
  impact.pad.sheet = 12;
  for (const Nose& nose : every_nose()) {
    if (std::holds_alternative<Cylinder>(nose)) continue;  // refused
    impact.impactor.nose = nose;
    const std::string svg = impact_drawing(impact, made_up(0.02, 0.03), si());
    expect_sound(svg);
    const auto elements = elements_of(svg);
    std::vector<std::string> sheets, noses;
    for (const SvgElement& element : elements) {
      if (element.has("class", "dd-sheet-bent")) sheets.push_back(element.attributes.at("d"));
      if (element.has("class", "dd-nose")) noses.push_back(element.attributes.at("d"));
    }
    EXPECT_EQ(sheets.size(), 2U);
    EXPECT_EQ(sheets, noses);
  }
}

TEST(ImpactDrawing, ABlockEndsWhereItsFaceDoes) {
  // The same area has the outline of the nose: a circle, an ellipse, a rectangle of these proportions.
  const double area = 0.01;
  EXPECT_DOUBLE_EQ(half_width_of_face(Sphere{0.1}, area), std::sqrt(area / std::numbers::pi));
  EXPECT_DOUBLE_EQ(half_width_of_face(Platen{.length = 0.2, .width = 0.2}, area), 0.05);
  EXPECT_DOUBLE_EQ(half_width_of_face(Cylinder{.radius = 0.1, .length = 0.1}, area), 0.05);
  for (const Nose& nose : every_nose()) {
    ImpactCase impact = test::example_case();
    impact.impactor.nose = nose;
    impact.pad.area = area;
    const std::string svg = impact_drawing(impact, made_up(0.02, 0.03), si());
    expect_sound(svg);
    EXPECT_THAT(svg, HasSubstr("across as drawn"));
  }
}

TEST(ImpactDrawing, ExtremesStayReadable) {
  std::mt19937_64 random(7);
  const auto share = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  const auto length = [&] { return std::pow(10, -5 + 7 * share()); };
  int drawn = 0;
  for (int round = 0; round < 400; ++round) {
    SCOPED_TRACE(round);
    ImpactCase impact = test::example_case();
    const double size = length();
    const std::vector<Nose> noses{Sphere{size},
                                  FlatDisc{size},
                                  Cone{size, 0.01 + 1.5 * share(), 0},
                                  Ellipsoid{size, length(), length()},
                                  Rod{size, size * (1 + share())},
                                  Platen{size, length()},
                                  Cylinder{size, length()}};
    impact.impactor.nose = noses[random() % noses.size()];
    impact.pad.thickness = length();
    if (random() % 3 == 0) impact.pad.area = std::pow(length(), 2);
    if (random() % 2 == 0) impact.support = Support::rigid();
    if (random() % 3 == 0) impact.backing = {.body_mass = 3};
    if (!violations(impact).empty()) continue;
    const double penetration = impact.pad.thickness * std::pow(share(), 3);
    Solution solution = made_up(penetration, impact.support.is_rigid() ? 0 : length(),
                                impact.backing.body_mass > 0 ? length() : 0);
    const std::string svg = impact_drawing(impact, solution, si());
    expect_sound(svg);
    EXPECT_LT(svg.size(), 60'000U);
    ++drawn;
  }
  EXPECT_GT(drawn, 200);
}

TEST(ImpactDrawing, NothingOfAUserIsMarkup) {
  ImpactCase impact = test::example_case();
  impact.title = "</title><script>alert('1')</script>\x01\xff & \"quotes\"";
  impact.pad.material.name = "<b>foam</b> \x02 with a name that is far too long to stand on any pad whatever";
  const std::string svg = impact_drawing(impact, made_up(0.02, 0.03), si());
  expect_sound(svg);
  EXPECT_THAT(svg, Not(HasSubstr("<script")));
  EXPECT_THAT(svg, Not(HasSubstr("<b>")));
}

TEST(ImpactDrawing, NumbersThatAreNoneDoNoHarm) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const double endless = std::numeric_limits<double>::infinity();
  for (const double bad : {none, endless, -endless, -1.0, 1e300}) {
    Solution solution = made_up(bad, bad, bad);
    solution.history.time = {bad, bad, bad};
    expect_sound(impact_drawing(test::example_case(), solution, si()));
    solution.history = {};
    expect_sound(impact_drawing(test::example_case(), solution, si()));
  }
  expect_sound(impact_drawing(test::example_case(), {}, si()));
}

TEST(ImpactDrawing, ACaseThatBreaksARuleIsNotDrawn) {
  ImpactCase impact = test::example_case();
  impact.pad.thickness = -1;
  const std::string svg = impact_drawing(impact, made_up(0.02, 0.03), si());
  EXPECT_NO_THROW(elements_of(svg));
  EXPECT_THAT(svg, HasSubstr("No drawing"));
}

TEST(ImpactDrawing, TwoInOnePageShareNoId) {
  const std::string one = impact_drawing(test::example_case(), made_up(0.02, 0.03), si());
  const std::string other = impact_drawing(test::example_case(), made_up(0.021, 0.03), si());
  EXPECT_EQ(one, impact_drawing(test::example_case(), made_up(0.02, 0.03), si()));
  std::set<std::string> ids;
  for (const SvgElement& element : elements_of(one))
    if (element.attributes.contains("id")) ids.insert(element.attributes.at("id"));
  ASSERT_GE(ids.size(), 4U);
  for (const SvgElement& element : elements_of(other))
    if (element.attributes.contains("id")) {
      EXPECT_FALSE(ids.contains(element.attributes.at("id")));
    }
}

TEST(ImpactDrawing, ItsStyleIsTheOneThatAPageMayAdmit) {
  const std::string svg = impact_drawing(test::example_case(), made_up(0.02, 0.03), si());
  EXPECT_THAT(svg, HasSubstr("<style>" + std::string(impact_drawing_style()) + "</style>"));
  EXPECT_EQ(impact_drawing_style().find_first_of("<&>"), std::string_view::npos);
}

TEST(ImpactDrawing, LabelsAreKeptApart) {
  EXPECT_THAT(kept_apart({10, 12, 14}, {0, 20, 20}, 0, 100), testing::ElementsAre(10, 30, 50));
  EXPECT_THAT(kept_apart({90, 95}, {0, 20}, 0, 100), testing::ElementsAre(80, 100));
  EXPECT_THAT(kept_apart({-5, 50}, {0, 20}, 0, 100), testing::ElementsAre(0, 50));
}

}  // namespace
}  // namespace dashpad::output
