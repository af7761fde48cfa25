#include "core/io/import/forecast/grid_resampling.h"

#include "core/base/error.h"
#include "core/io/import/forecast/grid_sampling.h"
#include "core/scenario/utc_time.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace berg {

namespace {

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

/** Permitted values of a number, in the units of `ForecastEntry`. */
Limits limitsOf(GridNumber number)
{
    constexpr double kWind = limits::kWindSpeed_mps.high;
    constexpr double kCurrent = limits::kSpeed_mps.high;
    switch (number) {
    case GridNumber::WindEast:
    case GridNumber::WindNorth:
    case GridNumber::WindAlongX:
    case GridNumber::WindAlongY:
        return {.low = -kWind, .high = kWind};
    case GridNumber::Gust:
        return limits::kWindSpeed_mps;
    case GridNumber::AirTemperature:
    case GridNumber::DewPoint:
        return limits::kTemperature_degC;
    case GridNumber::Fog:
        return {.low = 0, .high = 100};
    case GridNumber::Visibility:
        return {.low = 0, .high = 1e6};
    case GridNumber::Ceiling:
        return {.low = 0, .high = 1e5};
    case GridNumber::CurrentEast:
    case GridNumber::CurrentNorth:
    case GridNumber::CurrentAlongX:
    case GridNumber::CurrentAlongY:
        return {.low = -kCurrent, .high = kCurrent};
    case GridNumber::Depth:
        return {.low = -1e4, .high = 12e3}; // land is below 0
    case GridNumber::AngleOfX:
        break;
    }
    return {.low = -10, .high = 10};
}

/** Values of one number: for each instant those of all places, NaN for a missing one. */
struct NumberValues
{
    std::vector<double> values;
    const GridSampling* sampling = nullptr;

    [[nodiscard]] bool isGiven() const { return !values.empty(); }
};

class Resampler
{
public:
    Resampler(GridSource& source, const ForecastReadOptions& options, ReadBudget& budget,
              const ForecastProgress& progress, const std::stop_token& stop)
        : m_source(source), m_options(options), m_budget(budget), m_progress(progress), m_stop(stop)
    {
    }

    ForecastReading run()
    {
        chooseTimes();
        choosePlaces();
        const std::vector<GridLayer>& layers = m_source.layers();
        for (std::size_t i = 0; i < layers.size(); ++i) {
            readLayer(layers[i], static_cast<double>(i) / static_cast<double>(layers.size()),
                      1 / static_cast<double>(layers.size()));
        }
        return {.format = {}, .field = field(), .thinning = m_thinning};
    }

private:
    [[noreturn]] void fail(const std::string& field, IssueReason reason) const
    {
        throw Error(ErrorCode::InvalidInput, m_budget.subject(),
                    {{Severity::Error, field, std::move(reason)}});
    }

    void chooseTimes()
    {
        for (const GridLayer& layer : m_source.layers())
            m_times.insert(m_times.end(), layer.times.begin(), layer.times.end());
        std::ranges::sort(m_times);
        m_times.erase(std::unique(m_times.begin(), m_times.end()), m_times.end());
        if (m_times.empty())
            fail("time", {IssueId::Missing});
        if ((m_options.since && *m_options.since > m_times.back()) ||
            (m_options.until && *m_options.until < m_times.front()))
            fail("time", {IssueId::ForecastNotThen,
                          {utcText(m_times.front(), 0), utcText(m_times.back(), 0)}});
        if (m_options.until)
            if (const auto last = std::ranges::lower_bound(m_times, *m_options.until);
                last != m_times.end())
                m_times.erase(last + 1, m_times.end());
        if (m_options.since)
            if (const auto after = std::ranges::upper_bound(m_times, *m_options.since);
                after != m_times.begin())
                m_times.erase(m_times.begin(), after - 1);
        if (m_times.size() > m_options.mostEntries)
            fail("time",
                 {IssueId::MostEntries, {countOf(m_options.mostEntries), countOf(m_times.size())}});
    }

