#include "core/base/error.h"
#include "core/io/import/fields/area_centroid.h"
#include "core/io/import/fields/import_xml.h"
#include "core/io/import/maps/feature_sightings.h"
#include "core/io/import/maps/kml_geometry.h"
#include "core/io/import/maps/kmz_documents.h"
#include "core/io/import/maps/map_readers.h"
#include "core/io/text/json_writer.h"
#include "core/io/text/zip_file.h"

#include <deque>
#include <utility>

namespace berg {

namespace {

/**
 * Collects the sightings of a KML file or of the documents of an archive, Placemark by Placemark.
 */
class KmlSightings
{
public:
    explicit KmlSightings(const ImportText& source)
        : m_budget(source.budget), m_found(source), m_geometry(source.budget)
    {
    }

    void read(std::string_view text)
    {
        m_found.beginText(text);
        m_inside = false;
        m_folderTimes.clear();
        const XmlEvents events{.opened = [this](XmlPath path) { opened(path); },
                               .closed = [this](XmlPath path) { closed(path); }};
        readXml(text, events, m_budget);
    }

    /** Returns the links of the documents since the last call. */
    std::vector<KmlText> takeLinks() { return std::exchange(m_links, {}); }
    void rejectLink(const KmlText& link)
    {
        reject(link.line, IssueId::LinkNotRead, cleanText(link.text, 200));
    }
    void reject(std::size_t line, IssueId fault, const std::string& detail = {})
    {
        m_found.reject({.line = line, .fault = fault, .detail = detail});
    }
    SightingTable& table() { return m_found.table(); }

    SightingTable take()
    {
        rejectDecimalCommas();
        return m_found.take();
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
        m_found.begin(element.line);
        m_name.clear();
        m_style.clear();
        m_geometry.clear();
        // A name or an id of the extended data names the iceberg better than this id.
        FieldTexts& texts = m_found.texts();
        texts.set({.field = SightingField::Id, .rank = kFeatureIdRank}, element.attribute("id"));
        if (!m_folderTimes.empty())
            texts.set({.field = SightingField::Time, .rank = kFeatureIdRank},
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
            m_found.setProperty(path[path.size() - 2].attribute("name"), element.text);
        else if (element.name == "SimpleData")
            m_found.setProperty(element.attribute("name"), element.text);
    }

    void addLink(XmlPath path)
    {
        if (parentName(path.first(path.size() - 1)) != "NetworkLink")
            return; // link of a model or an image
        m_budget.take(2 * sizeof(KmlText) + path.back().text.capacity());
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
            m_found.texts().set({.field = SightingField::Time, .rank = rank}, text);
        } else if ((of == "Folder" || of == "Document") && !text.empty()) {
            const std::size_t depth = path.size() - 2;
            if (m_folderTimes.empty() || m_folderTimes.back().depth < depth)
                m_folderTimes.push_back({.depth = depth, .text = std::string(text.substr(0, 200))});
        }
    }

    void finish()
    {
        m_inside = false;
        m_found.setTitle(m_name);
        if (!m_found.addToScene(m_style, [this] { return sceneGeometry(); }))
            addPlaces();
    }

    [[nodiscard]] SceneGeometry sceneGeometry() const
    {
        SceneGeometry read;
        if (!m_geometry.points().empty())
            if (const auto tuples = kmlTuples(m_geometry.points().front());
                tuples && !tuples->empty())
                read.place = placeOf(tuples->front().latitude, tuples->front().longitude);
        for (const KmlArea& area : m_geometry.areas()) {
            if (std::optional<std::vector<LatLon>> ring = placesOfTuples(area.outline))
                read.rings.push_back(std::move(*ring));
            read.holes += area.holes.size();
        }
        if (read.rings.size() != m_geometry.areas().size())
            read.rings.clear();
        return read;
    }

    void addPlaces()
    {
        // In a Bergwatch export, a shape of another program is somebody's note and not an iceberg.
        const GeometryKinds kinds{.tracks = !m_geometry.tracks().empty(),
                                  .points = !m_geometry.points().empty(),
                                  .areas = !m_geometry.areas().empty() && !m_found.isOwn(),
                                  .lines = m_geometry.hasLines()};
        if (kinds.tracks)
            addTracks();
        else if (kinds.points)
            addPoints();
        else if (kinds.areas)
            addAreas();
        else
            m_found.reject(IssueId::NotAPoint);
        m_found.noteUnused(kinds);
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
            m_found.reject(hasNumbers ? IssueId::PlaceAmbiguous : IssueId::NoPosition,
                           hasNumbers ? text : std::string());
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
                m_found.reject(IssueId::NotAPoint);
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
        m_found.addPlaces(
            places,
            [](FieldTexts& texts, const KmlTuple& tuple) {
                setPlace(texts, tuple);
                return std::optional<RejectedRow>();
            },
            [this](const KmlTuple& tuple) {
                if (!tuple.mayHaveCommas)
                    return;
                m_budget.take(2 * sizeof(std::size_t));
                m_doubtful.push_back(table().sightings.size() - 1);
            });
    }

    void addTracks()
    {
        const std::size_t first = table().sightings.size();
        bool isEmpty = true;
        for (const KmlTrack& track : m_geometry.tracks()) {
            for (std::size_t i = 0; i < track.coordinates.size(); ++i) {
                isEmpty = false;
                const KmlText& given = track.coordinates[i];
                FieldTexts texts = m_found.texts();
                texts.drop(SightingField::Time);
                if (i < track.whens.size())
                    texts.set(SightingField::Time, track.whens[i]);
                const std::optional<KmlTuple> tuple = kmlCoord(given.text);
                if (tuple)
                    setPlace(texts, *tuple);
                if (tuple || trimmed(given.text).empty())
                    m_found.addTrackPlace(texts, given.line, true);
                else
                    reject(given.line, IssueId::PlaceAmbiguous, cleanText(given.text, 60));
            }
            if (track.whens.size() > track.coordinates.size())
                m_found.note(IssueId::TimesLeft);
        }
        if (isEmpty)
            m_found.reject(IssueId::NoPosition);
        m_found.endTrack(first);
    }

    /** Rejects places of three whole numbers if another place of the file has decimal commas. */
    void rejectDecimalCommas()
    {
        if (!m_hasDecimalCommas || m_doubtful.empty())
            return;
        std::deque<Sighting> kept;
        auto doubtful = m_doubtful.begin();
        for (std::size_t row = 0; row < table().sightings.size(); ++row) {
            Sighting& sighting = table().sightings[row];
            if (doubtful == m_doubtful.end() || *doubtful != row) {
                kept.push_back(std::move(sighting));
                continue;
            }
            ++doubtful;
            table().rejected.add(
                {.line = sighting.line, .fault = IssueId::PlaceAmbiguous, .detail = sighting.id});
        }
        table().sightings = std::move(kept);
    }

    /** Time of a folder, which applies to its content. */
    struct FolderTime
    {
        std::size_t depth = 0;
        std::string text;
    };

    ReadBudget& m_budget;
    FeatureSightings m_found;
    bool m_inside = false; ///< whether a Placemark is open
    std::string m_name;
    std::string m_style;
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
