/// \file
/// Reading campaign files, writing them back, and their schema.
#pragma once

#include <filesystem>
#include <string>

#include "settle/compare/campaign.hpp"

namespace settle::compare {

/// Reads and checks a campaign file: keys, types, ranges. Whether its runs and figures make sense together is checked
/// by `expand`. Throws InputError with file:line:column, the value, what is allowed and the nearest spelling.
Campaign read_campaign(const std::filesystem::path& file);

/// The same from text; `name` stands for the file in messages.
Campaign parse_campaign(const std::string& text, const std::string& name);

/// The campaign as TOML with every default filled in.
std::string to_toml(const Campaign& campaign);

/// JSON Schema (draft-07) of campaign files.
std::string campaign_schema();

/// The campaign of one case: a run named after the file, and figures of settlement and vertical stress.
/// `overrides` are `key=value` as given to `--set`. Throws InputError for an override without "=".
Campaign campaign_of_case(const std::filesystem::path& case_file, const std::vector<std::string>& overrides,
                          const std::vector<std::string>& solvers);

/// The campaign of one case's refinement family. `solvers` may be empty: those of which the case expects something.
/// Throws InputError also where the case cannot be read.
Campaign refinement_of_case(const std::filesystem::path& case_file, const std::vector<std::string>& overrides,
                            const std::vector<std::string>& solvers);

} // namespace settle::compare
