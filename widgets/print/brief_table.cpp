#include "widgets/print/brief_table.h"

#include "core/base/angles.h"
#include "widgets/print/printable_text.h"
#include "widgets/theme/declination.h"
#include "widgets/theme/mission_clock.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/words/object_names.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kMinuteDecimals = 2; // 18 m
constexpr double kLater_s = 0.5;   // tolerance, because times are in whole seconds

/** A path with its length up to each point. */
class MeasuredPath
{
public:
    explicit MeasuredPath(const ExportUav& uav) : m_path(pathOf(uav))
    {
        for (std::size_t i = 0; i < m_path.size(); ++i)
            m_until_m.push_back(i == 0
                                    ? 0
                                    : m_until_m.back() +
                                          (m_path[i].position_m - m_path[i - 1].position_m).norm());
    }

    [[nodiscard]] double until_m(double time_s) const
    {
        const auto next = std::ranges::upper_bound(m_path, time_s, {}, &TimedPoint::time_s);
        if (next == m_path.begin())
            return 0;
        if (next == m_path.end())
            return m_until_m.back();
        const auto i = static_cast<std::size_t>(next - m_path.begin());
        const double share =
            (time_s - m_path[i - 1].time_s) / (next->time_s - m_path[i - 1].time_s);
        return std::lerp(m_until_m[i - 1], m_until_m[i], share);
    }

    [[nodiscard]] double length_m() const { return m_until_m.back(); }
    [[nodiscard]] const TimedPoint& start() const { return m_path.front(); }
    [[nodiscard]] const TimedPoint& end() const { return m_path.back(); }

private:
    std::vector<TimedPoint> m_path; ///< one point at least
    std::vector<double> m_until_m;
};

void setPlace(BriefCells& cells, const ExportContent& content, const Point& position_m,
              const QLocale& locale)
{
    const LatLon place = content.frame.toGeographic(position_m);
    cells[placeOf(BriefColumn::Latitude)] =
        latitudeText(place.latitude_deg, kMinuteDecimals, locale);
    cells[placeOf(BriefColumn::Longitude)] =
        longitudeText(place.longitude_deg, kMinuteDecimals, locale);
}

/** Sigma of the least certain iceberg of a visit. */
double sigmaAt_m2(const ExportContent& content, const Visit& visit)
{
    double most_m2 = 0;
    for (const IcebergIndex index : icebergsOf(visit)) {
        const ExportIceberg& now = content.icebergs.at(toIndex(index));
        const double ahead_s =
            content.what == ExportScope::Track ? 0 : visit.time_s - content.now_s;
        most_m2 = std::max(most_m2, now.sigmaAfter_m2(ahead_s));
    }
    return most_m2;
}

/** Builds the rows of a route. */
class RouteRows
{
public:
    RouteRows(const ExportContent& content, const MeasuredPath& path, const QLocale& locale)
        : m_content(content), m_path(path), m_locale(locale), m_last(path.start())
    {
        BriefCells cells;
        cells[placeOf(BriefColumn::Name)] = FlightBrief::tr("Start");
        setPlace(cells, content, m_last.position_m, locale);
        cells[placeOf(BriefColumn::Arrival)] = briefClock(content, m_last.time_s);
        m_rows.push_back(cells);
    }

    void add(const TimedPoint& to, BriefCells cells)
    {
        setPlace(cells, m_content, to.position_m, m_locale);
        const Point path_m =
            eastNorth_mps(m_content, to.position_m - m_last.position_m, m_last.position_m);
        const double leg_m = m_path.until_m(to.time_s) - m_path.until_m(m_last.time_s);
        const double leg_s = to.time_s - m_last.time_s;
        if (!path_m.isZero(0))
            setCourse(cells, headingFromPsi(std::atan2(path_m.y(), path_m.x())));
        cells[placeOf(BriefColumn::Leg)] = fixedText(longDistanceUnit().fromSi(leg_m), 2, m_locale);
        cells[placeOf(BriefColumn::LegTime)] = clockText(leg_s);
        if (leg_s > 0 && leg_m > 0)
            cells[placeOf(BriefColumn::GroundSpeed)] =
                fixedText(speedUnit().fromSi(leg_m / leg_s), 1, m_locale);
        cells[placeOf(BriefColumn::Arrival)] = briefClock(m_content, to.time_s);
        m_rows.push_back(std::move(cells));
        m_last = to;
    }

