#include "drawing.hpp"

#include <algorithm>
#include <vector>

#include "format.hpp"
#include "gnuplot.hpp"
#include "parallel.hpp"

namespace settle::compare::report {

namespace {

constexpr char begin_mark = '\x02';
constexpr char part_mark = '\x1f';
constexpr char end_mark = '\x03';

/// A place found in a page.
struct Place {
  std::size_t begin = 0, end = 0; ///< in the page, `end` behind its last character
  std::string id, title, script;
};

std::vector<Place> places_in(const std::string& page) {
  std::vector<Place> places;
  for (std::size_t at = page.find(begin_mark); at != std::string::npos; at = page.find(begin_mark, at + 1)) {
    const std::size_t title = page.find(part_mark, at);
    const std::size_t script = page.find(part_mark, title + 1);
    const std::size_t end = page.find(end_mark, script);
    places.push_back({.begin = at,
                      .end = end + 1,
                      .id = page.substr(at + 1, title - at - 1),
                      .title = page.substr(title + 1, script - title - 1),
                      .script = page.substr(script + 1, end - script - 1)});
  }
  return places;
}

/// The figures of places first, first + step, ... by one gnuplot.
void draw(const std::vector<Place>& places, std::size_t first, std::size_t step, std::vector<std::string>& figures) {
  std::vector<std::string> scripts;
  for (std::size_t i = first; i < places.size(); i += step)
    scripts.push_back(places[i].script);
  const std::vector<std::string> pictures = run_gnuplot(scripts);
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const Place& place = places[first + i * step];
    figures[first + i * step] = inline_svg(pictures[i], place.id, place.title);
  }
}

} // namespace

std::string to_be_drawn(const std::string& id, const std::string& title, const std::string& script) {
  return begin_mark + id + part_mark + printable(title) + part_mark + script + end_mark;
}

std::string with_figures(const std::string& page, int processes) {
  constexpr std::size_t worth_a_process = 8; // figures that are drawn in the time it takes to start gnuplot
  const std::vector<Place> places = places_in(page);
  const std::size_t batches = std::min((places.size() + worth_a_process - 1) / worth_a_process,
                                       static_cast<std::size_t>(std::max(processes, 1)));
  std::vector<std::string> figures(places.size());
  parallel_for(batches, processes, [&](std::size_t i) { draw(places, i, batches, figures); });
  std::string text;
  std::size_t done = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    text.append(page, done, places[i].begin - done).append(figures[i]);
    done = places[i].end;
  }
  return text.append(page, done);
}

} // namespace settle::compare::report
