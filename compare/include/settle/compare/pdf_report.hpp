/// \file
/// The page on paper.
#pragma once

#include <filesystem>
#include <string>

#include "settle/compare/outcome.hpp"

namespace settle::compare {

/// A browser that prints pages: the program that is named, or that SETTLE_BROWSER names, or the first of chromium,
/// chromium-browser, google-chrome, google-chrome-stable in PATH; empty where there is none.
std::filesystem::path find_browser(const std::string& named = "");

/// Has a browser of the Chromium family print the page into `file`, which is replaced as a whole. The same outcome
/// printed by the same browser gives the same bytes: the dates inside are those of the outcome. Throws FileError where
/// there is no browser, or it fails.
void write_pdf(const CampaignOutcome& outcome, const std::filesystem::path& file, const std::string& browser,
               int jobs = 0);

} // namespace settle::compare