    void choosePlaces()
    {
        std::vector<std::size_t> uses(m_source.grids().size());
        for (const GridLayer& layer : m_source.layers())
            if (!layer.times.empty())
                ++uses[layer.grid];
        const auto most = static_cast<std::size_t>(std::ranges::max_element(uses) - uses.begin());
        TargetChoice choice = chooseTarget(
            m_source.grids()[most],
            {.area = m_options.area,
             .mostPlaces = std::min(kMostReadPlaces, m_options.mostEntries / m_times.size())});
        if (choice.fault == NoTarget::NoPlaces)
            fail("latitude", {IssueId::Missing});
        if (choice.fault == NoTarget::TooWide)
            fail("longitude", {IssueId::ForecastTooWide});
        if (choice.fault == NoTarget::OutsideArea)
            fail("latitude", {IssueId::ForecastNotHere});
        m_target = std::move(choice.grid);
        m_thinning = choice.thinning;
        if (m_target.size() * m_times.size() > std::max(m_options.mostEntries, m_times.size() * 4))
            fail("time", {IssueId::MostEntries,
                          {countOf(m_options.mostEntries / 4), countOf(m_times.size())}});
        m_budget.take(m_target.size() * m_times.size() * sizeof(ForecastEntry));
    }

    const GridSampling& samplingOf(std::size_t grid)
    {
        const auto known = m_samplings.find(grid);
        if (known != m_samplings.end())
            return known->second;
        m_budget.take(m_target.size() * (sizeof(NodeShares) + sizeof(Point)));
        return m_samplings.emplace(grid, sampling(m_source.grids()[grid], m_target, m_stop))
            .first->second;
    }

    void readLayer(const GridLayer& layer, double done, double share)
    {
        const GridSampling& from = samplingOf(layer.grid);
        if (from.window.rows == 0)
            return;
        NumberValues& into = m_numbers[static_cast<std::size_t>(layer.number)];
        into.sampling = &from;
        const bool isConstant = layer.times.empty();
        const std::size_t instants = isConstant ? 1 : m_times.size();
        m_budget.take(instants * m_target.size() * sizeof(double));
        into.values.assign(instants * m_target.size(), kMissing);
        std::size_t first = 0;
        std::size_t end = 1;
        if (!isConstant) {
            first = indexOf(layer.times, m_times.front());
            end = static_cast<std::size_t>(std::ranges::upper_bound(layer.times, m_times.back()) -
                                           layer.times.begin());
        }
        // Chunks of a file may hold many instants, which are best read at a time.
        constexpr std::size_t kMostAtOnce = 2'000'000;
        const std::size_t nodes = from.window.rows * from.window.columns;
        const std::size_t atOnce = std::max<std::size_t>(1, kMostAtOnce / nodes);
        const std::size_t all = end > first ? end - first : 1;
        const std::size_t begin = first;
        while (first < end) {
            m_budget.throwIfStopped();
            const std::size_t count = std::min(atOnce, end - first);
            readBlock(layer, first, count, into);
            first += count;
            if (m_progress)
                m_progress(done +
                           share * static_cast<double>(first - begin) / static_cast<double>(all));
        }
    }

    static std::size_t indexOf(const std::vector<ForecastTime>& times, ForecastTime time)
    {
        return static_cast<std::size_t>(std::ranges::lower_bound(times, time) - times.begin());
    }

    void readBlock(const GridLayer& layer, std::size_t first, std::size_t count, NumberValues& into)
    {
        const GridWindow& window = into.sampling->window;
        const std::size_t nodes = window.rows * window.columns;
        m_budget.take(2 * count * nodes * sizeof(double));
        const std::vector<double> values = m_source.read(layer, first, count, window);
        require(values.size() == count * nodes, "GridSource::read: wrong count");
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t instant =
                layer.times.empty() ? 0 : indexOf(m_times, layer.times[first + i]);
            double* const target = into.values.data() + instant * m_target.size();
            for (std::size_t place = 0; place < m_target.size(); ++place)
                target[place] =
                    valueAt(layer, into.sampling->shares[place], values.data() + i * nodes);
        }
        m_budget.release(2 * count * nodes * sizeof(double));
    }

    [[nodiscard]] double valueAt(const GridLayer& layer, const NodeShares& shares,
                                 const double* values) const
    {
        const std::optional<double> value = sampled(shares, values);
        if (!value)
            return kMissing;
        const Limits limits = limitsOf(layer.number);
        const double slack = (limits.high - limits.low) / 1000; // of packed numbers
        if (!(*value >= limits.low - slack && *value <= limits.high + slack))
            fail(layer.name, {IssueId::OutOfRange, {limits.low, limits.high, *value}});
        return std::clamp(*value, limits.low, limits.high);
    }

