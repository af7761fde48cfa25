#pragma once

#include "core/io/import/import_table.h"
#include "core/io/text/read_budget.h"
#include "core/scenario/scenario.h"

#include <cstddef>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace berg {

/** An area of a file of airspace. */
struct FileAirspace
{
    std::string name;
    std::string kind;                       ///< class, or type where the file has one
    std::vector<std::vector<LatLon>> rings; ///< exterior, as in `SceneArea`
    double floor_m = 0;
    std::optional<double> ceiling_m; ///< none: without end
    std::string fromUtc;
    std::string untilUtc;
    std::size_t line = 0; ///< or feature, from 1
};

/** What a file of airspace holds, and what of it nobody can read. */
struct AirspaceTable
{
    std::vector<FileAirspace> areas;
    Rejections rejected;
};

/** Whether the text has lines of OpenAir at its start, after comments. */
[[nodiscard]] bool isOpenAir(std::string_view text);

/**
 * Areas of an OpenAir text (after Naviter's description, 2.1): `AC`, `AY`, `AN`, `AL`, `AH`, `AA`,
 * `V`, `DP`, `DC`, `DA`, `DB`; other lines are skipped. Lenient: an area ends where the next
 * begins; heights without a unit are feet, those above ground count from the sea, flight levels are
 * those of the standard atmosphere; a height that is not understood makes the area reach down to
 * the sea, or up without end. An area with a place that cannot be read is rejected with its line.
 */
[[nodiscard]] AirspaceTable readOpenAir(std::string_view text, ReadBudget& budget);

/** Metres above the sea of "FL 65", "1500 ft AMSL", "500M AGL", "GND"; HUGE_VAL of "UNL"; none of
 * what is no height. */
[[nodiscard]] std::optional<double> airspaceHeight_m(std::string_view given);

struct AirspaceResult
{
    Scenario scenario;
    std::size_t added = 0;
    std::size_t known = 0;   ///< there already
    std::size_t far = 0;     ///< more than `kNearAirspace_m` from where is flown
    std::size_t tooMany = 0; ///< a scenario holds `kMostAirspaceAreas`
    Rejections rejected;     ///< unreadable, or outlines that touch or cross themselves
};

inline constexpr double kNearAirspace_m = 100'000;

/**
 * The scenario with the airspace of the file's bytes that is near the operation
 * (`operationVolume`), OpenAir or GeoJSON by their content. Throws as `readSightings`; NoAirspace
 * where no area is found.
 */
[[nodiscard]] AirspaceResult importAirspace(const Scenario& base, std::string_view bytes,
                                            const std::string& subject,
                                            const std::stop_token& stop = {});

} // namespace berg
