# Manual pages and completions for bash, zsh and fish, made from the --help of the programs that were just built.

# settle_add_text(FILE DESTINATION PROGRAM COMMAND...): a file that a script prints about a program.
function(settle_add_text file destination program)
  set(output ${CMAKE_CURRENT_BINARY_DIR}/${file})
  add_custom_command(OUTPUT ${output}
    COMMAND ${SETTLE_PYTHON} -B ${ARGN} > ${output}
    DEPENDS ${program} settle help_text.py manual_page.py completion.py
    WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} VERBATIM)
  install(FILES ${output} DESTINATION ${destination})
  set_property(DIRECTORY APPEND PROPERTY settle_texts ${output})
endfunction()

foreach(program IN LISTS programs)
  settle_add_text(${program}.1 ${CMAKE_INSTALL_MANDIR}/man1 ${program} manual_page.py $<TARGET_FILE:${program}>)
  foreach(shell_file bash:bash-completion/completions/${program} zsh:zsh/vendor-completions/_${program}
          fish:fish/vendor_completions.d/${program}.fish)
    string(REGEX MATCH "([a-z]+):(.+)/(.+)" _ ${shell_file})
    set(shell ${CMAKE_MATCH_1})
    set(folder ${CMAKE_INSTALL_DATADIR}/${CMAKE_MATCH_2})
    file(MAKE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/${shell})
    settle_add_text(${shell}/${CMAKE_MATCH_3} ${folder} ${program}
      completion.py ${shell} $<TARGET_FILE:${program}> $<TARGET_FILE:settle>)
  endforeach()
endforeach()
get_property(texts DIRECTORY PROPERTY settle_texts)
add_custom_target(settle-manuals ALL DEPENDS ${texts})