    [[nodiscard]] const NumberValues& of(GridNumber number) const
    {
        return m_numbers[static_cast<std::size_t>(number)];
    }

    [[nodiscard]] std::optional<double> valueOf(GridNumber number, std::size_t instant,
                                                std::size_t place) const
    {
        const NumberValues& values = of(number);
        if (!values.isGiven())
            return std::nullopt;
        const double value = values.values[instant * m_target.size() + place];
        return std::isnan(value) ? std::nullopt : std::optional(value);
    }

    /** Returns the direction of the grid's x axis at a place, as east and north. */
    [[nodiscard]] Point xAxisAt(GridNumber alongX, std::size_t place) const
    {
        if (const std::optional<double> angle_rad = valueOf(GridNumber::AngleOfX, 0, place))
            return {std::cos(*angle_rad), std::sin(*angle_rad)};
        return of(alongX).sampling->alongX[place];
    }

    [[nodiscard]] std::optional<Point> velocityAt(GridNumber east, GridNumber north,
                                                  GridNumber alongX, GridNumber alongY,
                                                  std::size_t instant, std::size_t place) const
    {
        const std::optional<double> e = valueOf(east, instant, place);
        const std::optional<double> n = valueOf(north, instant, place);
        if (e && n)
            return Point(*e, *n);
        const std::optional<double> x = valueOf(alongX, instant, place);
        const std::optional<double> y = valueOf(alongY, instant, place);
        if (!x || !y)
            return std::nullopt;
        const Point axis = xAxisAt(alongX, place);
        return Point(*x * axis.x() - *y * axis.y(), *x * axis.y() + *y * axis.x());
    }

    [[nodiscard]] ForecastEntry entryOf(std::size_t instant, std::size_t place) const
    {
        using enum GridNumber;
        const auto value = [&](GridNumber number) { return valueOf(number, instant, place); };
        return {.time = m_times[instant],
                .wind_mps = velocityAt(WindEast, WindNorth, WindAlongX, WindAlongY, instant, place),
                .gust_mps = value(Gust),
                .airTemperature_degC = value(AirTemperature),
                .dewPoint_degC = value(DewPoint),
                .fog_percent = value(Fog),
                .visibility_m = value(Visibility),
                .ceiling_m = value(Ceiling),
                .current_mps = velocityAt(CurrentEast, CurrentNorth, CurrentAlongX, CurrentAlongY,
                                          instant, place)};
    }

    [[nodiscard]] ForecastField field() const
    {
        ForecastField made{.columns = m_target.longitude_deg.size()};
        bool hasValue = false;
        for (std::size_t place = 0; place < m_target.size(); ++place) {
            const double longitude = m_target.longitude_deg[place % made.columns];
            Forecast forecast{.source = m_source.source(),
                              .issued = m_source.issued(),
                              .place = {m_target.latitude_deg[place / made.columns],
                                        longitude - 360 * std::floor((longitude + 180) / 360)}};
            for (std::size_t instant = 0; instant < m_times.size(); ++instant) {
                forecast.series.push_back(entryOf(instant, place));
                hasValue = hasValue ||
                           std::ranges::any_of(kForecastQuantities, [&](ForecastQuantity quantity) {
                               return gives(forecast.series.back(), quantity);
                           });
            }
            if (const std::optional<double> depth_m = valueOf(GridNumber::Depth, 0, place);
                depth_m && *depth_m > 0)
                forecast.depth_m = depth_m;
            made.places.push_back(std::move(forecast));
        }
        if (!hasValue)
            fail("latitude", {IssueId::ForecastNotHere});
        require(isGrid(made), "resampled: no grid");
        return made;
    }

    GridSource& m_source;
    const ForecastReadOptions& m_options;
    ReadBudget& m_budget;
    const ForecastProgress& m_progress;
    const std::stop_token& m_stop;
    std::vector<ForecastTime> m_times;
    TargetGrid m_target;
    std::size_t m_thinning = 1;
    std::map<std::size_t, GridSampling> m_samplings;
    std::array<NumberValues, kGridNumbers> m_numbers;
};

} // namespace

ForecastReading resampled(GridSource& source, const ForecastReadOptions& options,
                          ReadBudget& budget, const ForecastProgress& progress,
                          const std::stop_token& stop)
{
    return Resampler(source, options, budget, progress, stop).run();
}

} // namespace berg
