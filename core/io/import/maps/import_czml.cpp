#include "core/io/import/fields/import_xml.h"
#include "core/io/import/fields/json_members.h"
#include "core/io/import/maps/map_readers.h"
#include "core/io/text/json_writer.h"

#include <cmath>

namespace berg {

namespace {

constexpr std::string_view kHome = "home/";
constexpr std::string_view kUav = "uav/";
constexpr std::string_view kNoFly = "no-fly/";

/** Returns a property as a text; some writers wrap it in an object that states its type. */
std::string propertyText(const Json& value)
{
    if (value.is_string())
        return value.get<std::string>();
    if (value.is_number() || value.is_boolean())
        return jsonText(value);
    for (const char* type : {"number", "string", "boolean"})
        if (const Json* wrapped = memberOf(&value, type); wrapped && !wrapped->is_structured())
            return propertyText(*wrapped);
    return {};
}

std::string idOf(const Json& packet)
{
    return textOf(memberOf(&packet, "id"));
}

/** Returns the list of longitude, latitude and height, or of a time before each of them. */
const Json* degreesOf(const Json* positions)
{
    return arrayOf(positions, "cartographicDegrees");
}

/** Collects the sightings of one file. */
class CzmlSightings
{
public:
    explicit CzmlSightings(const ImportText& source) : m_source(source), m_names(source.mapping) {}

    SightingTable take()
    {
        m_table.rejected.place = "packet";
        ParsedJson file = parseJson(m_source.text, m_source.budget);
        if (!file.root.is_array())
            throw Error(ErrorCode::WrongFormat, m_source.budget.subject(),
                        {IssueId::WrongType, {ValueKind::Array, kindOf(file.root)}});
        for (const Json& packet : file.root)
            m_isOwn = m_isOwn || (idOf(packet).starts_with(kHome) &&
                                  memberOf(memberOf(&packet, "properties"), "airspeed_mps"));
        forEachReleased(file.root.get_ref<Json::array_t&>(), m_source.budget,
                        [this](const Json& packet) { addPacket(packet); });
        m_names.requireMapped(m_source.budget.subject());
        m_table.idCandidates = m_names.unknown();
        return std::move(m_table);
    }

private:
    void reject(IssueId fault)
    {
        addRow(m_table, RejectedRow{.line = m_packet, .fault = fault, .detail = {}},
               m_source.budget);
    }

    void addPacket(const Json& packet)
    {
        m_source.budget.throwIfStopped();
        ++m_packet;
        const std::string id = idOf(packet);
        if (id == "document")
            return;
        m_texts.clear();
        m_data.clear();
        readProperties(memberOf(&packet, "properties"));
        setName(m_texts, textOf(memberOf(&packet, "name")));
        m_texts.set({.field = SightingField::Id, .rank = kFeatureIdRank}, id);
        const Json* position = memberOf(&packet, "position");
        const Json* degrees = degreesOf(position);
        if (m_isOwn &&
            (id == "area" || id == "asset" || id.starts_with(kHome) || id.starts_with(kNoFly)))
            readOwn(packet, id, degrees);
        else if (m_isOwn && (id.starts_with(kUav) || id == "stand-off" || isOtherKind()))
            return;
        else if (degrees == nullptr)
            reject(position == nullptr ? IssueId::NotAPoint : IssueId::NoPosition);
        else if (degrees->size() <= 3)
            addPoint(*degrees);
        else
            addTrack(*degrees, parseUtc(textOf(memberOf(position, "epoch"))));
    }

    void readProperties(const Json* properties)
    {
        if (properties == nullptr || !properties->is_object())
            return;
        for (const auto& [name, value] : properties->items()) {
            std::string text = propertyText(value);
            if (const std::optional<FieldUse> use =
                    isVectorPart(name) ? std::nullopt : m_names.of(name);
                use && use->field != SightingField::Latitude &&
                use->field != SightingField::Longitude) // the position determines the place
                m_texts.set(*use, text);
            m_data[name] = std::move(text);
        }
    }

    /** Whether the packet of a Bergwatch export is neither an iceberg nor of an older version. */
    [[nodiscard]] bool isOtherKind() const
    {
        const auto kind = m_data.find("kind");
        return kind != m_data.end() && kind->second != "iceberg";
    }

