/// \file
/// The texts of compare/templates, put into the library when it is built (EmbedTemplates.cmake).
#pragma once

namespace settle::compare::report::templates {

extern const char* const page;
extern const char* const style;
extern const char* const script;
extern const char* const table;
extern const char* const figure;
extern const char* const chart;
extern const char* const fields;
extern const char* const formulas;
extern const char* const run;
extern const char* const published;
extern const char* const family;

} // namespace settle::compare::report::templates
