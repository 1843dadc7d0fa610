// The only place where mustache renders: its header, inlined, sets off -Wnull-dereference (see CMakeLists.txt).
#include "html_table.hpp"

namespace settle::compare::report {

std::string render(const char* text, const data& values) {
  return kainjow::mustache::mustache(text).render(values);
}

} // namespace settle::compare::report
