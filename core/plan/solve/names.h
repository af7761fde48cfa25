#pragma once

#include "core/plan/solve/solver.h"

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace berg {

/** A value and its name in files and on the command line, or its text. */
template <class Enum>
struct Named
{
    Enum value;
    std::string_view name;
};

/** Names of the enumerators; `kStatusNames` and `kSourceNames` appear in results only. */
inline constexpr std::array<Named<Route>, 2> kRouteNames{{
    {Route::Open, "open"},
    {Route::Closed, "closed"},
}};

inline constexpr std::array<Named<Criterion>, 2> kCriterionNames{{
    {Criterion::Visitation, "visitation"},
    {Criterion::Latency, "latency"},
}};

inline constexpr std::array<Named<Backend>, 4> kBackendNames{{
    {Backend::Auto, "auto"},
    {Backend::Exact, "exact"},
    {Backend::Cbc, "cbc"},
    {Backend::Heuristic, "heuristic"},
}};

inline constexpr std::array<Named<Formulation>, 3> kFormulationNames{{
    {Formulation::Position, "position"},
    {Formulation::Printed, "printed"},
    {Formulation::Reduced, "reduced"},
}};

inline constexpr std::array<Named<SolveStatus>, 3> kStatusNames{{
    {SolveStatus::Optimal, "optimal"},
    {SolveStatus::Feasible, "feasible"},
    {SolveStatus::None, "none"},
}};

inline constexpr std::array<Named<AnswerSource>, 10> kSourceNames{{
    {AnswerSource::None, ""},
    {AnswerSource::Auto, "auto"},
    {AnswerSource::Exact, "exact"},
    {AnswerSource::Heuristic, "heuristic"},
    {AnswerSource::Cbc, "cbc"},
    {AnswerSource::Subsets, "subsets"},
    {AnswerSource::Assignment, "assignment"},
    {AnswerSource::OneByOne, "greedy"},
    {AnswerSource::KeptRoute, "route"},
    {AnswerSource::Coverage, "coverage"},
}};

/** Returns the name of a value, or an empty string if the table does not hold it. */
template <class Table, class Enum>
[[nodiscard]] std::string nameOf(const Table& table, Enum value)
{
    for (const auto& row : table)
        if (row.value == value)
            return std::string(row.name);
    return {};
}

/** Returns the value of a name, or nullopt if the table does not hold it. */
template <class Enum, std::size_t Size>
[[nodiscard]] std::optional<Enum> valueOf(const std::array<Named<Enum>, Size>& table,
                                          std::string_view name)
{
    for (const auto& row : table)
        if (row.name == name)
            return row.value;
    return std::nullopt;
}

/** Returns the texts that `text` gives for the elements of a list, joined with `separator`. */
template <class List, class Text = std::identity>
[[nodiscard]] std::string joined(const List& list, std::string_view separator, Text text = {})
{
    std::string all;
    std::string_view before;
    for (const auto& one : list) {
        all.append(before).append(std::invoke(text, one));
        before = separator;
    }
    return all;
}

/** Returns the allowed names for a message, such as "open, closed". */
template <class Table>
[[nodiscard]] std::string allowedNames(const Table& table)
{
    return joined(table, ", ", [](const auto& row) { return row.name; });
}

} // namespace berg
