#include "drawing.hpp"
#include "figure_data.hpp"
#include "gnuplot.hpp"
#include "html_parts.hpp"
#include "templates.hpp"

namespace settle::compare::report {

std::string figure_html(const Drawing& drawing) {
  data figure;
  figure.set("id", drawing.id);
  figure.set("title", text_or_nothing(drawing.title));
  figure.set("caption", text_or_nothing(drawing.caption));
  figure.set("svg",
             drawing.script.empty() ? data(false) : data(to_be_drawn(drawing.id, drawing.title, drawing.script)));
  data missing(data::type::list);
  for (const std::string& sentence : drawing.missing)
    missing.push_back(data("sentence", sentence));
  figure.set("missing", drawing.missing.empty() ? data(false) : data("sentences", missing));
  return render(templates::figure, figure);
}

std::string figure_html(const Plot& plot, const std::string& caption) {
  return figure_html(Drawing{.id = plot.id,
                             .title = plot.title,
                             .caption = caption,
                             .script = plot.curves.empty() ? std::string() : gnuplot_script(plot),
                             .missing = plot.missing});
}

} // namespace settle::compare::report
