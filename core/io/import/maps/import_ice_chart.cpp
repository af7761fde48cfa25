#include "core/io/import/maps/import_ice_chart.h"

#include "core/base/error.h"
#include "core/io/export/content/thinned_path.h"
#include "core/io/import/fields/import_fields.h"
#include "core/io/import/fields/import_source.h"
#include "core/io/import/maps/feature_parsers.h"
#include "core/io/import/maps/map_readers.h"
#include "core/io/text/byte_order_mark.h"
#include "core/io/text/json_writer.h"
#include "core/scenario/text_checks.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <initializer_list>
#include <numeric>

namespace berg {

namespace {

using Outline = std::vector<Point>;

std::string twoDigits(int code)
{
    return (code < 10 ? "0" : "") + std::to_string(code);
}

/** Returns a concentration as charts have it: "4-6/10". */
std::string shareText(int code)
{
    if (code == 0 || code == 55)
        return "0/10";
    if (code == 1 || code == 2)
        return "<1/10";
    if (code == 91)
        return "9+/10";
    if (code == 92)
        return "10/10";
    const int first = code / 10;
    const int second = code == 81 ? 10 : code % 10;
    return std::to_string(first) + (second == 0 ? "" : "-" + std::to_string(second)) + "/10";
}

/** Returns the total concentration, and stage and form of each kind of ice, as codes. */
std::string iceLabel(const Json* properties)
{
    std::string label;
    const auto add = [&label](const std::string& part, const char* separator) {
        label += (label.empty() ? "" : separator) + part;
    };
    if (const std::optional<int> total = chartCode(properties, "CT");
        total && tenthsOfSigrid(*total))
        add(shareText(*total), "");
    for (const char kind : {'A', 'B', 'C'}) {
        const char* separator = ", ";
        for (const char what : {'C', 'S', 'F'}) {
            const std::string name{what, kind};
            if (const std::optional<int> code = chartCode(properties, name)) {
                add(name + ' ' + twoDigits(*code), separator);
                separator = " ";
            }
        }
    }
    return label;
}

/** Returns a time as a scenario stores it, or an empty text. */
std::string chartTime(std::string_view text)
{
    const std::optional<UtcTime> time = parseSightingTime(trimmed(text), DateOrder::MonthFirst);
    return time ? utcText(*time, 0) : std::string();
}

std::string dateOfProperties(const Json* properties)
{
    for (const char* name :
         {"RECDAT", "ICEDATE", "ICE_DATE", "DATE", "DATE_CARTE", "OBSDATE", "VALID_TIME", "TIME"})
        if (const Json* const value = chartProperty(properties, name))
            if (std::string date = chartTime(cellText(*value)); !date.empty())
                return date;
    return {};
}

/** Returns the date of a name such as "cis_SGRDREA_20210118T1800Z_pl_a", or an empty text. */
std::string dateOfName(std::string_view name)
{
    constexpr std::size_t kDay = 8;
    constexpr std::size_t kMinute = 4;
    const auto digits = [&](std::size_t from) {
        std::size_t count = 0;
        while (from + count < name.size() &&
               std::isdigit(static_cast<unsigned char>(name[from + count])) != 0)
            ++count;
        return count;
    };
    for (std::size_t at = 0; at < name.size(); at += std::max<std::size_t>(digits(at), 1)) {
        const std::size_t count = digits(at);
        if (count < kDay)
            continue;
        const std::string_view day = name.substr(at, kDay);
        std::string text = std::string(day.substr(0, 4)) + '-' + std::string(day.substr(4, 2)) +
                           '-' + std::string(day.substr(6, 2));
        const bool hasLetter = count == kDay && at + count < name.size() &&
                               (name[at + count] == 'T' || name[at + count] == '_');
        const std::size_t clock = at + kDay + (hasLetter ? 1 : 0);
        if (digits(clock) >= kMinute && (hasLetter || count > kDay))
            text += 'T' + std::string(name.substr(clock, 2)) + ':' +
                    std::string(name.substr(clock + 2, 2)) + 'Z';
        if (std::string date = chartTime(text); !date.empty())
            return date;
    }
    return {};
}

/** Returns the part of a closed outline on one side of a line x or y = limit. */
Outline cutAt(const Outline& outline_m, int axis, double limit_m, bool keepBelow)
{
    Outline kept_m;
    const auto isInside = [&](const Point& p_m) {
        return keepBelow ? p_m[axis] <= limit_m : p_m[axis] >= limit_m;
    };
    for (std::size_t i = 0; i < outline_m.size(); ++i) {
        const Point& from_m = outline_m[i];
        const Point& to_m = outline_m[(i + 1) % outline_m.size()];
        if (isInside(from_m))
            kept_m.push_back(from_m);
        if (isInside(from_m) != isInside(to_m)) {
            Point cut_m =
                from_m + (to_m - from_m) * ((limit_m - from_m[axis]) / (to_m[axis] - from_m[axis]));
            cut_m[axis] = limit_m;
            kept_m.push_back(cut_m);
        }
    }
    return kept_m;
}

/** Returns the part of an outline in the square of a chart; an edge may lie on its border. */
Outline cutToChart(Outline outline_m)
{
    for (const int axis : {0, 1})
        for (const bool keepBelow : {true, false})
            if (!outline_m.empty())
                outline_m = cutAt(outline_m, axis, keepBelow ? kNearIceChart_m : -kNearIceChart_m,
                                  keepBelow);
    return outline_m;
}

/** Returns the outline without corners that are close to the one before. */
std::vector<TimedPoint> sparsePath(const Outline& outline_m, double distance_m)
{
    std::vector<TimedPoint> path;
    for (const Point& p_m : outline_m)
        if (path.empty() || (p_m - path.back().position_m).norm() >= distance_m)
            path.push_back({.position_m = p_m, .time_s = 0});
    path.push_back(path.front());
    return path;
}

/**
 * Returns the outline in whole metres, moved by the tolerance at most; empty if it vanishes, or
 * nullopt if it keeps too many corners.
 */
std::optional<Outline> thinnedOutline(const Outline& outline_m, double tolerance_m)
{
    constexpr std::size_t kMostToThin = 50'000; // thinning more takes long
    const std::vector<TimedPoint> path = sparsePath(outline_m, tolerance_m / 2);
    if (path.size() > kMostToThin)
        return std::nullopt;
    const std::vector<TimedPoint> kept = thinnedPath(path, tolerance_m / 2, kMostIceCorners);
    if (kept.size() > kMostIceCorners)
        return std::nullopt;
    Outline thinned_m;
    for (const TimedPoint& point : kept) {
        const Point whole_m(std::round(point.position_m.x()) + 0.0, // not -0
                            std::round(point.position_m.y()) + 0.0);
        if (thinned_m.empty() || thinned_m.back() != whole_m)
            thinned_m.push_back(whole_m);
    }
    if (thinned_m.size() > 1 && thinned_m.front() == thinned_m.back())
        thinned_m.pop_back();
    if (thinned_m.size() < 3)
        thinned_m.clear();
    return thinned_m;
}

/**
 * Returns the areas with outlines that move by the tolerance at most, without those that vanish;
 * nullopt if they keep too many corners.
 */
std::optional<std::vector<IceArea>> thinnedAreas(const std::vector<IceArea>& areas,
                                                 double tolerance_m, const ReadBudget& budget)
{
    std::size_t corners = 0;
    std::vector<IceArea> kept;
    for (const IceArea& area : areas) {
        IceArea thinned{.label = area.label,
                        .concentration_tenths = area.concentration_tenths,
                        .isFast = area.isFast};
        for (const Outline& outline_m : area.outlines_m) {
            budget.throwIfStopped();
            std::optional<Outline> thin_m = thinnedOutline(outline_m, tolerance_m);
            if (!thin_m || (corners += thin_m->size()) > kMostIceCorners)
                return std::nullopt;
            if (!thin_m->empty())
                thinned.outlines_m.push_back(std::move(*thin_m));
            else if (thinned.outlines_m.empty())
                break; // without its outline its holes would be areas
        }
        if (!thinned.outlines_m.empty())
            kept.push_back(std::move(thinned));
    }
    return kept;
}

/** Reads the chart of one text. */
class IceChartImport
{
public:
    IceChartImport(const Scenario& base, ReadBudget& budget)
        : m_budget(budget), m_frame(base.origin), m_result{.scenario = base}
    {
        m_result.rejected.place = "feature";
    }

