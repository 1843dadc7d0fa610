#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "field_svg.hpp"
#include "format.hpp"
#include "html_parts.hpp"
#include "leg_region.hpp"
#include "line_figure.hpp"
#include "templates.hpp"

namespace settle::compare::report {

namespace {

using exchange::Quantity;

/// "MPM: 0.0012 to 0.3232 m, 1920 material points"
std::string range_text(const FieldLeg& leg, const std::string& unit) {
  if (leg.range.empty()) return fmt::format("{}: no value, {}", leg.title, leg.drawn);
  const double largest = std::max(std::abs(leg.range.lowest), std::abs(leg.range.highest));
  return fmt::format("{}: {} to {}{}{}, {}", leg.title, number_beside(leg.range.lowest, largest, 4),
                     number_beside(leg.range.highest, largest, 4), unit.empty() ? "" : " ", unit, leg.drawn);
}

/// Zero in the middle.
ValueRange two_sided(const ValueRange& range) {
  const double largest = std::max(std::abs(range.lowest), std::abs(range.highest));
  return {.lowest = -largest, .highest = largest};
}

/// A panel, or a few of them, over the bar of their scale.
data group(const std::vector<const FieldLeg*>& legs, const PanelFrame& frame, const ValueRange& scale, ColourMap map,
           const std::string& quantity, const std::string& unit) {
  data panels(data::type::list);
  for (const FieldLeg* leg : legs) {
    data panel("title", leg->title);
    panel.set("drawn", leg->drawn);
    panel.set("width", fmt::format("{:.0f}", std::max(140.0, panel_width(frame))));
    panel.set("svg", panel_svg(frame, *leg, scale, map, fmt::format("{}. {}", quantity, range_text(*leg, unit))));
    panels.push_back(panel);
  }
  data all("panels", panels);
  all.set("bar", colour_bar_svg(scale, map, quantity, unit));
  return all;
}

data groups(const RunOutcome& run, const FieldPicture& picture) {
  const PanelFrame frame = panel_frame(run, picture);
  const Axis axis = axis_of(picture.quantity);
  std::vector<const FieldLeg*> legs;
  for (const FieldLeg& leg : picture.legs)
    legs.push_back(&leg);
  data list(data::type::list);
  list.push_back(group(legs, frame, picture.scale, ColourMap::even, axis.title + axis.sense, axis.unit));
  if (picture.difference && !picture.difference->range.empty())
    list.push_back(group({&*picture.difference}, frame, two_sided(picture.difference->range), ColourMap::two_sided,
                         axis.title + ", MPM − FEM", axis.unit));
  return list;
}

bool has_spots(const FieldPicture& picture) {
  return std::any_of(picture.legs.begin(), picture.legs.end(), [](const FieldLeg& leg) { return !leg.spots.empty(); });
}

/// How far the two are apart all over a body, and in its parts; empty where they are not compared.
std::string parts_text(const RunOutcome& run, Quantity quantity) {
  LegRequest leg{.value = "mpm",
                 .reference = "fem",
                 .quantity = quantity,
                 .over = exchange::Over::fields,
                 .stage = run.study.n_stages()};
  const auto share = [&](exchange::Region region) {
    leg.region = region;
    return ratio(relative_norm(leg_samples(run, leg), exchange::Norm::l2).value);
  };
  if (!relative_norm(leg_samples(run, leg), exchange::Norm::l2).problem.empty()) return {};
  return fmt::format(
      "The difference is {} of FEM (l2) in all, {} in the interior, {} within {} m of the free surface. ",
      share(exchange::Region::whole), share(exchange::Region::interior), share(exchange::Region::surface),
      number(band_width(run, leg), 3));
}

std::string caption_of(const RunOutcome& run, const FieldPicture& picture) {
  const std::string unit = axis_of(picture.quantity).unit;
  std::string text;
  for (const FieldLeg& leg : picture.legs)
    text += range_text(leg, unit) + ". ";
  if (picture.difference) text += range_text(*picture.difference, unit) + ". ";
  if (picture.difference && is_body(run.study)) text += parts_text(run, picture.quantity);
  text += "Material is drawn where it is now; dashed: the design. ";
  if (has_spots(picture)) text += "A point is a spot of its size: what shows between spots is no crack. ";
  const double stretch = panel_frame(run, picture).stretch;
  if (stretch > 1.01) text += fmt::format("Widths are drawn {} times as large as heights. ", number(stretch, 2));
  for (const std::string& remark : picture.remarks)
    text += remark + " ";
  return text;
}

/// Of a refinement family, whose finest level is drawn alone.
bool is_coarser_level(const CampaignOutcome& outcome, const RunOutcome& run) {
  return std::any_of(outcome.families.begin(), outcome.families.end(), [&](const Family& family) {
    return family.name == run.family && !family.runs.empty() && family.runs.back() != run.name;
  });
}

std::string field_html(const CampaignOutcome& outcome, const RunOutcome& run, Quantity quantity) {
  const FieldPicture picture = field_picture_of(run, quantity);
  const bool drawn = !picture.scale.empty();
  data figure("id", fmt::format("{}-field-{}", anchor_of(outcome, run), name_of(quantity)));
  figure.set("title", fmt::format("{} at the end of construction", axis_of(quantity).title));
  figure.set("groups", drawn ? groups(run, picture) : data(false));
  data missing(data::type::list);
  for (const std::string& sentence : picture.missing)
    missing.push_back(data("sentence", printable(sentence)));
  figure.set("missing", picture.missing.empty() ? data(false) : data("sentences", missing));
  figure.set("caption", drawn ? data(caption_of(run, picture)) : data(false));
  return render(templates::fields, figure);
}

/// Plastic strain where something may yield.
std::vector<Quantity> drawn_fields(const RunOutcome& run) {
  const bool yields = std::any_of(run.solvers.begin(), run.solvers.end(), [](const SolverRun& solver) {
    return solver.result && !solver.result->stages.empty() &&
           !solver.result->stages.back().points.plastic_strain.empty();
  });
  if (yields) return {Quantity::settlement, Quantity::vertical_stress, Quantity::plastic_strain};
  return {Quantity::settlement, Quantity::vertical_stress};
}

} // namespace

std::string fields_html(const CampaignOutcome& outcome, const RunOutcome& run) {
  if (!outcome.campaign.report.fields || is_coarser_level(outcome, run)) return {};
  std::string html;
  for (const Quantity quantity : drawn_fields(run))
    html += field_html(outcome, run, quantity);
  return html;
}

} // namespace settle::compare::report
