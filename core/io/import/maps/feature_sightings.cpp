#include "core/io/import/maps/feature_sightings.h"

#include "core/io/text/json_writer.h"

namespace berg {

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

void FeatureSightings::noteUnused(const GeometryKinds& kinds)
{
    if (kinds.tracks && (kinds.points || kinds.areas))
        note(IssueId::TrackAlone);
    else if (kinds.points && (kinds.lines || kinds.areas))
        note(IssueId::PointsAlone);
    else if (kinds.areas && kinds.lines)
        note(IssueId::AreasAlone);
}

SightingTable FeatureSightings::take()
{
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

std::optional<LatLon> placeOf(std::string_view latitude, std::string_view longitude)
{
    FieldTexts texts;
    texts.set(SightingField::Latitude, latitude);
    texts.set(SightingField::Longitude, longitude);
    const std::variant<Sighting, RejectedRow> row = sightingOf(texts, {}, 0);
    const auto* const sighting = std::get_if<Sighting>(&row);
    return sighting == nullptr ? std::nullopt : std::optional(sighting->place);
}

} // namespace berg