    void read(std::string_view text)
    {
        readGeoJsonFeatures(text, CrsUse::Needed, m_budget,
                            [this](const FileFeature& feature) { addFeature(feature); });
    }

    IceChartResult take()
    {
        m_chart.source = cleanText(m_budget.subject(), kLongestName);
        if (m_chart.dateUtc.empty())
            m_chart.dateUtc = dateOfName(m_budget.subject());
        keepLargest();
        thin();
        if (m_chart.areas.empty())
            fail();
        m_result.taken = m_chart.areas.size();
        m_result.scenario.iceChart = std::move(m_chart);
        return std::move(m_result);
    }

private:
    [[noreturn]] void fail() const
    {
        if (m_result.far > 0)
            throw Error(ErrorCode::InvalidInput, m_budget.subject(),
                        {IssueId::NoIceNear, {static_cast<std::int64_t>(kNearIceChart_m / 1000)}});
        if (m_result.rejected.count == 0)
            throw Error(ErrorCode::WrongFormat, m_budget.subject(), {IssueId::NotIceChart});
        const RejectedRow& first = m_result.rejected.first.front();
        throw Error(ErrorCode::InvalidInput, m_budget.subject(),
                    {{Severity::Error, placeOf(m_result.rejected, first.line), reasonOf(first)}});
    }

