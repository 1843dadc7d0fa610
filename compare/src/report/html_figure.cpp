#include "figure_data.hpp"
#include "gnuplot.hpp"
#include "html_parts.hpp"
#include "templates.hpp"

namespace settle::compare::report {

std::string figure_html(const Plot& plot, const std::string& caption) {
  data figure;
  figure.set("id", plot.id);
  figure.set("title", text_or_nothing(plot.title));
  figure.set("caption", text_or_nothing(caption));
  figure.set("svg", plot.curves.empty() ? data(false)
                                        : data(inline_svg(run_gnuplot(gnuplot_script(plot)), plot.id, plot.title)));
  data missing(data::type::list);
  for (const std::string& sentence : plot.missing)
    missing.push_back(data("sentence", sentence));
  figure.set("missing", plot.missing.empty() ? data(false) : data("sentences", missing));
  return render(templates::figure, figure);
}

} // namespace settle::compare::report
