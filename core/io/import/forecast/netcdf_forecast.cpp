#include "core/io/import/forecast/netcdf_forecast.h"

#include "core/base/error.h"
#include "core/io/import/forecast/cf_names.h"
#include "core/io/import/forecast/grid_resampling.h"
#include "core/io/import/forecast/netcdf_axes.h"
#include "core/io/import/forecast/netcdf_bands.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

namespace berg {

namespace {

/** How values in the file become numbers. */
struct PackedValues
{
    std::vector<double> missing;                           ///< values in the file that mean none
    double low = -std::numeric_limits<double>::infinity(); ///< valid values in the file
    double high = std::numeric_limits<double>::infinity();
    double scale = 1;
    double offset = 0;
    double wrap = 0; ///< added to negative values of an unsigned type
    UnitScale unit;

    [[nodiscard]] double unpacked(double value) const
    {
        if (wrap > 0 && value < 0)
            value += wrap;
        if (!(value >= low && value <= high) || std::abs(value) > 1e30 ||
            std::ranges::find(missing, value) != missing.end())
            return std::numeric_limits<double>::quiet_NaN();
        return (value * scale + offset) * unit.scale + unit.offset;
    }
};

/** A variable that holds a number of a forecast at one time. */
struct NetcdfBand
{
    const NetcdfVariable* variable = nullptr;
    GribBand content;
    PackedValues packed;
};

/** A variable that holds a number of a forecast. */
struct NetcdfCandidate
{
    const NetcdfVariable* variable = nullptr;
    NetcdfAxes axes;
    PackedValues packed;
    bool byStandardName = false;
    /** If not empty, the variables of its times in place of `variable`, which is one of them. */
    std::map<ForecastTime, NetcdfBand> bands;
};

/** Returns true if the first describes the number better. */
bool isBetter(const NetcdfCandidate& a, const NetcdfCandidate& b)
{
    const auto rank = [](const NetcdfCandidate& candidate) {
        return std::tuple(candidate.axes.levelOffset_m.value_or(0.5), !candidate.byStandardName,
                          candidate.axes.levels.size());
    };
    return rank(a) < rank(b);
}

/** A NetCDF file as forecasts on grids. */
class NetcdfSource final : public GridSource
{
public:
    NetcdfSource(std::string_view bytes, ReadBudget& budget)
        : m_file(bytes, budget.subject()), m_budget(budget), m_axes(m_file, budget)
    {
        for (const NetcdfVariable& variable : m_file.variables())
            consider(variable);
        for (const auto& [number, candidate] : m_candidates)
            addLayer(number, candidate);
        const bool hasQuantity = std::ranges::any_of(
            m_layers, [](const GridLayer& layer) { return !layer.times.empty(); });
        if (!hasQuantity)
            throw Error(ErrorCode::InvalidInput, m_file.subject(), {IssueId::NoQuantity});
        readTexts();
    }

    [[nodiscard]] const std::vector<SourceGrid>& grids() const override { return m_grids; }
    [[nodiscard]] const std::vector<GridLayer>& layers() const override { return m_layers; }
    [[nodiscard]] std::string source() const override { return m_source; }
    [[nodiscard]] std::optional<ForecastTime> issued() const override { return m_issued; }

    [[nodiscard]] std::vector<double> read(const GridLayer& layer, std::size_t first,
                                           std::size_t count, const GridWindow& window) override
    {
        const NetcdfCandidate& from = m_candidates.at(layer.number);
        if (from.bands.empty())
            return readOne(*from.variable, from.axes, from.packed, layer.times.empty() ? 0 : first,
                           count, window);
        std::vector<double> values;
        for (std::size_t t = first; t < first + count; ++t) {
            const NetcdfBand& band = from.bands.at(layer.times.at(t));
            const std::vector<double> now =
                readOne(*band.variable, from.axes, band.packed, 0, 1, window);
            values.insert(values.end(), now.begin(), now.end());
        }
        return values;
    }

private:
    [[nodiscard]] std::vector<double> readOne(const NetcdfVariable& variable,
                                              const NetcdfAxes& axes, const PackedValues& packed,
                                              std::size_t first, std::size_t count,
                                              const GridWindow& window) const
    {
        std::vector<std::size_t> start(variable.dimensions.size());
        std::vector<std::size_t> sizes(start.size(), 1);
        for (const NetcdfLevel& level : axes.levels)
            start[level.dimension] = level.index;
        const auto set = [&](const std::optional<std::size_t>& at, std::size_t begin,
                             std::size_t size) {
            if (!at)
                return;
            start[*at] = begin;
            sizes[*at] = size;
        };
        set(axes.instant, first, count);
        set(axes.row, window.firstRow, window.rows);
        set(axes.column, window.firstColumn, window.columns);
        const std::vector<double> raw = m_file.read(variable, start, sizes);
        // Dimensions may be in any order.
        const auto stepOf = [&](const std::optional<std::size_t>& at) {
            std::size_t step = at ? 1 : 0;
            for (std::size_t i = at ? *at + 1 : sizes.size(); i < sizes.size(); ++i)
                step *= sizes[i];
            return step;
        };
        const std::size_t byInstant = stepOf(axes.instant);
        const std::size_t byRow = stepOf(axes.row);
        const std::size_t byColumn = stepOf(axes.column);
        std::vector<double> values;
        values.reserve(count * window.rows * window.columns);
        for (std::size_t t = 0; t < count; ++t)
            for (std::size_t r = 0; r < window.rows; ++r)
                for (std::size_t c = 0; c < window.columns; ++c)
                    values.push_back(
                        packed.unpacked(raw[t * byInstant + r * byRow + c * byColumn]));
        return values;
    }

