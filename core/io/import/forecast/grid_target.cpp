#include "core/base/angles.h"
#include "core/io/import/forecast/grid_sampling.h"

#include <algorithm>
#include <cmath>

namespace berg {

namespace {

constexpr double kWidest_deg = 180;

/** Part of an axis: offsets from a middle, in degrees. */
struct AxisPart
{
    double low = 0;
    double high = 0;
};

/** Returns `offset` turned into [-180, 180). */
double wrapped_deg(double offset)
{
    return offset - 360 * std::floor((offset + 180) / 360);
}

/** Calls `use` with the latitude and longitude of each node that is on the Earth. */
template <class Use>
void forEachNode(const SourceGrid& source, const Use& use)
{
    for (std::size_t row = 0; row < source.rows; ++row)
        for (std::size_t column = 0; column < source.columns; ++column)
            if (const LatLon place = source.at(row, column);
                std::abs(place.latitude_deg) <= 90 && std::abs(place.longitude_deg) <= 720)
                use(place);
}

/** Returns the middle longitude of the nodes and half the width of the arc that they fill. */
std::optional<AxisPart> filledArc(const SourceGrid& source)
{
    std::array<bool, 360> filled{};
    const auto mark = [&](double longitude_deg) {
        if (std::abs(longitude_deg) <= 720)
            filled[static_cast<std::size_t>(
                std::clamp(std::floor(wrapped_deg(longitude_deg) + 180), 0.0, 359.0))] = true;
    };
    std::ranges::for_each(source.longitude_deg, mark);
    std::size_t longest = 0;
    std::size_t endOfLongest = 0;
    std::size_t run = 0;
    for (std::size_t i = 0; i < 2 * filled.size(); ++i) {
        run = filled[i % filled.size()] ? 0 : run + 1;
        if (run > longest) {
            longest = run;
            endOfLongest = i;
        }
    }
    if (longest >= filled.size())
        return std::nullopt;
    const double width = static_cast<double>(filled.size() - longest);
    const double west = static_cast<double>(endOfLongest) + 1 - 180;
    return AxisPart{.low = wrapped_deg(west + width / 2), .high = width / 2};
}

/** Box around a middle longitude. */
struct TargetBox
{
    double middle_deg = 0;
    AxisPart east; ///< offsets from the middle
    AxisPart latitude;
};

/** Returns the wished box, or that of all nodes; nullopt if it would be too wide or has no place.
 */
std::optional<TargetBox> boxOf(const SourceGrid& source, const std::optional<GeoBox>& area,
                               TargetChoice& choice)
{
    TargetBox box{.latitude = {.low = -90, .high = 90}};
    double width = 360;
    if (area) {
        box.latitude = {.low = area->south_deg, .high = area->north_deg};
        width = area->east_deg - area->west_deg;
        width += width < 0 ? 360 : 0;
        box.middle_deg = wrapped_deg(area->west_deg + width / 2);
    }
    if (width >= kWidest_deg) {
        const std::optional<AxisPart> arc = filledArc(source);
        if (!arc) {
            choice.fault = NoTarget::NoPlaces;
            return std::nullopt;
        }
        box.middle_deg = arc->low;
        width = 2 * arc->high;
    }
    if (width >= kWidest_deg) {
        choice.fault = NoTarget::TooWide;
        return std::nullopt;
    }
    box.east = {.low = -width / 2, .high = width / 2};
    return box;
}

/** Returns the values that are in the part, and the next ones around; the values rise. */
std::vector<double> around(std::vector<double> values, const AxisPart& part)
{
    std::erase_if(values, [](double value) { return !std::isfinite(value); });
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());
    if (values.empty() || values.back() < part.low || values.front() > part.high)
        return {};
    auto first = std::ranges::upper_bound(values, part.low);
    auto last = std::ranges::lower_bound(values, part.high);
    first -= first == values.begin() ? 0 : 1;
    last += last == values.end() ? 0 : 1;
    return {first, last};
}

std::size_t thinnedSize(std::size_t size, std::size_t step)
{
    return size < 2 ? size : (size - 2) / step + 2;
}

/** Returns every `step`-th value and the last. */
std::vector<double> thinnedAxis(const std::vector<double>& values, std::size_t step)
{
    std::vector<double> kept;
    for (std::size_t i = 0; i + 1 < values.size(); i += step)
        kept.push_back(values[i]);
    if (!values.empty())
        kept.push_back(values.back());
    return kept;
}

TargetChoice nodesOf(const SourceGrid& source, const TargetWish& wish)
{
    TargetChoice choice;
    const std::optional<TargetBox> box = boxOf(source, wish.area, choice);
    if (!box)
        return choice;
    std::vector<double> offsets = source.longitude_deg;
    for (double& offset : offsets)
        offset = wrapped_deg(offset - box->middle_deg);
    const std::vector<double> latitudes = around(source.latitude_deg, box->latitude);
    std::vector<double> east = around(offsets, box->east);
    if (latitudes.empty() || east.empty()) {
        choice.fault = NoTarget::OutsideArea;
        return choice;
    }
    if (east.back() - east.front() >= kWidest_deg) {
        choice.fault = NoTarget::TooWide;
        return choice;
    }
    for (double& offset : east)
        offset += box->middle_deg;
    while (thinnedSize(latitudes.size(), choice.thinning) *
                   thinnedSize(east.size(), choice.thinning) >
               wish.mostPlaces &&
           choice.thinning < std::max(latitudes.size(), east.size()))
        ++choice.thinning;
    choice.grid = {.latitude_deg = thinnedAxis(latitudes, choice.thinning),
                   .longitude_deg = thinnedAxis(east, choice.thinning)};
    return choice;
}

/** Returns the mean distance of neighbours whose first is in the box, degrees of latitude. */
double spacing_deg(const SourceGrid& source, const TargetBox& box)
{
    double sum = 0;
    double count = 0;
    const auto add = [&](const LatLon& from, const LatLon& to) {
        const double north = to.latitude_deg - from.latitude_deg;
        const double east = wrapped_deg(to.longitude_deg - from.longitude_deg) *
                            std::cos(radFromDeg(from.latitude_deg));
        const double distance = std::hypot(north, east);
        if (!std::isfinite(distance) || distance > 10)
            return;
        sum += distance;
        count += 1;
    };
    const auto isInside = [&](const LatLon& place) {
        const double east = wrapped_deg(place.longitude_deg - box.middle_deg);
        return place.latitude_deg >= box.latitude.low && place.latitude_deg <= box.latitude.high &&
               east >= box.east.low && east <= box.east.high;
    };
    // An area smaller than a cell has no node: the mean of all is then near enough.
    for (const bool all : {false, true}) {
        for (std::size_t row = 0; row + 1 < source.rows; ++row)
            for (std::size_t column = 0; column + 1 < source.columns; ++column) {
                const LatLon place = source.at(row, column);
                if (!all && !isInside(place))
                    continue;
                add(place, source.at(row, column + 1));
                add(place, source.at(row + 1, column));
            }
        if (count > 0)
            break;
    }
    return count > 0 ? sum / count : 0;
}

/** Returns evenly spaced values from end to end, at most `spacing` apart. */
std::vector<double> spacedEvenly(const AxisPart& part, double spacing)
{
    if (part.high - part.low < 1e-9)
        return {part.low};
    const double steps = std::max(1.0, std::ceil((part.high - part.low) / spacing - 1e-6));
    std::vector<double> values;
    for (double i = 0; i <= steps; ++i)
        values.push_back(part.low + (part.high - part.low) * (i / steps));
    return values;
}

TargetChoice regularOver(const SourceGrid& source, const TargetWish& wish)
{
    TargetChoice choice;
    const std::optional<TargetBox> box = boxOf(source, wish.area, choice);
    if (!box)
        return choice;
    AxisPart north{.low = 91, .high = -91};
    AxisPart east{.low = 181, .high = -181};
    forEachNode(source, [&](const LatLon& place) {
        const double offset = wrapped_deg(place.longitude_deg - box->middle_deg);
        north = {std::min(north.low, place.latitude_deg), std::max(north.high, place.latitude_deg)};
        east = {std::min(east.low, offset), std::max(east.high, offset)};
    });
    const auto common = [](const AxisPart& a, const AxisPart& b) {
        return AxisPart{std::max(a.low, b.low), std::min(a.high, b.high)};
    };
    north = common(north, box->latitude);
    east = common(east, box->east);
    const double spacing = spacing_deg(source, *box);
    if (north.high < north.low || east.high < east.low || spacing <= 0) {
        choice.fault = NoTarget::OutsideArea;
        return choice;
    }
    const double narrowing = std::max(0.05, std::cos(radFromDeg((north.low + north.high) / 2)));
    const auto size = [&](const AxisPart& part, double step) {
        return std::max(1.0, std::ceil((part.high - part.low) / step - 1e-6)) + 1;
    };
    const auto step = [&] { return spacing * static_cast<double>(choice.thinning); };
    while (size(north, step()) * size(east, step() / narrowing) >
               static_cast<double>(wish.mostPlaces) &&
           step() < kWidest_deg)
        ++choice.thinning;
    choice.grid = {.latitude_deg = spacedEvenly(north, step()),
                   .longitude_deg = spacedEvenly(east, step() / narrowing)};
    for (double& longitude : choice.grid.longitude_deg)
        longitude += box->middle_deg;
    return choice;
}

} // namespace

void makeRectilinear(SourceGrid& grid)
{
    if (grid.isRectilinear() || grid.rows == 0 || grid.columns == 0)
        return;
    for (std::size_t row = 0; row < grid.rows; ++row)
        for (std::size_t column = 0; column < grid.columns; ++column) {
            const std::size_t node = row * grid.columns + column;
            if (grid.latitude_deg[node] != grid.latitude_deg[row * grid.columns] ||
                grid.longitude_deg[node] != grid.longitude_deg[column])
                return;
        }
    for (std::size_t row = 0; row < grid.rows; ++row)
        grid.latitude_deg[row] = grid.latitude_deg[row * grid.columns];
    grid.latitude_deg.resize(grid.rows);
    grid.longitude_deg.resize(grid.columns);
}

TargetChoice chooseTarget(const SourceGrid& source, const TargetWish& wish)
{
    return source.isRectilinear() ? nodesOf(source, wish) : regularOver(source, wish);
}

} // namespace berg
