#include <sstream>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "format.hpp"
#include "reported_verdicts.hpp"

namespace settle::compare {

namespace {

void set(pugi::xml_node node, const char* name, const std::string& value) {
  node.append_attribute(name).set_value(report::printable(value).c_str());
}

/// tests, failures and errors of a suite; missing counts as error.
void set_counts(pugi::xml_node node, const std::vector<Verdict>& verdicts) {
  const std::map<Status, int> counts = report::count(verdicts);
  node.append_attribute("tests").set_value(static_cast<unsigned long long>(verdicts.size()));
  node.append_attribute("failures").set_value(counts.at(Status::failed));
  node.append_attribute("errors").set_value(counts.at(Status::missing) + counts.at(Status::error));
}

std::string details(const Verdict& verdict) {
  std::string text = verdict.message;
  if (const std::string band = report::accepted_band(verdict); !band.empty()) {
    text += fmt::format("\nvalue: {}, accepted: {}", report::value_text(verdict, verdict.value), band);
  }
  if (!verdict.scale.empty()) text += "\nrelative to: " + verdict.scale;
  if (!verdict.why.empty()) text += "\nwhy: " + verdict.why;
  return report::printable(text);
}

void append_problem(pugi::xml_node test, const char* element, const Verdict& verdict) {
  pugi::xml_node problem = test.append_child(element);
  set(problem, "type", std::string(name_of(verdict.status)));
  set(problem, "message", verdict.message);
  problem.text().set(details(verdict).c_str());
}

void append_test(pugi::xml_node suite, const Verdict& verdict) {
  pugi::xml_node test = suite.append_child("testcase");
  set(test, "name", verdict.what);
  set(test, "classname", verdict.run + "." + verdict.kind);
  switch (verdict.status) {
  case Status::passed:
    return;
  case Status::failed:
    append_problem(test, "failure", verdict);
    return;
  case Status::missing:
  case Status::error:
    append_problem(test, "error", verdict);
    return;
  }
}

double wall_time(const RunOutcome& run) {
  double sum = 0.0;
  for (const SolverRun& solver : run.solvers)
    sum += solver.wall_time;
  return sum;
}

void append_suite(pugi::xml_node suites, const std::string& name, const std::vector<Verdict>& verdicts, double time) {
  pugi::xml_node suite = suites.append_child("testsuite");
  set(suite, "name", name);
  set_counts(suite, verdicts);
  set(suite, "time", fmt::format("{:.3f}", time));
  for (const Verdict& verdict : verdicts)
    append_test(suite, verdict);
}

} // namespace

std::string junit_xml(const CampaignOutcome& outcome) {
  pugi::xml_document document;
  pugi::xml_node suites = document.append_child("testsuites");
  set(suites, "name", outcome.campaign.title);
  set_counts(suites, report::all_verdicts(outcome));
  for (const Family& family : outcome.families)
    append_suite(suites, family.name, family.verdicts, 0.0); // its solvers' time is that of its runs
  for (const RunOutcome& run : outcome.runs)
    append_suite(suites, run.name, reported_verdicts(run), wall_time(run));
  std::ostringstream text;
  document.save(text, "  ");
  return text.str();
}

} // namespace settle::compare
