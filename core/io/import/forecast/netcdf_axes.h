#pragma once

#include "core/io/import/forecast/cf_time.h"
#include "core/io/import/forecast/grid_layers.h"
#include "core/io/import/forecast/netcdf_file.h"
#include "core/io/text/read_budget.h"

#include <optional>
#include <string>
#include <vector>

namespace berg {

/** Position of a level among those of a variable. */
struct NetcdfLevel
{
    std::size_t dimension = 0; ///< position in `NetcdfVariable::dimensions`
    std::size_t index = 0;
};

/** Meaning of the dimensions of a variable, as positions in `NetcdfVariable::dimensions`. */
struct NetcdfAxes
{
    const NetcdfVariable* latitude = nullptr;
    const NetcdfVariable* longitude = nullptr;
    std::optional<std::size_t> row;    ///< nullopt if there is one row only
    std::optional<std::size_t> column; ///< nullopt if there is one column only
    const NetcdfVariable* time = nullptr;
    std::optional<std::size_t> instant;  ///< nullopt if the variable has one time or none
    std::vector<NetcdfLevel> levels;     ///< of all other dimensions
    std::optional<double> levelOffset_m; ///< distance of the level from the wanted height
};

/** Reads coordinates of a NetCDF file after the CF conventions. */
class NetcdfAxisReader
{
public:
    NetcdfAxisReader(const NetcdfFile& file, ReadBudget& budget) : m_file(file), m_budget(budget) {}

    /**
     * Returns the axes of a variable, or nullopt if it has no place on the Earth, or is on levels
     * of pressure or of a model, which are not at the sea.
     */
    [[nodiscard]] std::optional<NetcdfAxes> axesOf(const NetcdfVariable& variable,
                                                   double wanted_m) const;
    /** Returns the grid of such axes. Throws `Error{FileTooLarge}`. */
    [[nodiscard]] SourceGrid gridOf(const NetcdfVariable& variable, const NetcdfAxes& axes) const;
    /** Returns the times of a variable. Throws `Error{InvalidInput}` if they do not rise. */
    [[nodiscard]] std::vector<ForecastTime> timesOf(const NetcdfVariable& time) const;
    /** Returns the numbers of a coordinate. Throws `Error{FileTooLarge}` for too many. */
    [[nodiscard]] std::vector<double> valuesOf(const NetcdfVariable& variable) const;
    /** Returns a text attribute, "" if there is none. */
    [[nodiscard]] std::string attribute(const NetcdfVariable& variable, const char* name) const;
    [[nodiscard]] const NetcdfVariable* variableNamed(std::string_view name) const;

private:
    [[nodiscard]] bool isLatitude(const NetcdfVariable& variable) const;
    [[nodiscard]] bool isLongitude(const NetcdfVariable& variable) const;
    [[nodiscard]] bool isTime(const NetcdfVariable& variable) const;
    /** Variables that may hold coordinates of another: named by it, then its dimensions' own. */
    [[nodiscard]] std::vector<const NetcdfVariable*>
    coordinatesOf(const NetcdfVariable& variable) const;
    [[nodiscard]] bool place(const NetcdfVariable& variable, NetcdfAxes& axes) const;
    [[nodiscard]] bool placeBy(const NetcdfVariable& variable, NetcdfAxes& axes) const;
    [[nodiscard]] bool chooseLevels(const NetcdfVariable& variable, double wanted_m,
                                    NetcdfAxes& axes) const;
    [[nodiscard]] std::size_t sizeOf(const NetcdfVariable& variable) const;

    const NetcdfFile& m_file;
    ReadBudget& m_budget;
};

} // namespace berg
