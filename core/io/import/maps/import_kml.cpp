#include "core/base/error.h"
#include "core/io/import/fields/area_centroid.h"
#include "core/io/import/maps/feature_parsers.h"
#include "core/io/import/maps/feature_sightings.h"
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
    explicit KmlSightings(const ImportText& source) : m_budget(source.budget), m_found(source) {}

    void read(std::string_view text)
    {
        readKmlFeatures(text, m_budget,
                        {.feature = [this](const KmlFeature& feature) { add(feature); },
                         .link = [this](const KmlText& link) { m_links.push_back(link); }});
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
    void add(const KmlFeature& feature)
    {
        m_found.begin(feature);
        if (!m_found.addToScene(feature))
            addPlaces(*feature.geometry);
    }

    void addPlaces(const KmlGeometry& geometry)
    {
        // In a Bergwatch export, a shape of another program is somebody's note and not an iceberg.
        using Kind = KmlShape::Kind;
        const GeometryKinds kinds{.tracks = geometry.has(Kind::Track),
                                  .points = geometry.has(Kind::Point),
                                  .areas = geometry.has(Kind::Area) && !m_found.isOwn(),
                                  .lines = geometry.has(Kind::Line)};
        if (kinds.tracks)
            addTracks(geometry.shapes());
        else if (kinds.points)
            addPoints(geometry.shapes());
        else if (kinds.areas)
            addAreas(geometry.shapes());
        else
            m_found.reject(IssueId::NotAPoint);
        m_found.noteUnused(kinds);
    }

    static void setPlace(FieldTexts& texts, const KmlTuple& tuple)
    {
        texts.set(SightingField::Longitude, tuple.longitude);
        texts.set(SightingField::Latitude, tuple.latitude);
    }

    void addPoints(const std::vector<KmlShape>& shapes)
    {
        std::vector<KmlTuple> places;
        for (const KmlShape& shape : shapes) {
            if (shape.kind != KmlShape::Kind::Point)
                continue;
            const std::string& text = shape.texts.front().text;
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

    void addAreas(const std::vector<KmlShape>& shapes)
    {
        std::vector<AreaRings> areas;
        for (const KmlShape& shape : shapes) {
            if (shape.kind != KmlShape::Kind::Area)
                continue;
            AreaRings rings;
            for (const KmlText& ring : shape.texts)
                rings.push_back(cornersOf(ring.text));
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

    void addTracks(const std::vector<KmlShape>& shapes)
    {
        const std::size_t first = table().sightings.size();
        bool isEmpty = true;
        for (const KmlShape& track : shapes) {
            for (std::size_t i = 0; track.kind == KmlShape::Kind::Track && i < track.texts.size();
                 ++i) {
                isEmpty = false;
                const KmlText& given = track.texts[i];
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
            if (track.whens.size() > track.texts.size())
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

    ReadBudget& m_budget;
    FeatureSightings m_found;
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
