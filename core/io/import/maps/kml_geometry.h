#pragma once

// Private to core/io: geometries of a KML Placemark.

#include "core/io/import/fields/import_xml.h"

#include <cstdint>
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

/** A geometry of a Placemark, as text. */
struct KmlShape
{
    enum class Kind : std::uint8_t
    {
        Point, ///< or a Model
        Line,
        Area,
        Track
    };
    Kind kind = Kind::Point;
    /** One text; or an outline, empty if there is none, and holes; or the places of a track. */
    std::vector<KmlText> texts;
    std::vector<std::string> whens; ///< times of the places of a track, in their order
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

    /** Returns the geometries in the order of the file. */
    [[nodiscard]] const std::vector<KmlShape>& shapes() const { return m_shapes; }
    [[nodiscard]] bool has(KmlShape::Kind kind) const;

private:
    KmlText stored(std::size_t line, std::string text);
    void addShape(KmlShape::Kind kind, KmlText text);
    void addCoordinates(XmlPath path);

    ReadBudget& m_budget;
    std::size_t m_memory = 0; ///< bytes of stored texts
    std::vector<KmlShape> m_shapes;
    std::optional<std::size_t> m_area; ///< index of the last polygon
    std::size_t m_track = 0;           ///< index of the last track
    std::string m_longitude;           ///< from the Location of a Model
    std::string m_latitude;
};

} // namespace berg
