#include "core/base/error.h"
#include "core/io/import/fields/area_centroid.h"
#include "core/io/import/fields/import_xml.h"
#include "core/io/import/maps/kml_geometry.h"
#include "core/io/import/maps/kmz_documents.h"
#include "core/io/import/maps/map_readers.h"
#include "core/io/text/json_writer.h"
#include "core/io/text/zip_file.h"
#include "core/permit/operation.h"

#include <algorithm>
#include <deque>
#include <utility>

namespace berg {

namespace {

bool isOwnKml(std::string_view text)
{
    return text.find("\"airspeed_mps\"") != std::string_view::npos &&
           text.find("<Style id=\"uav-") != std::string_view::npos;
}

/**
 * Collects the sightings of a KML file or of the documents of an archive, Placemark by Placemark.
 */
class KmlSightings
{
public:
    explicit KmlSightings(const ImportText& source)
        : m_source(source), m_names(source.mapping), m_geometry(source.budget)
    {
    }

    void read(std::string_view text)
    {
        m_isOwn = isOwnKml(text);
        m_inside = false;
        m_folderTimes.clear();
        const XmlEvents events{.opened = [this](XmlPath path) { opened(path); },
                               .closed = [this](XmlPath path) { closed(path); }};
        readXml(text, events, m_source.budget);
    }

    /** Returns the links of the documents since the last call. */
    std::vector<KmlText> takeLinks() { return std::exchange(m_links, {}); }
    void rejectLink(const KmlText& link)
    {
        reject(link.line, IssueId::LinkNotRead, cleanText(link.text, 200));
    }
    void reject(std::size_t line, IssueId fault, const std::string& detail = {})
    {
        addRow(m_table, RejectedRow{.line = line, .fault = fault, .detail = detail},
               m_source.budget);
    }
    SightingTable& table() { return m_table; }

    SightingTable take()
    {
        rejectDecimalCommas();
        m_names.requireMapped(m_source.budget.subject());
        m_table.idCandidates = m_names.unknown();
        return std::move(m_table);
    }

private:
    void opened(XmlPath path)
    {
        const XmlElement& element = path.back();
        if (m_inside)
            m_geometry.opened(path);
        if (element.name != "Placemark")
            return;
        m_inside = true;
        m_line = element.line;
        m_texts.clear();
        m_name.clear();
        m_style.clear();
        m_data.clear();
        m_geometry.clear();
        // A name or an id of the extended data names the iceberg better than this id.
        m_texts.set({.field = SightingField::Id, .rank = kFeatureIdRank}, element.attribute("id"));
        if (!m_folderTimes.empty())
            m_texts.set({.field = SightingField::Time, .rank = kFeatureIdRank},
                        m_folderTimes.back().text);
    }

    void closed(XmlPath path)
    {
        const XmlElement& element = path.back();
        const std::string_view parent = parentName(path);
        while (!m_folderTimes.empty() && m_folderTimes.back().depth >= path.size())
            m_folderTimes.pop_back();
        if (element.name == "href" && (parent == "Link" || parent == "Url"))
            addLink(path);
        else if (element.name == "when" || element.name == "begin" || element.name == "end")
            setTime(path);
        if (!m_inside)
            return;
        m_geometry.closed(path);
        if (element.name == "Placemark")
            finish();
        else if (element.name == "name" && parent == "Placemark")
            m_name = element.text;
        else if (element.name == "styleUrl" && parent == "Placemark")
            m_style = trimmed(element.text);
        else if (element.name == "value" && parent == "Data")
            property(path[path.size() - 2].attribute("name"), element.text);
        else if (element.name == "SimpleData")
            property(element.attribute("name"), element.text);
    }

    void addLink(XmlPath path)
    {
        if (parentName(path.first(path.size() - 1)) != "NetworkLink")
            return; // link of a model or an image
        m_source.budget.take(2 * sizeof(KmlText) + path.back().text.capacity());
        m_links.push_back(
            {.line = path.back().line, .text = std::string(trimmed(path.back().text))});
    }

