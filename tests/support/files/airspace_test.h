#pragma once

#include "core/io/import/airspace/import_airspace.h"
#include "tests/support/flight/scenario_builder.h"

#include <stdexcept>
#include <string>
#include <string_view>

namespace berg::test {

inline AirspaceResult readAirspace(const std::string& text, const Scenario& base = emptySea())
{
    return importAirspace(base, text, "file");
}

/** Returns the area with this name, which must exist. */
inline const AirspaceArea& airspaceNamed(const Scenario& scenario, std::string_view name)
{
    for (const AirspaceArea& area : scenario.airspace)
        if (area.name == name)
            return area;
    throw std::logic_error("no airspace " + std::string(name));
}

/** Returns line and reason of each row. */
inline std::string rowsSaid(const Rejections& rows)
{
    std::string text;
    for (const RejectedRow& row : rows.first)
        text += std::to_string(row.line) + ' ' + englishText(reasonOf(row)) + '\n';
    return text;
}

} // namespace berg::test
