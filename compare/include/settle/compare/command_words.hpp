/// \file
/// A command line as a list of words, and back: quoting as a POSIX shell has it, and nothing else of a shell.
#pragma once

#include <string>
#include <vector>

namespace settle::compare {

/// The words of a command: blanks part them; 'single quotes', "double quotes" and backslashes keep them together.
/// Nothing is expanded. Throws InputError located at `where` for a quote that is not closed, and for an operator of a
/// shell (|, >, &&, ...), which would otherwise be handed to the program as a word.
std::vector<std::string> split_command(const std::string& command, const std::string& where);

/// A word quoted for a POSIX shell where it is not made of harmless characters.
std::string quoted(const std::string& word);

/// The words as one line that `split_command` and a shell part into them again.
std::string joined(const std::vector<std::string>& words);

} // namespace settle::compare