    /**
     * Sets the time of a Placemark, or of the folder or document around it, but not that of a view
     * of it. A span gives its begin, else its end.
     */
    void setTime(XmlPath path)
    {
        const std::string_view parent = parentName(path);
        if (parent != "TimeStamp" && parent != "TimeSpan")
            return;
        const std::string_view of = parentName(path.first(path.size() - 1));
        const std::size_t rank = path.back().name == "end" ? 1 : 0;
        const std::string_view text = trimmed(path.back().text);
        if (of == "Placemark" && m_inside) {
            m_texts.set({.field = SightingField::Time, .rank = rank}, text);
        } else if ((of == "Folder" || of == "Document") && !text.empty()) {
            const std::size_t depth = path.size() - 2;
            if (m_folderTimes.empty() || m_folderTimes.back().depth < depth)
                m_folderTimes.push_back({.depth = depth, .text = std::string(text.substr(0, 200))});
        }
    }

    void property(const std::string& name, const std::string& text)
    {
        m_data[name] = text;
        if (isVectorPart(name))
            return;
        if (const std::optional<FieldUse> use = m_names.of(name))
            m_texts.set(*use, text);
    }

    void finish()
    {
        m_inside = false;
        setName(m_texts, m_name);
        if (m_isOwn && (m_style == "#area" || m_style == "#no-fly" || m_style == "#stand-off" ||
                        m_style == "#asset" || isOfAircraft() || isOfPermit()))
            readOwn();
        else
            addPlaces();
    }

    void addPlaces()
    {
        const bool hasPoints = !m_geometry.points().empty();
        // In a Bergwatch export, a shape of another program is somebody's note and not an iceberg.
        const bool hasAreas = !m_geometry.areas().empty() && !m_isOwn;
        if (!m_geometry.tracks().empty()) {
            addTracks();
        } else if (hasPoints) {
            addPoints();
        } else if (hasAreas) {
            addAreas();
        } else {
            reject(m_line, IssueId::NotAPoint);
        }
        if (!m_geometry.tracks().empty() && (hasPoints || hasAreas))
            note(IssueId::TrackAlone);
        else if (hasPoints && (m_geometry.hasLines() || hasAreas))
            note(IssueId::PointsAlone);
        else if (hasAreas && m_geometry.hasLines())
            note(IssueId::AreasAlone);
    }

    void note(IssueId what)
    {
        m_table.noted.add({.line = m_line, .fault = what, .detail = cleanText(m_name, 60)});
    }

    /**
     * Whether the placemark is airspace or an operation volume, which is rebuilt from a scenario.
     */
    [[nodiscard]] bool isOfPermit() const
    {
        return m_style == "#airspace" ||
               std::ranges::any_of(kVolumePartIds, [&](std::string_view id) {
                   return m_style == "#" + std::string(id);
               });
    }
    [[nodiscard]] bool isOfAircraft() const { return m_style.starts_with("#uav-"); }

    /**
     * Reads a placemark of a Bergwatch export other than an iceberg; paths and visits add nothing.
     */
    void readOwn()
    {
        if (const std::vector<std::string>& points = m_geometry.points(); !points.empty())
            if (const auto tuples = kmlTuples(points.front()); tuples && !tuples->empty())
                setPlace(m_texts, tuples->front());
        const OwnPlacemark mark{.title = m_name,
                                .place = placeOf(m_texts),
                                .time = parseUtc(m_texts.text(SightingField::Time)),
                                .data = m_data};
        if (m_style == "#area" || m_style == "#no-fly")
            readArea();
        else if (m_style == "#asset")
            addOwnAsset(m_table.scene, mark);
        else if (m_data.contains("airspeed_mps"))
            addOwnUav(m_table.scene, mark);
    }

    void readArea()
    {
        SceneArea area = ownArea(m_data, m_style == "#no-fly");
        const std::vector<KmlArea>& given = m_geometry.areas();
        for (const KmlArea& one : given) {
            std::optional<std::vector<LatLon>> ring = placesOfTuples(one.outline);
            if (ring)
                area.rings.push_back(std::move(*ring));
            for (std::size_t i = 0; i < one.holes.size(); ++i)
                addFinding(m_table.scene.findings, SceneNote::AreaHoles);
        }
        if (!area.rings.empty() && area.rings.size() == given.size())
            m_table.scene.addArea(std::move(area));
        else
            addFinding(m_table.scene.findings, SceneNote::AreaUnreadable);
    }

