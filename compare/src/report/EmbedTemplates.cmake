# Script mode: writes OUTPUT, a C++ source with the text of FOLDER/NAME.mustache for each of NAMES.
set(source "#include \"templates.hpp\"\n\nnamespace settle::compare::report::templates {\n")
foreach(name IN LISTS NAMES)
  file(READ ${FOLDER}/${name}.mustache text)
  string(APPEND source "const char* const ${name} = R\"template(${text})template\";\n")
endforeach()
string(APPEND source "} // namespace settle::compare::report::templates\n")
file(WRITE ${OUTPUT} "${source}")
