#include "core/io/import/maps/feature_sightings.h"

#include "core/io/import/fields/geojson_places.h"
#include "core/io/text/json_writer.h"

#include <algorithm>
#include <deque>

namespace berg {

namespace {

double fullTurn(const GeoJsonSystem& system)
{
    return system.unprojected ? 0 : kTurn_deg;
}

/** Returns outline and holes; none if a place is invalid. */
AreaRings ringsOfShape(const FileShape& area)
{
    if (area.rings)
        return area.rings();
    AreaRings rings;
    for (std::size_t part = 0; part < area.parts; ++part) {
        AreaRing& ring = rings.emplace_back();
        for (const LatLon& place : placesOf(area, part).value_or(std::vector<LatLon>()))
            ring.emplace_back(place.longitude_deg, place.latitude_deg);
    }
    return rings;
}

template <class Use>
void eachIceberg(const FileShape& shape, const Use& use)
{
    for (std::size_t i = 0; i < shape.icebergs.count; ++i)
        use(shape.icebergs.at(i));
}

} // namespace

FeatureSightings::FeatureSightings(const ImportText& source, std::string_view place)
    : m_source(source), m_names(source.mapping)
{
    m_table.rejected.place = m_table.noted.place = place;
}

void FeatureSightings::begin(std::size_t line, bool isOwn)
{
    m_source.budget.throwIfStopped();
    m_line = line;
    m_isOwn = isOwn;
    m_title.clear();
    m_texts.clear();
    m_data.clear();
}

bool FeatureSightings::add(const FileFeature& feature)
{
    const bool isNamed = begin(feature);
    if (!feature.broken.empty())
        reject(IssueId::FeatureBroken, feature.broken);
    else if (!addToScene(feature))
        addGeometry(feature.geometry());
    return isNamed;
}

bool FeatureSightings::begin(const FileFeature& feature)
{
    begin(feature.line, feature.isOwn);
    m_texts.set({.field = SightingField::Time, .rank = feature.timeRank}, feature.time);
    setProperties(feature.properties);
    setTitle(feature.name);
    const bool isNamed = !m_texts.text(SightingField::Id).empty();
    m_texts.set({.field = SightingField::Id, .rank = kFeatureIdRank}, feature.id);
    return isNamed;
}

void FeatureSightings::setProperty(const std::string& name, const std::string& text)
{
    setData(name, text);
    const bool isDrift = name == "drift_east_mps" || name == "drift_north_mps";
    if (isDrift || (m_isOwn && isVectorPart(name)))
        return;
    const std::optional<FieldUse> use = m_names.of(name);
    const bool isPlace =
        use && (use->field == SightingField::Latitude || use->field == SightingField::Longitude);
    if (use && (!isPlace || use->rank == 0)) // a place only where the user has mapped it
        m_texts.set(*use, text);
}

void FeatureSightings::setProperties(const Json* properties)
{
    if (properties == nullptr || !properties->is_object())
        return;
    for (const auto& [name, value] : properties->items()) {
        setProperty(name, value.is_boolean() ? std::string() : cellText(value));
        if (value.is_boolean())
            setData(name, jsonText(value));
        if (!value.is_array() || value.size() != 2)
            continue;
        const std::string stem = name.substr(0, name.rfind('_'));
        const std::string unit = name.substr(stem.size());
        setData(std::string(stem).append("_east").append(unit), cellText(value[0]));
        setData(std::string(stem).append("_north").append(unit), cellText(value[1]));
    }
}

void FeatureSightings::setTitle(const std::string& title)
{
    constexpr std::size_t kShown = 500; // the name of a track is set for each of its points
    m_title.assign(title, 0, kShown);
    m_texts.set({.field = SightingField::Id, .rank = kNameRank}, title);
    if (m_texts.text(SightingField::Id) != trimmed(title))
        m_texts.set({.field = SightingField::Name, .rank = kNameRank}, title);
}

bool FeatureSightings::addToScene(const FileFeature& feature)
{
    if (feature.kind.empty() || feature.kind == "iceberg")
        return false;
    addSceneFeature(
        m_table.scene,
        {.feature = feature, .data = m_data, .time = parseUtc(m_texts.text(SightingField::Time))});
    return true;
}

void FeatureSightings::addGeometry(const FileGeometry& geometry)
{
    static const GeoJsonSystem kDegrees;
    const GeoJsonSystem& system = geometry.system ? *geometry.system : kDegrees;
    std::size_t broken = geometry.broken;
    std::vector<AreaRings> areas;
    for (const FileShape& shape : geometry.shapes)
        if (shape.kind == ShapeKind::Area && geometry.hasIcebergAreas) {
            areas.push_back(ringsOfShape(shape));
            if (!centroidOf(areas.back(), fullTurn(system))) {
                areas.pop_back();
                ++broken;
            }
        }
    const auto has = [&geometry](ShapeKind kind) {
        return std::ranges::any_of(geometry.shapes, [kind](const FileShape& shape) {
            return shape.kind == kind && (kind != ShapeKind::Places || shape.icebergs.count > 0);
        });
    };
    const bool hasTracks = has(ShapeKind::Track);
    const bool hasPoints = has(ShapeKind::Places);
    const bool hasLines = has(ShapeKind::Line);
    if (hasTracks)
        addTracks(geometry.shapes);
    else if (hasPoints)
        addPoints(geometry.shapes);
    else if (!areas.empty())
        addAreas(areas, system);
    else if (hasLines && geometry.isRoute)
        addRoute(geometry.shapes);
    else if (broken == 0)
        reject(IssueId::NotAPoint, geometry.other);
    for (std::size_t i = 0; i < broken; ++i)
        reject(IssueId::NoPosition);
    if (hasTracks && (hasPoints || !areas.empty()))
        note(IssueId::TrackAlone);
    else if (hasPoints && (hasLines || !areas.empty()))
        note(IssueId::PointsAlone);
    else if (!areas.empty() && hasLines)
        note(IssueId::AreasAlone);
}

void FeatureSightings::addTracks(const Shapes& shapes)
{
    const std::size_t first = m_table.sightings.size();
    bool isEmpty = true;
    for (const FileShape& track : shapes) {
        if (track.kind != ShapeKind::Track)
            continue;
        eachIceberg(track, [&](const FilePlace& place) {
            isEmpty = false;
            FieldTexts texts = m_texts;
            if (setPlace(texts, place))
                addTrackPlace(texts, place.line > 0 ? place.line : m_line, true);
        });
        if (track.icebergs.timesLeft)
            note(IssueId::TimesLeft);
    }
    if (isEmpty)
        reject(IssueId::NoPosition);
    endTrack(first);
}

void FeatureSightings::addPoints(const Shapes& shapes)
{
    const std::size_t first = m_table.sightings.size();
    std::size_t places = 0;
    bool areTimed = false;
    for (const FileShape& shape : shapes)
        if (shape.kind == ShapeKind::Places) {
            areTimed = shape.icebergs.areTimed;
            eachIceberg(shape, [&](const FilePlace& place) { places += place.fault ? 0U : 1U; });
        }
    if (places > 1 && !areTimed)
        note(IssueId::SeveralPlaces);
    std::uint32_t part = 0;
    for (const FileShape& shape : shapes)
        if (shape.kind == ShapeKind::Places)
            eachIceberg(shape, [&](const FilePlace& place) {
                FieldTexts texts = m_texts;
                if (!setPlace(texts, place))
                    return;
                ++part;
                if (!addPlace(texts))
                    return;
                m_table.sightings.back().part = areTimed ? 1 : part;
                if (!place.mayHaveCommas)
                    return;
                m_source.budget.take(2 * sizeof(std::size_t));
                m_doubtful.push_back(m_table.sightings.size() - 1);
            });
    if (areTimed)
        endTrack(first);
}

void FeatureSightings::addAreas(const std::vector<AreaRings>& areas, const GeoJsonSystem& system)
{
    for (const AreaRings& area : areas)
        for (const Point& corner : area.front()) {
            // The centroid of coordinates in metres could pass for a longitude.
            FieldTexts unused;
            if (!setPlace(unused, filePlace(corner, system)))
                return;
        }
    const std::vector<Point> middles = centroidsOf(areas, fullTurn(system));
    addPoints({{.icebergs = {.count = middles.size(),
                             .at = [&](std::size_t i) { return filePlace(middles[i], system); }}}});
}

void FeatureSightings::addRoute(const Shapes& shapes)
{
    for (const FileShape& shape : shapes)
        if (shape.kind == ShapeKind::Line)
            eachIceberg(shape, [&](const FilePlace& place) {
                FieldTexts texts;
                if (setPlace(texts, place))
                    addTrackPlace(texts, m_line, false);
            });
}

bool FeatureSightings::setPlace(FieldTexts& texts, const FilePlace& place)
{
    if (place.fault) {
        m_hasDecimalCommas = m_hasDecimalCommas || place.mayHaveCommas;
        reject({.line = place.line, .fault = *place.fault, .detail = place.detail});
        return false;
    }
    texts.set(SightingField::Longitude, place.longitude);
    texts.set(SightingField::Latitude, place.latitude);
    if (place.time) {
        texts.drop(SightingField::Time);
        texts.set(SightingField::Time, *place.time);
    }
    return true;
}

bool FeatureSightings::addPlace(const FieldTexts& texts)
{
    const std::size_t before = m_table.sightings.size();
    addRow(m_table, withData(sightingIn(m_table, m_source, texts, m_line, false)), m_source.budget);
    return m_table.sightings.size() > before;
}

void FeatureSightings::addTrackPlace(const FieldTexts& texts, std::size_t line, bool timeNeeded)
{
    m_source.budget.throwIfStopped();
    addRow(m_table, sightingIn(m_table, m_source, texts, line, timeNeeded), m_source.budget);
}

void FeatureSightings::reject(IssueId fault, const std::string& detail)
{
    reject({.line = m_line, .fault = fault, .detail = cleanText(detail, 60)});
}

void FeatureSightings::reject(RejectedRow row)
{
    if (row.line == 0)
        row.line = m_line;
    addRow(m_table, std::move(row), m_source.budget);
}

void FeatureSightings::note(IssueId what)
{
    m_table.noted.add({.line = m_line, .fault = what, .detail = cleanText(m_title, 60)});
}

void FeatureSightings::rejectDecimalCommas()
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

SightingTable FeatureSightings::take()
{
    rejectDecimalCommas();
    m_names.requireMapped(m_source.budget.subject());
    m_table.idCandidates = m_names.unknown();
    return std::move(m_table);
}

std::variant<Sighting, RejectedRow>
FeatureSightings::withData(std::variant<Sighting, RejectedRow> row)
{
    row = withDrift(
        m_table, std::move(row),
        {.east = valueOf(m_data, "drift_east_mps"), .north = valueOf(m_data, "drift_north_mps")});
    if (auto* const sighting = std::get_if<Sighting>(&row)) {
        const std::optional<double> appears_s = numberOf(m_data, "appears_s");
        const std::optional<double> time_s = numberOf(m_data, "time_s");
        sighting->appearsIn_s = appears_s && time_s ? std::optional(*appears_s - *time_s)
                                                    : numberOf(m_data, "appears_in_s");
        sighting->change = changeOf([&](const char* name) { return numberOf(m_data, name); });
    }
    return row;
}

} // namespace berg