    static void setPlace(FieldTexts& texts, const KmlTuple& tuple)
    {
        texts.set(SightingField::Longitude, tuple.longitude);
        texts.set(SightingField::Latitude, tuple.latitude);
    }

    void addPoints()
    {
        const std::vector<std::string>& points = m_geometry.points();
        std::vector<KmlTuple> places;
        for (const std::string& text : points) {
            std::optional<std::vector<KmlTuple>> tuples = kmlTuples(text);
            if (tuples && tuples->size() == 1) {
                places.push_back(std::move(tuples->front()));
                continue;
            }
            const bool hasNumbers = text.find_first_of("0123456789") != std::string::npos;
            m_hasDecimalCommas = m_hasDecimalCommas || text.find(',') != std::string::npos;
            reject(m_line, hasNumbers ? IssueId::PlaceAmbiguous : IssueId::NoPosition,
                   hasNumbers ? cleanText(text, 60) : std::string());
        }
        addEach(places);
    }

    void addAreas()
    {
        std::vector<AreaRings> areas;
        for (const KmlArea& given : m_geometry.areas()) {
            AreaRings rings{cornersOf(given.outline)};
            for (const std::string& hole : given.holes)
                rings.push_back(cornersOf(hole));
            if (centroidOf(rings, kTurn_deg))
                areas.push_back(std::move(rings));
            else
                reject(m_line, IssueId::NotAPoint);
        }
        std::vector<KmlTuple> places;
        for (const Point& middle : centroidsOf(areas, kTurn_deg))
            places.push_back({.longitude = jsonText(middle.x()), .latitude = jsonText(middle.y())});
        addEach(places);
    }

    /** Returns the corners of a ring; none if one of them is not a place. */
    static AreaRing cornersOf(const std::string& text)
    {
        AreaRing ring;
        for (const LatLon& corner : placesOfTuples(text).value_or(std::vector<LatLon>()))
            ring.emplace_back(corner.longitude_deg, corner.latitude_deg);
        return ring;
    }

    /** Adds the places of one Placemark, each as an iceberg. */
    void addEach(const std::vector<KmlTuple>& places)
    {
        if (places.size() > 1)
            note(IssueId::SeveralPlaces);
        for (std::size_t i = 0; i < places.size(); ++i) {
            const std::size_t before = m_table.sightings.size();
            FieldTexts texts = m_texts;
            setPlace(texts, places[i]);
            addRow(m_table,
                   withData(m_table, sightingIn(m_table, m_source, texts, m_line, false), m_data),
                   m_source.budget);
            if (m_table.sightings.size() == before)
                continue;
            if (places[i].mayHaveCommas) {
                m_source.budget.take(2 * sizeof(std::size_t));
                m_doubtful.push_back(before);
            }
            m_table.sightings.back().part = static_cast<std::uint32_t>(i) + 1;
        }
    }

    void addTracks()
    {
        const std::size_t first = m_table.sightings.size();
        bool isEmpty = true;
        for (const KmlTrack& track : m_geometry.tracks()) {
            for (std::size_t i = 0; i < track.coordinates.size(); ++i) {
                isEmpty = false;
                const KmlText& given = track.coordinates[i];
                FieldTexts texts = m_texts;
                texts.drop(SightingField::Time);
                if (i < track.whens.size())
                    texts.set(SightingField::Time, track.whens[i]);
                const std::optional<KmlTuple> tuple = kmlCoord(given.text);
                if (tuple)
                    setPlace(texts, *tuple);
                if (tuple || trimmed(given.text).empty())
                    addRow(m_table, sightingIn(m_table, m_source, texts, given.line, true),
                           m_source.budget);
                else
                    reject(given.line, IssueId::PlaceAmbiguous, cleanText(given.text, 60));
            }
            if (track.whens.size() > track.coordinates.size())
                note(IssueId::TimesLeft);
        }
        if (isEmpty)
            reject(m_line, IssueId::NoPosition);
        m_tracks.give(m_table, first);
    }