    void addFeature(const FileFeature& feature)
    {
        if (!feature.broken.empty())
            m_result.rejected.add({.line = feature.line, .fault = IssueId::FeatureBroken});
        const Json* const properties = feature.properties;
        const std::string type(trimmed(textOf(chartProperty(properties, "POLY_TYPE"))));
        const bool hasTotal = chartProperty(properties, "CT") != nullptr;
        if (type == "L" || (type.empty() && !hasTotal))
            return;
        IceArea area{.label = iceLabel(properties)};
        if (const std::optional<int> total = chartCode(properties, "CT"))
            area.concentration_tenths = tenthsOfSigrid(*total);
        if (type == "W" && !area.concentration_tenths)
            area.concentration_tenths = 0;
        area.isFast = type != "W" && chartCode(properties, "FA") == kFastIce;
        if (m_chart.dateUtc.empty())
            m_chart.dateUtc = dateOfProperties(properties);
        for (const FileShape& shape : feature.geometry().shapes)
            if (shape.kind == ShapeKind::Area)
                addPolygon(shape, feature.line, area);
    }

    void addPolygon(const FileShape& polygon, std::size_t line, IceArea area)
    {
        if (polygon.parts == 0)
            m_result.rejected.add({.line = line, .fault = IssueId::IceAreaUnreadable});
        for (std::size_t i = 0; i < polygon.parts; ++i) {
            const std::optional<Outline> outline_m = outlineOf(placesOf(polygon, i));
            if (!outline_m) {
                m_result.rejected.add({.line = line, .fault = IssueId::IceAreaUnreadable});
                return;
            }
            Outline cut_m = cutToChart(*outline_m);
            if (area.outlines_m.empty() && cut_m.size() < 3) {
                ++m_result.far;
                return;
            }
            if (cut_m.size() < 3)
                continue;
            m_budget.takeRow(sizeof(Outline) + cut_m.capacity() * sizeof(Point));
            area.outlines_m.push_back(std::move(cut_m));
        }
        if (area.outlines_m.empty())
            return;
        m_budget.takeRow(sizeof area + area.label.capacity());
        m_chart.areas.push_back(std::move(area));
    }

