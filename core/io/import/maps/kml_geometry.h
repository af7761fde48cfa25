#pragma once

// Private to core/io: geometries of a KML Placemark.

#include "core/io/import/fields/import_xml.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace berg {

/** A position of KML as text. */
struct KmlTuple
{
    std::string longitude;
    std::string latitude;
    bool mayHaveCommas = false; ///< three whole numbers, or two with commas
};

/**
 * Reads the tuples of `coordinates`: longitude, latitude and optional height separated by commas,
 * which blanks may follow; blanks separate tuples. Returns nullopt if a tuple has another number of
 * values, as with decimal commas.
 */
[[nodiscard]] std::optional<std::vector<KmlTuple>> kmlTuples(std::string_view text);

/**
 * Reads the position of a `gx:coord`: values separated by blanks, or else a tuple as in
 * `kmlTuples`.
 */
[[nodiscard]] std::optional<KmlTuple> kmlCoord(std::string_view text);

/** A text of a file with its line. */
struct KmlText
{
    std::size_t line = 0;
    std::string text;
};

/** A gx:Track: times and places correspond by their order. */
struct KmlTrack
{
    std::vector<std::string> whens;
    std::vector<KmlText> coordinates;
};

/** Texts of a polygon: the outline and its holes. */
struct KmlArea
{
    std::string outline;
    std::vector<std::string> holes;
};

/**
 * Collects the geometries of a Placemark from the events of `readXml` and charges the budget for
 * them.
 */
class KmlGeometry
{
public:
    explicit KmlGeometry(ReadBudget& budget) : m_budget(budget) {}

    void clear();
    void opened(XmlPath path);
    void closed(XmlPath path);

    [[nodiscard]] const std::vector<std::string>& points() const { return m_points; }
    [[nodiscard]] const std::vector<KmlTrack>& tracks() const { return m_tracks; }
    [[nodiscard]] const std::vector<KmlArea>& areas() const { return m_areas; }
    [[nodiscard]] bool hasLines() const { return m_hasLines; }

private:
    std::string stored(std::string text);
    void addCoordinates(XmlPath path);

    ReadBudget& m_budget;
    std::size_t m_memory = 0;          ///< bytes of stored texts
    std::vector<std::string> m_points; ///< coordinates of Points and Models
    std::vector<KmlTrack> m_tracks;
    std::vector<KmlArea> m_areas;
    std::string m_longitude; ///< from the Location of a Model
    std::string m_latitude;
    bool m_hasLines = false;
};

} // namespace berg