    /** Rejects places of three whole numbers if another place of the file has decimal commas. */
    void rejectDecimalCommas()
    {
        if (!m_hasDecimalCommas || m_doubtful.empty())
            return;
        std::deque<Sighting> kept;
        auto doubtful = m_doubtful.begin();
        for (std::size_t row = 0; row < m_table.sightings.size(); ++row) {
            Sighting& sighting = m_table.sightings[row];
            if (doubtful == m_doubtful.end() || *doubtful != row) {
                kept.push_back(std::move(sighting));
                continue;
            }
            ++doubtful;
            m_table.rejected.add(
                {.line = sighting.line, .fault = IssueId::PlaceAmbiguous, .detail = sighting.id});
        }
        m_table.sightings = std::move(kept);
    }

    /** Time of a folder, which applies to its content. */
    struct FolderTime
    {
        std::size_t depth = 0;
        std::string text;
    };

    const ImportText& m_source;
    ColumnNames m_names;
    bool m_isOwn = false; ///< the file is a Bergwatch export
    SightingTable m_table;
    TrackIds m_tracks;
    bool m_inside = false; ///< whether a Placemark is open
    std::size_t m_line = 0;
    FieldTexts m_texts;
    std::string m_name;
    std::string m_style;
    OwnData m_data;
    KmlGeometry m_geometry;
    std::vector<FolderTime> m_folderTimes;
    std::vector<KmlText> m_links;
    std::vector<std::size_t> m_doubtful; ///< rows whose place may have decimal commas
    bool m_hasDecimalCommas = false;
};

/** Adds the name of a document of an archive to the rows from `from` on. */
void nameDocument(Rejections& rows, std::size_t from, const std::string& name)
{
    for (std::size_t i = from; i < rows.first.size(); ++i) {
        std::string& detail = rows.first[i].detail;
        detail.insert(0, cleanText(name, 200).append(detail.empty() ? "" : ": "));
    }
}

void readDocument(KmlSightings& sightings, KmzDocuments& documents, const KmzDocument& document)
{
    try {
        const std::string text = documents.text(document.name);
        sightings.read(text);
        documents.release(text);
    } catch (const Error& error) {
        const bool isBroken =
            error.code() == ErrorCode::SyntaxError || error.code() == ErrorCode::WrongFormat;
        if (documents.count() == 1 || !isBroken)
            throw;
        sightings.reject(1, IssueId::DocumentBroken);
    }
    for (const KmlText& link : sightings.takeLinks())
        if (!documents.follow(link.text, document.name))
            sightings.rejectLink(link);
}

/** Reads each document of an archive once. */
void readArchive(KmlSightings& sightings, const ImportText& source)
{
    KmzDocuments documents(source.text, source.budget);
    SightingTable& table = sightings.table();
    while (const std::optional<KmzDocument> document = documents.next()) {
        const std::size_t rejected = table.rejected.first.size();
        const std::size_t noted = table.noted.first.size();
        if (!document->isLinked)
            table.noted.add({.line = 1, .fault = IssueId::DocumentUnlinked, .detail = {}});
        readDocument(sightings, documents, *document);
        if (documents.count() == 1)
            continue;
        nameDocument(table.rejected, rejected, document->name);
        nameDocument(table.noted, noted, document->name);
    }
    for (const std::string& name : documents.archives())
        sightings.reject(1, IssueId::ArchiveInArchive, cleanText(name, 200));
}

} // namespace

SightingTable readKml(const ImportText& source)
{
    KmlSightings sightings(source);
    if (isZip(source.text)) {
        readArchive(sightings, source);
        return sightings.take();
    }
    sightings.read(source.text);
    for (const KmlText& link : sightings.takeLinks())
        sightings.rejectLink(link);
    return sightings.take();
}

bool isKml(std::string_view text)
{
    return rootIs(text, "kml");
}

} // namespace berg