    /** Returns a ring in the plane, without its repeated first place. */
    std::optional<Outline> outlineOf(const std::optional<std::vector<LatLon>>& places) const
    {
        Outline outline_m;
        for (const LatLon& place : places.value_or(std::vector<LatLon>()))
            outline_m.push_back(m_frame.toPlane(place));
        if (outline_m.size() > 1 && outline_m.front() == outline_m.back())
            outline_m.pop_back();
        return outline_m.size() < 3 ? std::nullopt : std::optional(std::move(outline_m));
    }

    /** Leaves out the smallest areas if a scenario cannot hold all. */
    void keepLargest()
    {
        std::vector<IceArea>& areas = m_chart.areas;
        if (areas.size() <= kMostIceAreas)
            return;
        std::vector<std::size_t> order(areas.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::vector<double> sizes_m2;
        for (const IceArea& area : areas)
            sizes_m2.push_back(std::abs(signedArea(area.outlines_m.front())));
        std::ranges::stable_sort(order, std::greater<>(),
                                 [&](std::size_t i) { return sizes_m2[i]; });
        order.resize(kMostIceAreas);
        std::ranges::sort(order);
        std::vector<IceArea> kept;
        for (const std::size_t i : order)
            kept.push_back(std::move(areas[i]));
        m_result.leftOut += areas.size() - kept.size();
        areas = std::move(kept);
    }

    /** Thins all outlines, more and more until they have few enough corners. */
    void thin()
    {
        constexpr double kFirst_m = 50;
        std::optional<std::vector<IceArea>> areas;
        for (double tolerance_m = kFirst_m; !areas; tolerance_m *= 2) {
            areas = thinnedAreas(m_chart.areas, tolerance_m, m_budget);
            m_result.thinned_m = tolerance_m;
        }
        m_result.leftOut += m_chart.areas.size() - areas->size();
        m_chart.areas = std::move(*areas);
    }

    ReadBudget& m_budget;
    LocalFrame m_frame;
    IceChartResult m_result;
    IceChart m_chart;
};

} // namespace

bool isIceChart(std::string_view text)
{
    const auto holds = [text](std::initializer_list<std::string_view> names) {
        return std::ranges::any_of(
            names, [text](std::string_view name) { return text.find(name) != text.npos; });
    };
    return isGeoJson(text) && holds({"\"CT\"", "\"ct\""}) &&
           holds({"\"POLY_TYPE\"", "\"poly_type\"", "\"SA\"", "\"sa\"", "\"FA\"", "\"fa\""}) &&
           holds({"Polygon"});
}

IceChartResult importIceChart(const Scenario& base, std::string_view bytes,
                              const std::string& subject, const std::stop_token& stop)
{
    ReadBudget budget(subject, bytes.size(), stop);
    const std::string decoded = textOfBytes(bytes, subject);
    const std::string_view text =
        withoutByteOrderMark(decoded.empty() ? bytes : std::string_view(decoded));
    if (!isIceChart(text))
        throw Error(ErrorCode::WrongFormat, subject, {IssueId::NotIceChart});
    IceChartImport import(base, budget);
    import.read(text);
    return import.take();
}

std::string iceChartJson(const IceChartResult& result)
{
    const IceChart& chart = result.scenario.iceChart.value();
    JsonObject object;
    object.add("areas", result.taken);
    object.add("far", result.far);
    object.add("left_out", result.leftOut);
    object.add("rejected", result.rejected.count);
    object.add("thinned_m", result.thinned_m);
    object.add("date_utc", chart.dateUtc);
    object.add("source", chart.source);
    return object.inLines(0) + '\n';
}

} // namespace berg
