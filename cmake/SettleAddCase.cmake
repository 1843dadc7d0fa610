# settle_add_case: a case of Settle as a test of any project, run by that project's own solver.
#
#   settle_add_case(NAME name CASE case.toml
#     [SOLVER name COMMAND "program {case} {result}" [TITLE title] [KINEMATICS small|finite]]
#     [SOLVERS mpm fem ...]   # run beside it; left out: none where there is a SOLVER, else mpm and fem
#     [TIME_LIMIT seconds]    # of one solver; left out: 600
#     [LABELS label ...])
#
# adds the test "settle: name", which passes where every verdict of the case does. The checks of the case name the
# solver: between = ["name", "exact"]. COMMAND is one text, split into words as docs/adding-a-solver.md says; generator
# expressions are allowed in it, so COMMAND "$<TARGET_FILE:mine> {case} {result}" runs a target of the project.
# Results and report lie in settle/name of the binary folder. With SETTLE_PROGRAM another settle is taken than the target
# Settle::settle of the package or the one in PATH.
function(settle_add_case)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "NAME;CASE;SOLVER;COMMAND;TITLE;KINEMATICS;TIME_LIMIT" "SOLVERS;LABELS")
  foreach(needed NAME CASE)
    if(NOT arg_${needed})
      message(FATAL_ERROR "settle_add_case needs ${needed}")
    endif()
  endforeach()
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "settle_add_case does not know: ${arg_UNPARSED_ARGUMENTS}")
  endif()
  if((arg_SOLVER AND NOT arg_COMMAND) OR (arg_COMMAND AND NOT arg_SOLVER))
    message(FATAL_ERROR "settle_add_case needs both SOLVER and COMMAND, or neither")
  endif()
  get_filename_component(case_file "${arg_CASE}" ABSOLUTE)
  if(NOT EXISTS "${case_file}")
    message(FATAL_ERROR "settle_add_case: there is no case ${case_file}")
  endif()

  string(MAKE_C_IDENTIFIER "${arg_NAME}" folder)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/settle/${folder})
  _settle_campaign_of_case(campaign)
  file(GENERATE OUTPUT ${folder}.toml CONTENT "${campaign}")
  _settle_program(program)
  add_test(NAME "settle: ${arg_NAME}" COMMAND ${program} campaign ${folder}.toml --out ${folder})
  set_tests_properties("settle: ${arg_NAME}" PROPERTIES LABELS "${arg_LABELS}")
endfunction()

# The campaign file of one case. Reads the arguments of settle_add_case.
function(_settle_campaign_of_case result)
  set(text "format = 1\ntitle = '''${arg_NAME}'''\n")
  set(solvers ${arg_SOLVERS})
  if(arg_SOLVER)
    list(PREPEND solvers ${arg_SOLVER})
    string(APPEND text "[solver.${arg_SOLVER}]\ncommand = '''${arg_COMMAND}'''\n")
    if(arg_TITLE)
      string(APPEND text "title = '''${arg_TITLE}'''\n")
    endif()
    if(arg_KINEMATICS)
      string(APPEND text "kinematics = \"${arg_KINEMATICS}\"\n")
    endif()
  endif()
  if(NOT solvers)
    set(solvers mpm fem)
  endif()
  list(JOIN solvers "\", \"" solvers)
  string(APPEND text "[[run]]\nname = '''${arg_NAME}'''\ncase = '''${case_file}'''\nsolvers = [\"${solvers}\"]\n")
  if(arg_TIME_LIMIT)
    string(APPEND text "time_limit = ${arg_TIME_LIMIT}.0\n")
  endif()
  set(${result} "${text}" PARENT_SCOPE)
endfunction()

function(_settle_program result)
  if(SETTLE_PROGRAM)
    set(${result} ${SETTLE_PROGRAM} PARENT_SCOPE)
  elseif(TARGET Settle::settle)
    set(${result} Settle::settle PARENT_SCOPE)
  elseif(TARGET settle)
    set(${result} settle PARENT_SCOPE)
  else()
    find_program(SETTLE_PROGRAM settle REQUIRED DOC "Settle's driver")
    set(${result} ${SETTLE_PROGRAM} PARENT_SCOPE)
  endif()
endfunction()
