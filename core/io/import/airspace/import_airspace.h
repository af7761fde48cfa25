#pragma once

#include "core/io/import/fields/import_table.h"
#include "core/io/text/read_budget.h"
#include "core/scenario/scenario.h"

#include <cstddef>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace berg {

/** An area of an airspace file. */
struct FileAirspace
{
    std::string name;
    std::string kind;                       ///< class, or type if the file has one
    std::vector<std::vector<LatLon>> rings; ///< exterior, as in `SceneArea`
    double floor_m = 0;
    std::optional<double> ceiling_m; ///< nullopt if it is unlimited
    std::string fromUtc;
    std::string untilUtc;
    std::size_t line = 0; ///< line, or number of the feature, from 1
};

/** Content of an airspace file, with its unreadable parts. */
struct AirspaceTable
{
    std::vector<FileAirspace> areas;
    Rejections rejected;
    Rejections noted; ///< areas taken larger than in the file, and other lines
};

/**
 * Returns true if the text begins with an OpenAir record and an area with a height or an outline
 * follows.
 */
[[nodiscard]] bool isOpenAir(std::string_view text);

/**
 * Reads the areas of an OpenAir text (after Naviter's description, 2.1): `AC`, `AY`, `AN`, `AL`,
 * `AH`, `AA`, `V`, `DP`, `DC`, `DA`, `DB`, `DY`; lines about colours, radio and the like are
 * skipped. An area ends where the next begins: at an `AC`, or at an `AN` if it has a name or an
 * outline. Lines end with LF, CR or both. Heights without a unit are feet, those above ground count
 * from the sea, flight levels are those of the standard atmosphere; a height that is missing or not
 * understood makes the area reach down to the sea or up without limit, and is noted. An area whose
 * outline cannot be read completely is rejected with its line.
 */
[[nodiscard]] AirspaceTable readOpenAir(std::string_view text, ReadBudget& budget);

/** End of an area that a height limits. */
enum class HeightLimit
{
    Floor,
    Ceiling
};

/**
 * Returns the height in metres above the sea of "FL 65", "65 FL", "3 500 ft AMSL", "500M AGL",
 * "GND"; HUGE_VAL for "UNL". Of several heights ("2000 MSL / 1000 AGL") it is the lowest floor or
 * the highest ceiling. Returns nullopt if a part of the text is not understood.
 */
[[nodiscard]] std::optional<double> airspaceHeight_m(std::string_view given, HeightLimit limit);

/** Result of an import of airspace. */
struct AirspaceResult
{
    Scenario scenario;
    std::size_t added = 0;
    std::size_t known = 0;   ///< number of areas that the scenario has already
    std::size_t far = 0;     ///< number of areas more than `kNearAirspace_m` from the operation
    std::size_t tooMany = 0; ///< number of areas beyond `kMostAirspaceAreas` of a scenario
    Rejections notNeeded;    ///< the areas that are far or too many
    Rejections rejected;     ///< unreadable areas, and those whose outline encloses nothing
    Rejections noted;        ///< areas taken larger than in the file, and lines not understood
};

/** Largest distance of imported airspace from the operation. */
inline constexpr double kNearAirspace_m = 100'000;

/**
 * Returns the scenario with the airspace of the file's bytes that is near the operation
 * (`operationVolume`). The content decides between OpenAir, GeoJSON, KML, KMZ and CZML. Throws
 * `Error`: FileTooLarge (`ReadBudget`), WrongFormat for any other bytes, SyntaxError for broken
 * JSON or XML and InvalidInput if there is no area; `Stopped` if a stop is requested.
 */
[[nodiscard]] AirspaceResult importAirspace(const Scenario& base, std::string_view bytes,
                                            const std::string& subject,
                                            const std::stop_token& stop = {});

/** Returns the JSON document that the command line prints for an import of airspace. */
[[nodiscard]] std::string airspaceJson(const AirspaceResult& result);

} // namespace berg