    void consider(const NetcdfVariable& variable)
    {
        m_budget.throwIfStopped();
        if (!variable.isNumeric)
            return;
        if (isBand(m_file, variable)) {
            considerBand(variable);
            return;
        }
        const std::string standard = m_axes.attribute(variable, "standard_name");
        std::optional<GridNumber> number = numberOfStandardName(standard);
        const bool byStandardName = number.has_value();
        if (!number && standard.empty())
            number = numberOfVariableName(variable.name);
        if (!number)
            number = numberOfRoms(variable);
        if (!number)
            return;
        const std::optional<NetcdfAxes> axes = m_axes.axesOf(variable, wantedLevel_m(*number));
        if (!axes)
            return;
        const NetcdfCandidate candidate{
            .variable = &variable, .axes = *axes, .packed = {}, .byStandardName = byStandardName};
        const auto known = m_candidates.find(*number);
        if (known == m_candidates.end())
            m_candidates.emplace(*number, candidate);
        else if (isBetter(candidate, known->second))
            known->second = candidate;
    }

    /** Adds a band, of one time and level the nearer one; all bands of a number share one grid. */
    void considerBand(const NetcdfVariable& variable)
    {
        const std::optional<GribBand> band = gribBandOf(m_file, variable);
        if (!band)
            return;
        const std::optional<NetcdfAxes> axes = m_axes.axesOf(variable, wantedLevel_m(band->number));
        // In other projections it is not known whether the components are along the grid.
        if (!axes || axes->latitude->dimensions.size() != 1)
            return;
        const auto [known, isFirst] = m_candidates.try_emplace(
            band->number, NetcdfCandidate{.variable = &variable, .axes = *axes, .packed = {}});
        NetcdfCandidate& candidate = known->second;
        if ((!isFirst && candidate.bands.empty()) || candidate.axes.latitude != axes->latitude ||
            candidate.axes.longitude != axes->longitude)
            return;
        const auto [at, isNew] = candidate.bands.try_emplace(band->time);
        if (isNew || band->levelOffset_m < at->second.content.levelOffset_m)
            at->second = {.variable = &variable, .content = *band, .packed = {}};
        if (band->issued && (!m_issued || *band->issued < *m_issued))
            m_issued = band->issued;
    }

    /** The names of ROMS's velocities are too short to be anybody's. */
    [[nodiscard]] std::optional<GridNumber> numberOfRoms(const NetcdfVariable& variable) const
    {
        if (m_axes.attribute(variable, "long_name").find("momentum component") == std::string::npos)
            return std::nullopt;
        if (variable.name == "u")
            return GridNumber::CurrentAlongX;
        return variable.name == "v" ? std::optional(GridNumber::CurrentAlongY) : std::nullopt;
    }

    void addLayer(GridNumber number, const NetcdfCandidate& candidate)
    {
        NetcdfCandidate& kept = m_candidates.at(number);
        if (candidate.bands.empty())
            kept.packed = packedOf(number, *candidate.variable,
                                   m_axes.attribute(*candidate.variable, "units"));
        for (auto& [time, band] : kept.bands)
            band.packed = packedOf(number, *band.variable, band.content.unit);
        GridLayer layer{.number = number,
                        .grid = gridNumberOf(candidate),
                        .name = candidate.variable->name,
                        .times = {}};
        const bool isConstant = number == GridNumber::Depth || number == GridNumber::AngleOfX;
        for (const auto& [time, band] : candidate.bands)
            layer.times.push_back(time);
        if (!isConstant && candidate.bands.empty() && candidate.axes.time != nullptr)
            layer.times = timesOf(*candidate.axes.time);
        if (isConstant || !layer.times.empty())
            m_layers.push_back(std::move(layer));
    }

    std::size_t gridNumberOf(const NetcdfCandidate& candidate)
    {
        const std::tuple key(candidate.axes.latitude, candidate.axes.longitude);
        const auto known = m_gridNumbers.find(key);
        if (known != m_gridNumbers.end())
            return known->second;
        m_grids.push_back(m_axes.gridOf(*candidate.variable, candidate.axes));
        m_gridNumbers.emplace(key, m_grids.size() - 1);
        return m_grids.size() - 1;
    }

    const std::vector<ForecastTime>& timesOf(const NetcdfVariable& time)
    {
        const auto known = m_times.find(&time);
        return known != m_times.end() ? known->second
                                      : m_times.emplace(&time, m_axes.timesOf(time)).first->second;
    }

