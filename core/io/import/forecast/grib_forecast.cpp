#include "core/io/import/forecast/grib_forecast.h"

#include "core/base/error.h"
#include "core/io/import/forecast/grid_resampling.h"
#include "core/io/import/forecast/grid_sampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <eccodes.h>
#include <limits>
#include <map>
#include <memory>
#include <tuple>
#include <utility>

namespace berg {

namespace {

struct DeleteGrib
{
    void operator()(codes_handle* handle) const { (void)codes_handle_delete(handle); }
};
using GribHandle = std::unique_ptr<codes_handle, DeleteGrib>;

constexpr std::size_t kMostMessages = 100'000;
constexpr std::size_t kHeader = 16; ///< bytes of section 0 of edition 2
constexpr std::string_view kMessageEnd = "7777";

/** Returns the unsigned number of the bytes from `begin` on. */
std::size_t bigEndianAt(std::string_view bytes, std::size_t begin, std::size_t size)
{
    std::size_t number = 0;
    for (const char byte : bytes.substr(begin, size))
        number = (number << 8U) | static_cast<unsigned char>(byte);
    return number;
}

/**
 * Returns whether the sections of a message of edition 2 follow each other up to its end. ecCodes
 * copies as many bytes as they say they have, wherever the message ends.
 */
bool holdsItsSections(std::string_view message)
{
    constexpr std::size_t kSmallest = 5; // length and number of a section
    std::size_t begin = kHeader;
    while (message.size() - begin > kMessageEnd.size()) {
        const std::size_t length = bigEndianAt(message, begin, 4);
        if (length < kSmallest || length > message.size() - begin - kMessageEnd.size())
            return false;
        begin += length;
    }
    return message.substr(begin) == kMessageEnd;
}

/** Values of one time, in a message or a part of it. */
struct GribField
{
    std::size_t begin = 0; ///< of the message, in the file
    std::size_t length = 0;
    std::size_t part = 0; ///< number of the field in its message
};

/** How a message describes a number. */
struct GribNumber
{
    long discipline;
    long category;
    long parameter;
    GridNumber number;
};
constexpr std::array kGribNumbers{
    GribNumber{0, 2, 2, GridNumber::WindEast},     GribNumber{0, 2, 3, GridNumber::WindNorth},
    GribNumber{0, 2, 22, GridNumber::Gust},        GribNumber{0, 0, 0, GridNumber::AirTemperature},
    GribNumber{0, 0, 6, GridNumber::DewPoint},     GribNumber{0, 19, 0, GridNumber::Visibility},
    GribNumber{0, 6, 13, GridNumber::Ceiling},     GribNumber{0, 6, 11, GridNumber::Ceiling},
    GribNumber{10, 1, 2, GridNumber::CurrentEast}, GribNumber{10, 1, 3, GridNumber::CurrentNorth},
};

GridNumber alongGrid(GridNumber number)
{
    switch (number) {
    case GridNumber::WindEast:
        return GridNumber::WindAlongX;
    case GridNumber::WindNorth:
        return GridNumber::WindAlongY;
    case GridNumber::CurrentEast:
        return GridNumber::CurrentAlongX;
    case GridNumber::CurrentNorth:
        return GridNumber::CurrentAlongY;
    default:
        return number;
    }
}

/** Messages of GRIB as forecasts on grids. */
class GribSource final : public GridSource
{
public:
    GribSource(std::string_view bytes, ReadBudget& budget) : m_bytes(bytes), m_budget(budget)
    {
        std::size_t begin = 0;
        std::size_t count = 0;
        while ((begin = bytes.find("GRIB", begin)) != std::string_view::npos) {
            m_budget.throwIfStopped();
            const std::string name = "message " + std::to_string(++count);
            if (count > readLimit(kMostMessages))
                failTooLarge(budget.subject(), IssueId::TooManyRows, readLimit(kMostMessages));
            if (bytes.size() - begin < kHeader)
                fail(name, {IssueId::Damaged});
            if (bytes[begin + 7] != 2)
                fail(name,
                     {IssueId::GribEdition,
                      {static_cast<std::int64_t>(static_cast<unsigned char>(bytes[begin + 7]))}});
            const std::size_t length = bigEndianAt(bytes, begin + 8, 8);
            if (length < kHeader + kMessageEnd.size() || length > bytes.size() - begin ||
                !holdsItsSections(bytes.substr(begin, length)))
                fail(name, {IssueId::Damaged});
            addMessage(begin, length, name);
            begin += length;
        }
        finish();
    }