    void add(const Visit& visit)
    {
        BriefCells cells;
        if (!visit.iceberg) {
            cells[placeOf(BriefColumn::Name)] = FlightBrief::tr("Home");
        } else {
            const double sigma_m2 = sigmaAt_m2(m_content, visit);
            cells[placeOf(BriefColumn::Number)] = QString::number(++m_icebergs);
            cells[placeOf(BriefColumn::Name)] = printable(titleOf(m_content, visit));
            cells[placeOf(sigmaColumn())] = significantText(sigma_m2, 3, m_locale);
            cells[placeOf(radiusColumn())] = radius95Text(sigma_m2, m_locale);
        }
        add(TimedPoint{.position_m = visit.position_m, .time_s = visit.time_s}, std::move(cells));
    }

    /** Adds the part of a track after the last visit. */
    void addEnd()
    {
        if (m_path.end().time_s < m_last.time_s + kLater_s)
            return;
        BriefCells cells;
        cells[placeOf(BriefColumn::Name)] = FlightBrief::tr("End of track");
        add(m_path.end(), std::move(cells));
    }

    [[nodiscard]] std::vector<BriefCells> taken() { return std::move(m_rows); }

private:
    void setCourse(BriefCells& cells, double true_deg) const
    {
        cells[placeOf(BriefColumn::Course)] = directionText(true_deg);
        const LatLon from = m_content.frame.toGeographic(m_last.position_m);
        if (const auto declination_deg = shownDeclination_deg(from, m_content.start))
            cells[placeOf(BriefColumn::Magnetic)] = directionText(true_deg - *declination_deg);
    }

    const ExportContent& m_content;
    const MeasuredPath& m_path;
    const QLocale& m_locale;
    TimedPoint m_last;
    int m_icebergs = 0;
    std::vector<BriefCells> m_rows;
};

} // namespace

std::optional<double> briefDeclination_deg(const ExportContent& content)
{
    return shownDeclination_deg(content.frame.toGeographic(content.uavs.front().uav.position_m),
                                content.start);
}

BriefColumn sigmaColumn()
{
    return shownUnits().uncertainty == UncertaintyForm::Sigma ? BriefColumn::FirstUncertainty
                                                              : BriefColumn::SecondUncertainty;
}

BriefColumn radiusColumn()
{
    return shownUnits().uncertainty == UncertaintyForm::Sigma ? BriefColumn::SecondUncertainty
                                                              : BriefColumn::FirstUncertainty;
}

BriefCaptions briefCaptions(const ExportContent& content)
{
    BriefCaptions captions;
    const auto set = [&captions](BriefColumn column, const QString& name,
                                 const QString& unit = {}) {
        captions.names[placeOf(column)] = name;
        captions.units[placeOf(column)] = unit;
    };
    const bool isFlown = content.what == ExportScope::Track;
    set(BriefColumn::Name, FlightBrief::tr("Iceberg"));
    set(BriefColumn::Latitude, FlightBrief::tr("Latitude"));
    set(BriefColumn::Longitude, FlightBrief::tr("Longitude"));
    set(BriefColumn::Course, FlightBrief::tr("Course"), FlightBrief::tr("true"));
    if (briefDeclination_deg(content))
        set(BriefColumn::Magnetic, FlightBrief::tr("Course"), FlightBrief::tr("magnetic"));
    set(BriefColumn::Leg, FlightBrief::tr("Leg"), longDistanceUnit().name);
    set(BriefColumn::LegTime, FlightBrief::tr("Time"));
    set(BriefColumn::GroundSpeed, FlightBrief::tr("Speed", "over ground"), speedUnit().name);
    set(BriefColumn::Arrival, isFlown ? FlightBrief::tr("Reached") : FlightBrief::tr("Arrival"),
        MissionClock{.start = content.start}.isUtc() ? u"UTC"_s : QString());
    set(sigmaColumn(), isFlown ? FlightBrief::tr("σ now") : u"σ"_s, u"m²"_s);
    set(radiusColumn(), u"95 %"_s);
    return captions;
}

BriefRoute briefRoute(const ExportContent& content, std::size_t uav, const QLocale& locale)
{
    const ExportUav& flown = content.uavs.at(uav);
    const MeasuredPath path(flown);
    RouteRows rows(content, path, locale);
    const bool isTrack = content.what == ExportScope::Track;
    for (const Visit& visit : flown.visits)
        if (visit.iceberg || !isTrack) // a track contains no planned flight home
            rows.add(visit);
    if (isTrack)
        rows.addEnd();
    return {.uav = uav,
            .name = areDistinguished(content.uavs) ? printable(titleOf(flown.uav)) : QString(),
            .rows = rows.taken()};
}

QString briefClock(const ExportContent& content, double time_s)
{
    return MissionClock{.start = content.start}.columnText(time_s);
}

PathTotals pathTotals(const ExportUav& uav)
{
    const MeasuredPath path(uav);
    return {.length_m = path.length_m(),
            .time_s = path.end().time_s - path.start().time_s,
            .end_s = path.end().time_s};
}

} // namespace berg
