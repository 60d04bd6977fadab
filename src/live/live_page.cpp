#include "live/live_page.hpp"

#include <string>

#include <fmt/format.h>

#include "dashpad/output/impact.hpp"
#include "json/json_values.hpp"
#include "live/case_tables.hpp"
#include "output/page/html.hpp"
#include "output/page/html_elements.hpp"
#include "output/plot/svg_plot.hpp"

namespace dashpad::live {

namespace {

/// JSON inside of a script element, which nothing in it can end.
std::string embedded(const Json& json) {
  std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  for (std::size_t at = 0; (at = text.find('<', at)) != std::string::npos;) text.replace(at, 1, "\\u003c");
  return text;
}

}  // namespace

std::string live_page(const LivePage& page, const Folders& folders) {
  Json tables = Json::parse(answer(Json{{"do", "read"}, {"text", page.case_text}}.dump(), folders))["case"];
  Json request{{"do", "solve"},
               {"case", tables},
               {"standard", page.standard},
               {"units", page.units},
               {"intervals", true}};
  request.update(Json(page.user));
  const Json first = Json::parse(answer(request.dump(), folders));

  Json state{{"case", tables},
             {"pads", Json::array({tables.contains("pad") ? tables["pad"] : Json::object()})},
             {"active", 0},
             {"standard", page.standard},
             {"user", page.user.empty() ? Json::object() : Json(page.user)},
             {"units", page.units}};
  state["case"].erase("pad");

  output::PageHtml html;
  html.title = output::text_html(first["title"].get<std::string>()) + " - Dashpad";
  html.styles = {std::string(output::page_live_style), std::string(output::impact_drawing_style()),
                 std::string(output::style_sheet(output::PlotStyle::light_and_dark))};
  html.is_live = true;
  html.body = fmt::format(
      "<div class=\"live\">\n{}<div id=\"result\">\n{}</div>\n</div>\n"
      "<script type=\"application/json\" id=\"state\">{}</script>\n"
      "<script type=\"application/octet-stream\" id=\"engine\">{}</script>\n",
      output::page_live_controls, first["html"].get<std::string>(), embedded(state),
      output::base64(page.engine));
  return output::framed(html);
}

}  // namespace dashpad::live
