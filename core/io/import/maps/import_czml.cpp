#include "core/io/import/maps/feature_parsers.h"
#include "core/io/import/maps/feature_sightings.h"
#include "core/io/import/maps/map_readers.h"
#include "core/io/text/json_writer.h"

#include <cmath>

namespace berg {

namespace {

/** Sets the place from two numbers; returns the fault if they are not numbers. */
std::optional<RejectedRow> setPlace(FieldTexts& texts, const Json& longitude, const Json& latitude)
{
    if (!longitude.is_number() || !latitude.is_number())
        return RejectedRow{.fault = IssueId::NoPosition, .detail = {}};
    texts.set(SightingField::Longitude, jsonText(longitude));
    texts.set(SightingField::Latitude, jsonText(latitude));
    return std::nullopt;
}

/** Collects the sightings of one file. */
class CzmlReader
{
public:
    explicit CzmlReader(const ImportText& source) : m_source(source), m_found(source, "packet") {}

    SightingTable take()
    {
        readCzmlFeatures(m_source.text, m_source.budget,
                         [this](const CzmlFeature& feature) { add(feature); });
        return m_found.take();
    }

private:
    void add(const CzmlFeature& feature)
    {
        m_found.begin(feature);
        const Json* const position = feature.position;
        const Json* const degrees = czmlDegrees(position);
        if (m_found.addToScene(feature))
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
                m_found.addTrackPlace(texts, m_found.line(), true);
        }
        m_found.endTrack(first);
        if (degrees.size() % kStep != 0)
            m_found.reject(IssueId::NoPosition);
    }

    const ImportText& m_source;
    FeatureSightings m_found;
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