    [[nodiscard]] const std::vector<SourceGrid>& grids() const override { return m_grids; }
    [[nodiscard]] const std::vector<GridLayer>& layers() const override { return m_layers; }
    [[nodiscard]] std::string source() const override { return m_source; }
    [[nodiscard]] std::optional<ForecastTime> issued() const override { return m_issued; }

    [[nodiscard]] std::vector<double> read(const GridLayer& layer, std::size_t first,
                                           std::size_t count, const GridWindow& window) override
    {
        std::vector<double> values;
        values.reserve(count * window.rows * window.columns);
        const SourceGrid& grid = m_grids[layer.grid];
        for (std::size_t i = first; i < first + count; ++i) {
            const GribField& field = m_fields.at({layer.number, layer.times[i]}).field;
            const std::vector<double> all = valuesOf(field, layer, grid.rows * grid.columns);
            for (std::size_t row = 0; row < window.rows; ++row)
                for (std::size_t column = 0; column < window.columns; ++column) {
                    const double value =
                        all[(window.firstRow + row) * grid.columns + window.firstColumn + column];
                    values.push_back(converted(layer.number, value));
                }
        }
        return values;
    }

private:
    static constexpr double kMissing = 1e30;

    /** A field of a number and time, and how far its level is from the wanted one. */
    struct Known
    {
        GribField field;
        std::size_t grid = 0;
        double levelOffset = 0;
    };

    [[noreturn]] void fail(const std::string& field, IssueReason reason) const
    {
        throw Error(ErrorCode::FileUnreadable, m_budget.subject(),
                    {{Severity::Error, field, std::move(reason)}});
    }

    void succeed(int status, const std::string& field) const
    {
        if (status != CODES_SUCCESS)
            fail(field, {IssueId::CannotRead, {codes_get_error_message(status)}});
    }

    static double converted(GridNumber number, double value)
    {
        if (!(std::abs(value) < kMissing / 2))
            return std::numeric_limits<double>::quiet_NaN();
        const bool isTemperature =
            number == GridNumber::AirTemperature || number == GridNumber::DewPoint;
        return isTemperature ? value - 273.15 : value;
    }

    static std::optional<long> longOf(codes_handle* handle, const char* key)
    {
        long value = 0;
        if (codes_get_long(handle, key, &value) != CODES_SUCCESS)
            return std::nullopt;
        return value;
    }

    static std::string textOf(codes_handle* handle, const char* key)
    {
        std::array<char, 256> text{};
        std::size_t length = text.size();
        if (codes_get_string(handle, key, text.data(), &length) != CODES_SUCCESS)
            return {};
        return text.data();
    }

    /** Calls `use` with each field of a message. */
    template <class Use>
    void forEachField(std::size_t begin, std::size_t length, const std::string& name,
                      const Use& use) const
    {
        // ecCodes steps through memory of its own, which it may write to.
        std::string message(m_bytes.substr(begin, length));
        void* data = message.data();
        std::size_t rest = message.size();
        codes_grib_multi_support_on(nullptr);
        for (std::size_t part = 0; rest > 0; ++part) {
            int status = CODES_SUCCESS;
            const GribHandle handle(
                codes_grib_handle_new_from_multi_message(nullptr, &data, &rest, &status));
            if (!handle) {
                if (part == 0 || status != CODES_SUCCESS)
                    fail(name, {IssueId::CannotRead, {codes_get_error_message(status)}});
                return;
            }
            if (!use(handle.get(), part))
                return;
        }
    }

    void addMessage(std::size_t begin, std::size_t length, const std::string& name)
    {
        m_budget.take(length);
        forEachField(begin, length, name, [&](codes_handle* handle, std::size_t part) {
            addField(handle, {.begin = begin, .length = length, .part = part}, name);
            return true;
        });
        m_budget.release(length);
    }