    [[nodiscard]] PackedValues packedOf(GridNumber number, const NetcdfVariable& variable,
                                        const std::string& text) const
    {
        PackedValues packed;
        const std::optional<UnitScale> unit = unitScale(number, text);
        if (!unit)
            throw Error(ErrorCode::InvalidInput, m_file.subject(),
                        {{Severity::Error,
                          variable.name,
                          {IssueId::UnitUnknown, {text, unitNames(number)}}}});
        packed.unit = *unit;
        const auto attribute = [&](const char* name, double& value) {
            if (const std::vector<double> numbers = m_file.numbers(variable, name);
                !numbers.empty())
                value = numbers[0];
        };
        attribute("scale_factor", packed.scale);
        attribute("add_offset", packed.offset);
        if (!std::isfinite(packed.scale) || !std::isfinite(packed.offset))
            throw Error(
                ErrorCode::InvalidInput, m_file.subject(),
                {{Severity::Error,
                  variable.name + (std::isfinite(packed.scale) ? ":add_offset" : ":scale_factor"),
                  {IssueId::NotFinite}}});
        attribute("valid_min", packed.low);
        attribute("valid_max", packed.high);
        if (const std::vector<double> range = m_file.numbers(variable, "valid_range");
            range.size() == 2) {
            packed.low = range[0];
            packed.high = range[1];
        }
        packed.missing = m_file.numbers(variable, "_FillValue");
        if (packed.missing.empty() && variable.defaultFill)
            packed.missing.push_back(*variable.defaultFill);
        for (const double value : m_file.numbers(variable, "missing_value"))
            packed.missing.push_back(value);
        if (m_axes.attribute(variable, "_Unsigned") == "true")
            packed.wrap = std::ldexp(1.0, static_cast<int>(8 * variable.valueBytes));
        return packed;
    }

    void readTexts()
    {
        for (const char* const name : {"title", "source", "institution", "model"})
            if (m_source.empty())
                m_source = cleanedText(m_file.text(nullptr, name).value_or(""));
        if (m_source.empty())
            m_source = "NetCDF";
        for (const NetcdfVariable& variable : m_file.variables())
            if (variable.isNumeric && variable.dimensions.size() <= 1 &&
                (variable.name == "forecast_reference_time" ||
                 m_axes.attribute(variable, "standard_name") == "forecast_reference_time"))
                if (const std::vector<ForecastTime>& times = timesOf(variable); !times.empty())
                    m_issued = times.front();
        for (const char* const name :
             {"forecast_reference_time", "bulletin_date", "forecast_date", "analysis_time",
              "reference_time", "run_time", "model_run_time"})
            if (!m_issued)
                m_issued = timeOfText(m_file.text(nullptr, name).value_or(""));
    }

    /** Returns at most 200 printable characters of a text. */
    static std::string cleanedText(const std::string& text)
    {
        std::string clean;
        for (const char c : text)
            if (static_cast<unsigned char>(c) < 0x7f && clean.size() < 200)
                clean += c < ' ' ? ' ' : c;
        clean.erase(clean.find_last_not_of(' ') + 1);
        clean.erase(0, clean.find_first_not_of(' '));
        return clean;
    }

    /** Returns the time of "2026-05-01 06:00:00" in any of its forms, or of "20260501". */
    static std::optional<ForecastTime> timeOfText(std::string text)
    {
        const bool isCompact =
            text.size() >= 8 && text.find_first_not_of("0123456789") == std::string::npos;
        if (isCompact)
            text = text.substr(0, 4) + '-' + text.substr(4, 2) + '-' + text.substr(6, 2) + ' ' +
                   (text.size() >= 10 ? text.substr(8, 2) : std::string("00"));
        const std::optional<CfTimeUnit> unit =
            text.empty() ? std::nullopt : cfTimeUnit("seconds since " + text, "");
        return unit ? cfTime(*unit, 0) : std::nullopt;
    }

    NetcdfFile m_file;
    ReadBudget& m_budget;
    NetcdfAxisReader m_axes;
    std::map<GridNumber, NetcdfCandidate> m_candidates;
    std::map<std::tuple<const NetcdfVariable*, const NetcdfVariable*>, std::size_t> m_gridNumbers;
    std::map<const NetcdfVariable*, std::vector<ForecastTime>> m_times;
    std::vector<SourceGrid> m_grids;
    std::vector<GridLayer> m_layers;
    std::string m_source;
    std::optional<ForecastTime> m_issued;
};

} // namespace

bool readsNetcdf()
{
    return true;
}

ForecastReading netcdfForecast(std::string_view bytes, const ForecastReadOptions& options,
                               ReadBudget& budget, const ForecastProgress& progress,
                               const std::stop_token& stop)
{
    NetcdfSource source(bytes, budget);
    ForecastReading reading = resampled(source, options, budget, progress, stop);
    reading.format = "NetCDF";
    return reading;
}

} // namespace berg
