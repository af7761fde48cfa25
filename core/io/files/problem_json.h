#pragma once

#include "core/base/issue.h"
#include "core/plan/solve/tvp.h"

#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace berg {

/** Of distances, sigmas and mu: a problem's units are its author's business. */
inline constexpr double kLargestProblemNumber = 1e15;

/** A problem file: one path-planning problem without simulation. */
struct ProblemFile
{
    TvpProblem problem;        ///< `mu` is set: from the file, or from `tau` by the tuning rule
    std::optional<double> tau; ///< as in the file; none when it gives `mu`
    std::vector<Issue> hints;  ///< about members that are not known
};

/** Errors as for `scenarioFromJson`. Without `tau` and `mu`, tau is 1. */
[[nodiscard]] ProblemFile problemFromJson(std::string_view text, const std::string& subject,
                                          const std::stop_token& stop = {});
[[nodiscard]] ProblemFile loadProblem(const std::string& path);

} // namespace berg