    /** Returns the number of a field and the distance of its level; nullopt if it is not needed. */
    static std::optional<std::pair<GridNumber, double>> numberOf(codes_handle* handle)
    {
        const std::optional<long> discipline = longOf(handle, "discipline");
        const std::optional<long> category = longOf(handle, "parameterCategory");
        const std::optional<long> parameter = longOf(handle, "parameterNumber");
        const auto known = std::ranges::find_if(kGribNumbers, [&](const GribNumber& number) {
            return number.discipline == discipline && number.category == category &&
                   number.parameter == parameter;
        });
        if (known == kGribNumbers.end())
            return std::nullopt;
        double level = 0;
        (void)codes_get_double(handle, "level", &level);
        const long surface = longOf(handle, "typeOfFirstFixedSurface").value_or(255);
        constexpr long kGround = 1;
        constexpr long kCloudBase = 2;
        constexpr long kMeanSea = 101;
        constexpr long kAboveGround = 103;
        constexpr long kDepth = 160;
        constexpr long kSeaLayer = 168;
        double offset = 0;
        switch (known->number) {
        case GridNumber::WindEast:
        case GridNumber::WindNorth:
            if (surface != kAboveGround || level != 10)
                return std::nullopt;
            break;
        case GridNumber::AirTemperature:
        case GridNumber::DewPoint:
            if (surface != kAboveGround || level != 2)
                return std::nullopt;
            break;
        case GridNumber::CurrentEast:
        case GridNumber::CurrentNorth:
            if (surface != kGround && surface != kMeanSea && surface != kDepth &&
                surface != kSeaLayer)
                return std::nullopt;
            offset = std::abs(level);
            break;
        default: // table 4.5 has many surfaces for clouds
            if (surface != kGround && surface != kAboveGround && surface != kCloudBase &&
                known->number != GridNumber::Ceiling)
                return std::nullopt;
            // A ceiling is wanted, the lowest cloud base only in its place.
            offset = known->category == 6 && known->parameter == 11 ? 1 : 0;
            break;
        }
        GridNumber number = known->number;
        if (longOf(handle, "uvRelativeToGrid").value_or(0) == 1)
            number = alongGrid(number);
        return std::pair(number, offset);
    }

    [[nodiscard]] ForecastTime timeOf(codes_handle* handle, const char* dateKey,
                                      const char* timeKey, const std::string& name) const
    {
        long date = 0;
        long clock = 0;
        succeed(codes_get_long(handle, dateKey, &date), name);
        succeed(codes_get_long(handle, timeKey, &clock), name);
        using namespace std::chrono;
        const year_month_day day(year(static_cast<int>(date / 10000 % 10000)),
                                 month(static_cast<unsigned>(date / 100 % 100)),
                                 std::chrono::day(static_cast<unsigned>(date % 100)));
        if (date < 0 || !day.ok() || clock < 0 || clock > 2400)
            throw Error(ErrorCode::InvalidInput, m_budget.subject(),
                        {{Severity::Error, name, {IssueId::NotUtcTime}}});
        return sys_days(day) + hours(clock / 100) + minutes(clock % 100);
    }

    void addField(codes_handle* handle, const GribField& field, const std::string& name)
    {
        const auto number = numberOf(handle);
        if (!number)
            return;
        m_budget.takeRow(sizeof(Known));
        const ForecastTime issued = timeOf(handle, "dataDate", "dataTime", name);
        if (!m_issued || issued < *m_issued)
            m_issued = issued;
        if (m_source.empty())
            m_source = sourceOf(handle);
        const std::pair key(number->first, timeOf(handle, "validityDate", "validityTime", name));
        const Known known{
            .field = field, .grid = gridOf(handle, name), .levelOffset = number->second};
        const auto [at, isNew] = m_fields.emplace(key, known);
        if (!isNew && known.levelOffset < at->second.levelOffset)
            at->second = known;
    }

    static std::string sourceOf(codes_handle* handle)
    {
        std::string source = textOf(handle, "centreDescription");
        if (source.empty() || source == "unknown")
            source = textOf(handle, "centre");
        std::erase_if(source, [](char c) { return c < ' ' || c > '~'; });
        return source.empty() ? "GRIB" : source;
    }

