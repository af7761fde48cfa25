#pragma once

#include "core/base/issue.h"
#include "core/plan/problem/tvp.h"

#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace berg {

/** Limit of distances, sigmas and mu, which have the units of the file's author. */
inline constexpr double kLargestProblemNumber = 1e15;
/** Largest number of nodes, including the UAV; a matrix of this size takes 8 MB. */
inline constexpr std::size_t kMostProblemNodes = 1000;

/** A path-planning problem without simulation, read from a problem file or a TSPLIB file. */
struct ProblemFile
{
    TvpProblem problem;        ///< always has `mu`, from the file or from `tau` by the tuning rule
    std::optional<double> tau; ///< tau of the file; nullopt if it gives `mu`
    std::vector<Issue> hints;  ///< hints about unknown members
    bool isTsplib = false;     ///< numbers nodes from 1 including the start, as TSPLIB does
};

/**
 * Reads a problem file; tau is 1 if it gives neither `tau` nor `mu`. Throws as `scenarioFromJson`.
 */
[[nodiscard]] ProblemFile problemFromJson(std::string_view text, const std::string& subject,
                                          const std::stop_token& stop = {});
/**
 * Reads a problem in Bergwatch's format or, if `isTsplib`, in that of TSPLIB; throws as their
 * readers.
 */
[[nodiscard]] ProblemFile problemFromText(std::string_view text, const std::string& subject,
                                          const std::stop_token& stop = {});
/** Reads a problem file from `path`; throws as `readFile` and `problemFromText`. */
[[nodiscard]] ProblemFile loadProblem(const std::string& path);

} // namespace berg
