#include "core/io/import/airspace/openair_shape.h"

#include "core/base/angles.h"
#include "core/geometry/outline.h"
#include "core/io/import/airspace/openair_values.h"
#include "core/io/import/fields/import_fields.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace berg {

namespace {

constexpr double kArcStep_rad = 3 * kPi / 180;

std::string_view behindEquals(std::string_view value)
{
    return trimmed(value.substr(value.find('=') + 1));
}

} // namespace

bool OpenAirShape::setVariable(std::string_view value)
{
    const std::size_t equals = value.find('=');
    if (equals == std::string_view::npos)
        return false;
    const std::string_view name = trimmed(value.substr(0, equals));
    if (name == "X" || name == "x") {
        m_centre = openAirPlace(behindEquals(value));
        return m_centre.has_value();
    }
    if (name == "D" || name == "d") {
        m_isClockwise = behindEquals(value) == "+";
        return m_isClockwise || behindEquals(value) == "-";
    }
    if (name == "W" || name == "w") {
        m_width_m = openAirRadius_m(behindEquals(value));
        return m_width_m.has_value();
    }
    return true;
}

bool OpenAirShape::add(std::string_view tag, const std::string& value)
{
    if (tag == "DP") {
        const std::optional<LatLon> place = openAirPlace(value);
        if (place)
            addPlace(*place);
        return place.has_value();
    }
    if (tag == "DY")
        return addAirway(value);
    if (!m_centre)
        return false;
    return tag == "DC" ? addCircle(value) : tag == "DA" ? addAngles(value) : addArc(value);
}

bool OpenAirShape::isEmpty() const
{
    return m_line.empty() && m_circles.empty() && m_airway.empty();
}

void OpenAirShape::addPlace(const LatLon& place)
{
    m_budget.take(2 * sizeof(Part)); // a growing list holds two copies
    m_line.push_back({.centre = place});
}

bool OpenAirShape::addAirway(const std::string& value)
{
    const std::optional<LatLon> place = openAirPlace(value);
    if (!place || !m_width_m)
        return false;
    m_budget.take(2 * sizeof *place);
    m_airway.push_back(*place);
    return true;
}

bool OpenAirShape::addCircle(const std::string& value)
{
    const std::optional<double> radius_m = openAirRadius_m(value);
    if (!radius_m)
        return false;
    const Part circle{.centre = *m_centre,
                      .from = {.radius_m = *radius_m, .bearing_rad = 0},
                      .to = {.radius_m = *radius_m, .bearing_rad = 2 * kPi},
                      .isPlace = false};
    const bool isKnown = !m_circles.empty() && m_circles.back().centre == circle.centre &&
                         m_circles.back().from.radius_m == circle.from.radius_m;
    if (isKnown)
        return true;
    m_budget.take(2 * sizeof circle + 200 * sizeof(LatLon));
    m_circles.push_back(circle);
    return true;
}

bool OpenAirShape::addAngles(const std::string& value)
{
    const std::optional<OpenAirAngles> angles = openAirAngles(value);
    if (!angles)
        return false;
    m_budget.take(2 * sizeof(Part) + 200 * sizeof(LatLon));
    m_line.push_back(
        partBetween({.radius_m = angles->radius_m, .bearing_rad = radFromDeg(angles->from_deg)},
                    {.radius_m = angles->radius_m, .bearing_rad = radFromDeg(angles->to_deg)}));
    return true;
}

bool OpenAirShape::addArc(const std::string& value)
{
    constexpr double kLargestRadius_m = 2e6; // a larger radius is an error
    const auto places = openAirPlaces(value);
    if (!places)
        return false;
    const Ray from = rayTo(places->first);
    const Ray to = rayTo(places->second);
    if (!(from.radius_m <= kLargestRadius_m && to.radius_m <= kLargestRadius_m))
        return false;
    addPlace(places->first);
    m_budget.take(2 * sizeof(Part) + 200 * sizeof(LatLon));
    m_line.push_back(partBetween(from, to));
    addPlace(places->second);
    return true;
}

OpenAirShape::Ray OpenAirShape::rayTo(const LatLon& place) const
{
    const Point away_m = LocalFrame(*m_centre).toPlane(place);
    return {.radius_m = away_m.norm(), .bearing_rad = std::atan2(away_m.x(), away_m.y())};
}

OpenAirShape::Part OpenAirShape::partBetween(const Ray& from, Ray to) const
{
    const double turns = (to.bearing_rad - from.bearing_rad) / (2 * kPi);
    const double part = turns - std::floor(turns); // 0 means the whole circle
    to.bearing_rad = from.bearing_rad + 2 * kPi * (!m_isClockwise ? part - 1 : part > 0 ? part : 1);
    return {.centre = *m_centre, .from = from, .to = to, .isPlace = false};
}

void OpenAirShape::appendCurve(std::vector<LatLon>& outline, const Part& part, bool isTangent)
{
    const LocalFrame about(part.centre);
    const double turn_rad = part.to.bearing_rad - part.from.bearing_rad;
    const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(turn_rad) / kArcStep_rad)));
    const auto radiusAt_m = [&](double step) {
        return std::lerp(part.from.radius_m, part.to.radius_m, step / steps);
    };
    const auto append = [&](double step, double radius_m) {
        const double bearing_rad = part.from.bearing_rad + turn_rad * step / steps;
        outline.push_back(about.toGeographic(
            {radius_m * std::sin(bearing_rad), radius_m * std::cos(bearing_rad)}));
    };
    const bool isWhole = std::abs(turn_rad) > 2 * kPi - 1e-9;
    for (int step = 0; step <= steps; ++step) {
        const bool isEnd = step == 0 || step == steps;
        if (!isTangent || (isEnd && !isWhole))
            append(step, radiusAt_m(step));
        if (isTangent && step < steps)
            append(step + 0.5, std::max(radiusAt_m(step), radiusAt_m(step + 1)) /
                                   std::cos(turn_rad / steps / 2));
    }
}

std::vector<LatLon> OpenAirShape::outlineOf(const std::vector<Part>& parts)
{
    const LocalFrame frame(parts.front().centre);
    const auto outline = [&](const auto& isTangent) {
        std::vector<LatLon> places;
        for (const Part& part : parts) {
            if (part.isPlace)
                places.push_back(part.centre);
            else
                appendCurve(places, part, isTangent(part));
        }
        return places;
    };
    std::vector<Point> chords_m;
    for (const LatLon& place : outline([](const Part&) { return false; }))
        chords_m.push_back(frame.toPlane(place));
    const bool isClockwise = signedArea(chords_m) < 0;
    return outline([&](const Part& part) {
        return (part.to.bearing_rad > part.from.bearing_rad) == isClockwise;
    });
}

void OpenAirShape::addLegs(std::vector<std::vector<LatLon>>& outlines) const
{
    for (std::size_t i = 0; i + 1 < m_airway.size(); ++i) {
        const LocalFrame frame(m_airway[i]);
        const std::array leg_m{Point(Point::Zero()), frame.toPlane(m_airway[i + 1])};
        outlines.emplace_back();
        for (const Point& corner_m : grownOutline(leg_m, *m_width_m / 2))
            outlines.back().push_back(frame.toGeographic(corner_m));
    }
}

std::vector<std::vector<LatLon>> OpenAirShape::outlines() const
{
    std::vector<std::vector<LatLon>> outlines;
    if (!m_line.empty())
        outlines.push_back(outlineOf(m_line));
    for (const Part& circle : m_circles)
        outlines.push_back(outlineOf({circle}));
    addLegs(outlines);
    return outlines;
}

} // namespace berg