    std::size_t gridOf(codes_handle* handle, const std::string& name)
    {
        const std::string key = textOf(handle, "md5GridSection");
        if (const auto known = m_gridNumbers.find(key); known != m_gridNumbers.end())
            return known->second;
        SourceGrid grid;
        const std::optional<long> rows = longOf(handle, "Nj");
        const std::optional<long> columns = longOf(handle, "Ni");
        const std::optional<long> points = longOf(handle, "numberOfDataPoints");
        constexpr long kMost = 20'000'000;
        const bool isGrid = rows && columns && points && *rows > 0 && *columns > 0 &&
                            *rows <= kMost && *columns <= kMost && *rows * *columns == *points &&
                            longOf(handle, "jPointsAreConsecutive").value_or(0) == 0 &&
                            longOf(handle, "alternativeRowScanning").value_or(0) == 0;
        if (!isGrid)
            throw Error(ErrorCode::InvalidInput, m_budget.subject(),
                        {{Severity::Error, name, {IssueId::NoQuantity}}});
        grid.rows = static_cast<std::size_t>(*rows);
        grid.columns = static_cast<std::size_t>(*columns);
        const std::size_t nodes = grid.rows * grid.columns;
        m_budget.take(4 * nodes * sizeof(double)); // with what ecCodes makes
        grid.latitude_deg = arrayOf(handle, "latitudes", nodes, name);
        grid.longitude_deg = arrayOf(handle, "longitudes", nodes, name);
        grid.againstX = longOf(handle, "iScansNegatively").value_or(0) == 1;
        makeRectilinear(grid);
        m_grids.push_back(std::move(grid));
        m_gridNumbers.emplace(key, m_grids.size() - 1);
        return m_grids.size() - 1;
    }

    [[nodiscard]] std::vector<double> arrayOf(codes_handle* handle, const char* key,
                                              std::size_t size, const std::string& name) const
    {
        std::size_t length = 0;
        succeed(codes_get_size(handle, key, &length), name);
        if (length != size)
            fail(name, {IssueId::Damaged});
        std::vector<double> values(size);
        succeed(codes_get_double_array(handle, key, values.data(), &length), name);
        if (length != size)
            fail(name, {IssueId::Damaged});
        return values;
    }

    [[nodiscard]] std::vector<double> valuesOf(const GribField& field, const GridLayer& layer,
                                               std::size_t nodes) const
    {
        std::vector<double> values;
        m_budget.throwIfStopped();
        forEachField(field.begin, field.length, layer.name,
                     [&](codes_handle* handle, std::size_t part) {
                         if (part < field.part)
                             return true;
                         (void)codes_set_double(handle, "missingValue", kMissing);
                         values = arrayOf(handle, "values", nodes, layer.name);
                         return false;
                     });
        if (values.size() != nodes)
            fail(layer.name, {IssueId::Damaged});
        return values;
    }

    /** Makes layers of the fields. */
    void finish()
    {
        for (const auto& [key, known] : m_fields) {
            if (m_layers.empty() || m_layers.back().number != key.first)
                m_layers.push_back(
                    {.number = key.first, .grid = known.grid, .name = {}, .times = {}});
            GridLayer& layer = m_layers.back();
            if (known.grid == layer.grid) // a number that changes its grid is taken as far as that
                layer.times.push_back(key.second);
        }
        for (GridLayer& layer : m_layers)
            layer.name = nameOfNumber(layer.number);
        if (m_layers.empty())
            throw Error(ErrorCode::InvalidInput, m_budget.subject(), {IssueId::NoQuantity});
    }

    static std::string nameOfNumber(GridNumber number)
    {
        switch (number) {
        case GridNumber::WindEast:
        case GridNumber::WindAlongX:
            return "10u";
        case GridNumber::WindNorth:
        case GridNumber::WindAlongY:
            return "10v";
        case GridNumber::Gust:
            return "gust";
        case GridNumber::AirTemperature:
            return "2t";
        case GridNumber::DewPoint:
            return "2d";
        case GridNumber::Visibility:
            return "vis";
        case GridNumber::Ceiling:
            return "ceil";
        case GridNumber::CurrentEast:
        case GridNumber::CurrentAlongX:
            return "ocu";
        default:
            return "ocv";
        }
    }

    std::string_view m_bytes;
    ReadBudget& m_budget;
    std::map<std::pair<GridNumber, ForecastTime>, Known> m_fields;
    std::map<std::string, std::size_t> m_gridNumbers;
    std::vector<SourceGrid> m_grids;
    std::vector<GridLayer> m_layers;
    std::string m_source;
    std::optional<ForecastTime> m_issued;
};

} // namespace

bool readsGrib()
{
    return true;
}

ForecastReading gribForecast(std::string_view bytes, const ForecastReadOptions& options,
                             ReadBudget& budget, const ForecastProgress& progress,
                             const std::stop_token& stop)
{
    GribSource source(bytes, budget);
    ForecastReading reading = resampled(source, options, budget, progress, stop);
    reading.format = "GRIB";
    return reading;
}

} // namespace berg