    static bool setPlace(FieldTexts& texts, const Json& longitude, const Json& latitude)
    {
        if (!longitude.is_number() || !latitude.is_number())
            return false;
        texts.set(SightingField::Longitude, jsonText(longitude));
        texts.set(SightingField::Latitude, jsonText(latitude));
        return true;
    }

    void addPoint(const Json& degrees)
    {
        if (degrees.size() < 2 || !setPlace(m_texts, degrees[0], degrees[1])) {
            reject(IssueId::NoPosition);
            return;
        }
        addRow(m_table,
               withData(m_table, sightingIn(m_table, m_source, m_texts, m_packet, false), m_data),
               m_source.budget);
    }

    void addTrack(const Json& degrees, const std::optional<UtcTime>& epoch)
    {
        constexpr std::size_t kStep = 4;
        constexpr double kLongest_s = 1e9;
        const std::size_t first = m_table.sightings.size();
        for (std::size_t i = 0; i + kStep <= degrees.size(); i += kStep) {
            m_source.budget.throwIfStopped();
            FieldTexts texts = m_texts;
            const Json& time = degrees[i];
            if (time.is_string())
                texts.set(SightingField::Time, time.get_ref<const std::string&>());
            else if (epoch && time.is_number() && std::abs(time.get<double>()) < kLongest_s)
                texts.set(SightingField::Time, utcText(*epoch, time.get<double>()));
            if (setPlace(texts, degrees[i + 1], degrees[i + 2]))
                addRow(m_table, sightingIn(m_table, m_source, texts, m_packet, true),
                       m_source.budget);
            else
                reject(IssueId::NoPosition);
        }
        m_tracks.give(m_table, first);
        if (degrees.size() % kStep != 0)
            reject(IssueId::NoPosition);
    }

    /** Reads an object of a Bergwatch export other than an iceberg. */
    void readOwn(const Json& packet, const std::string& id, const Json* degrees)
    {
        if (id == "area") {
            readArea(degreesOf(memberOf(memberOf(&packet, "polyline"), "positions")), false);
            return;
        }
        if (id.starts_with(kNoFly)) {
            readArea(degreesOf(memberOf(memberOf(&packet, "polygon"), "positions")), true);
            return;
        }
        if (degrees != nullptr && degrees->size() >= 2)
            static_cast<void>(setPlace(m_texts, (*degrees)[0], (*degrees)[1]));
        const std::string title = textOf(memberOf(&packet, "name"));
        const OwnPlacemark mark{.title = title,
                                .place = placeOf(m_texts),
                                .time = parseUtc(m_texts.text(SightingField::Time)),
                                .data = m_data};
        if (id == "asset")
            addOwnAsset(m_table.scene, mark);
        else
            addOwnUav(m_table.scene, mark);
    }

    void readArea(const Json* degrees, bool isNoFly)
    {
        constexpr std::size_t kStep = 3;
        SceneArea area = ownArea(m_data, isNoFly);
        area.rings.emplace_back();
        for (std::size_t i = 0; degrees != nullptr && i + kStep <= degrees->size(); i += kStep)
            if ((*degrees)[i].is_number() && (*degrees)[i + 1].is_number())
                if (const auto corner =
                        scenePlace((*degrees)[i + 1].get<double>(), (*degrees)[i].get<double>()))
                    area.rings[0].push_back(*corner);
        if (degrees != nullptr && area.rings[0].size() * kStep == degrees->size())
            m_table.scene.addArea(std::move(area));
        else
            addFinding(m_table.scene.findings, SceneNote::AreaUnreadable);
    }

    const ImportText& m_source;
    ColumnNames m_names;
    SightingTable m_table;
    TrackIds m_tracks;
    bool m_isOwn = false; ///< the file is a Bergwatch export
    std::size_t m_packet = 0;
    FieldTexts m_texts;
    OwnData m_data;
};

} // namespace

SightingTable readCzml(const ImportText& source)
{
    return CzmlSightings(source).take();
}

bool isCzml(std::string_view text)
{
    constexpr std::size_t kHead = 4096;
    return trimmed(text).starts_with('[') &&
           text.substr(0, kHead).find("\"document\"") != std::string_view::npos;
}

} // namespace berg
