#pragma once

// Private to core/io: geometry of one area of an OpenAir file.

#include "core/earth/geodesy.h"
#include "core/io/text/read_budget.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace berg {

/**
 * Builds the outlines of one area from its records `V`, `DP`, `DC`, `DA`, `DB` and `DY`. Outlines
 * contain the curves: those that bulge outwards are replaced by their tangents, the others by their
 * chords, in steps of three degrees.
 */
class OpenAirShape
{
public:
    explicit OpenAirShape(ReadBudget& budget) : m_budget(budget) {}

    /**
     * Sets a variable. Returns false for a value that cannot be read; variables other than X, D and
     * W are ignored.
     */
    [[nodiscard]] bool setVariable(std::string_view value);
    /** Adds a record. Returns false if it cannot be read, or lacks its centre or width. */
    [[nodiscard]] bool add(std::string_view tag, const std::string& value);
    /** Returns true if no record has added a place, an arc or a circle. */
    [[nodiscard]] bool isEmpty() const;
    /**
     * Returns the outlines: one of the line, one for each circle and one for each leg of an airway.
     */
    [[nodiscard]] std::vector<std::vector<LatLon>> outlines() const;

private:
    /** A place relative to the centre. */
    struct Ray
    {
        double radius_m = 0;
        double bearing_rad = 0; ///< clockwise from north
    };
    /** A curve around `centre`, or with `isPlace` the centre itself. */
    struct Part
    {
        LatLon centre;
        Ray from = {};
        Ray to = {}; ///< its bearing is larger if the curve runs clockwise
        bool isPlace = true;
    };

    void addPlace(const LatLon& place);
    [[nodiscard]] bool addAirway(const std::string& value);
    [[nodiscard]] bool addCircle(const std::string& value);
    [[nodiscard]] bool addAngles(const std::string& value);
    [[nodiscard]] bool addArc(const std::string& value);
    [[nodiscard]] Ray rayTo(const LatLon& place) const;
    [[nodiscard]] Part partBetween(const Ray& from, Ray to) const;
    static void appendCurve(std::vector<LatLon>& outline, const Part& part, bool isTangent);
    [[nodiscard]] static std::vector<LatLon> outlineOf(const std::vector<Part>& parts);
    void addLegs(std::vector<std::vector<LatLon>>& outlines) const;

    ReadBudget& m_budget;
    std::optional<LatLon> m_centre;
    std::optional<double> m_width_m; ///< width of an airway
    bool m_isClockwise = true;
    std::vector<Part> m_line;
    std::vector<Part> m_circles;
    std::vector<LatLon> m_airway;
};

} // namespace berg
