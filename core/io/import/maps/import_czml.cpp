#include "core/io/import/maps/feature_sightings.h"
#include "core/io/import/maps/map_readers.h"
#include "core/io/text/json_writer.h"

#include <cmath>

namespace berg {

namespace {

/** Returns the list of longitude, latitude and height, or of a time before each of them. */
const Json* degreesOf(const Json* positions)
{
    return arrayOf(positions, "cartographicDegrees");
}

/** Sets the place from two numbers; returns the fault if they are not numbers. */
std::optional<RejectedRow> setPlace(FieldTexts& texts, const Json& longitude, const Json& latitude)
{
    if (!longitude.is_number() || !latitude.is_number())
        return RejectedRow{.fault = IssueId::NoPosition, .detail = {}};
    texts.set(SightingField::Longitude, jsonText(longitude));
    texts.set(SightingField::Latitude, jsonText(latitude));
    return std::nullopt;
}

/** Reads the positions of an area, which are all places or none. */
SceneGeometry ringOf(const Json* degrees)
{
    constexpr std::size_t kStep = 3;
    std::vector<LatLon> ring;
    for (std::size_t i = 0; degrees != nullptr && i + kStep <= degrees->size(); i += kStep)
        if ((*degrees)[i].is_number() && (*degrees)[i + 1].is_number())
            if (const auto corner =
                    scenePlace((*degrees)[i + 1].get<double>(), (*degrees)[i].get<double>()))
                ring.push_back(*corner);
    if (degrees == nullptr || ring.size() * kStep != degrees->size())
        return {};
    return {.rings = {std::move(ring)}};
}

SceneGeometry sceneGeometry(const Json& packet)
{
    for (const char* shape : {"polyline", "polygon"})
        if (const Json* positions = memberOf(memberOf(&packet, shape), "positions"))
            return ringOf(degreesOf(positions));
    const Json* degrees = degreesOf(memberOf(&packet, "position"));
    return {.place = placeOf(degrees, AxisOrder::LongitudeFirst)};
}

/** Collects the sightings of one file. */
class CzmlReader
{
public:
    explicit CzmlReader(const ImportText& source) : m_source(source), m_found(source, "packet") {}

    SightingTable take()
    {
        ParsedJson file = parseJson(m_source.text, m_source.budget);
        if (!file.root.is_array())
            throw Error(ErrorCode::WrongFormat, m_source.budget.subject(),
                        {IssueId::WrongType, {ValueKind::Array, kindOf(file.root)}});
        forEachReleased(file.root.get_ref<Json::array_t&>(), m_source.budget,
                        [this](const Json& packet) { addPacket(packet); });
        return m_found.take();
    }

private:
    void addPacket(const Json& packet)
    {
        m_found.begin(++m_packet);
        const std::string id = textOf(memberOf(&packet, "id"));
        if (id == "document")
            return;
        m_found.setProperties(memberOf(&packet, "properties"));
        m_found.setTitle(textOf(memberOf(&packet, "name")));
        m_found.texts().set({.field = SightingField::Id, .rank = kFeatureIdRank}, id);
        const Json* position = memberOf(&packet, "position");
        const Json* degrees = degreesOf(position);
        if (m_found.addToScene(id, [&packet] { return sceneGeometry(packet); }))
            return;
        if (degrees == nullptr)
            m_found.reject(position == nullptr ? IssueId::NotAPoint : IssueId::NoPosition);
        else if (degrees->size() > 3)
            addTrack(*degrees, parseUtc(textOf(memberOf(position, "epoch"))));
        else if (degrees->size() < 2 || setPlace(m_found.texts(), (*degrees)[0], (*degrees)[1]))
            m_found.reject(IssueId::NoPosition);
        else
            m_found.addPlace(m_found.texts());
    }

    void addTrack(const Json& degrees, const std::optional<UtcTime>& epoch)
    {
        constexpr std::size_t kStep = 4;
        constexpr double kLongest_s = 1e9;
        const std::size_t first = m_found.table().sightings.size();
        for (std::size_t i = 0; i + kStep <= degrees.size(); i += kStep) {
            FieldTexts texts = m_found.texts();
            const Json& time = degrees[i];
            if (time.is_string())
                texts.set(SightingField::Time, time.get_ref<const std::string&>());
            else if (epoch && time.is_number() && std::abs(time.get<double>()) < kLongest_s)
                texts.set(SightingField::Time, utcText(*epoch, time.get<double>()));
            if (setPlace(texts, degrees[i + 1], degrees[i + 2]))
                m_found.reject(IssueId::NoPosition);
            else
                m_found.addTrackPlace(texts, m_packet, true);
        }
        m_found.endTrack(first);
        if (degrees.size() % kStep != 0)
            m_found.reject(IssueId::NoPosition);
    }

    const ImportText& m_source;
    FeatureSightings m_found;
    std::size_t m_packet = 0;
};

} // namespace

SightingTable readCzml(const ImportText& source)
{
    return CzmlReader(source).take();
}

bool isCzml(std::string_view text)
{
    constexpr std::size_t kHead = 4096;
    return trimmed(text).starts_with('[') &&
           text.substr(0, kHead).find("\"document\"") != std::string_view::npos;
}

} // namespace berg
