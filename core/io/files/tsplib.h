#pragma once

#include "core/io/files/problem_json.h"

namespace berg {

/**
 * Returns true if a file is in the format of TSPLIB: it has the name ending .tsp or .atsp, or its
 * first line that is not blank or a comment begins with a keyword of the format.
 */
[[nodiscard]] bool isTsplib(std::string_view text, std::string_view path);

/**
 * Reads a travelling-salesman instance, symmetric or asymmetric (G. Reinelt, TSPLIB 95, and its
 * questions and answers for GEO). Weights are those of EUC_2D, CEIL_2D, ATT and GEO, whole numbers,
 * or EXPLICIT in a full matrix or a triangle of one by rows or columns. Entries and sections may
 * come in any order, lines may end with CR, LF or both; a line that begins with # is a comment, and
 * EOF may be missing.
 *
 * The start is node 1. All uncertainties are zero, so the problem is the shortest round tour (mu =
 * 1, closed); `latencyProblem` turns it into a latency problem.
 *
 * Throws `Error` with a field such as `line 7, DIMENSION`: SyntaxError for a line that is neither
 * an entry nor part of a section, WrongFormat for UTF-16, FileTooLarge (`ReadBudget`), InvalidInput
 * otherwise; `Stopped` if a stop is requested. Nodes and numbers have the limits of Bergwatch's own
 * problem files.
 */
[[nodiscard]] ProblemFile problemFromTsplib(std::string_view text, const std::string& subject,
                                            const std::stop_token& stop = {});

} // namespace berg
