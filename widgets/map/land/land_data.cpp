#include "widgets/map/land/land_data.h"

#include "core/base/error.h"

#include <QFile>

#include <string_view>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr std::string_view kMagic = "BERGLAND";
constexpr std::uint32_t kVersion = 1;
constexpr std::int32_t kFinestUnits = 100'000; // of a degree
constexpr std::size_t kSmallestRing = 3;       // points
constexpr std::size_t kSmallestPoint = 2;      // bytes

/** Reads from the front; every shortage or nonsense is an `Error`. */
class LandReader
{
public:
    LandReader(std::span<const std::uint8_t> bytes, const std::string& subject)
        : m_rest(bytes), m_subject(subject)
    {
    }

    [[noreturn]] void fail(ErrorCode code, IssueId reason) const
    {
        throw Error(code, m_subject, {reason});
    }

    void check(bool isSound) const
    {
        if (!isSound)
            fail(ErrorCode::FileUnreadable, IssueId::Damaged);
    }

    std::uint8_t byte()
    {
        check(!m_rest.empty());
        const std::uint8_t value = m_rest.front();
        m_rest = m_rest.subspan(1);
        return value;
    }

    /** Little-endian. */
    std::uint32_t number(int bytes)
    {
        std::uint32_t value = 0;
        for (int i = 0; i < bytes; ++i)
            value |= static_cast<std::uint32_t>(byte()) << (8 * i);
        return value;
    }

    std::uint32_t varint()
    {
        std::uint32_t value = 0;
        for (int shift = 0; shift < 28; shift += 7) {
            const std::uint32_t next = byte();
            value |= (next & 0x7FU) << shift;
            if (next < 0x80U)
                return value;
        }
        check(false);
        return 0;
    }

    std::int32_t zigzag()
    {
        const std::uint32_t value = varint();
        const auto half = static_cast<std::int32_t>(value >> 1U);
        return (value & 1U) != 0 ? -half - 1 : half;
    }

    /** A number of things of which each takes at least so many bytes. */
    std::size_t count(std::size_t bytesOfEach)
    {
        const std::size_t value = varint();
        check(value <= m_rest.size() / bytesOfEach);
        return value;
    }

    [[nodiscard]] bool isAtEnd() const { return m_rest.empty(); }

private:
    std::span<const std::uint8_t> m_rest;
    const std::string& m_subject;
};

LandRing ringOf(LandReader& reader, const LandPoint& southWest, std::int32_t side)
{
    const std::size_t count = reader.count(kSmallestPoint);
    reader.check(count >= kSmallestRing);
    LandRing ring;
    ring.reserve(count);
    LandPoint at = southWest;
    for (std::size_t i = 0; i < count; ++i) {
        at.east += reader.zigzag();
        at.north += reader.zigzag();
        reader.check(at.east >= southWest.east && at.east <= southWest.east + side &&
                     at.north >= southWest.north && at.north <= southWest.north + side);
        ring.push_back(at);
    }
    return ring;
}

LandData readLand(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        throw Error(ErrorCode::FileNotFound, path.toStdString(), {IssueId::Missing});
    const QByteArray bytes = file.readAll();
    const std::vector<std::uint8_t> copy(bytes.begin(), bytes.end());
    return LandData(copy, path.toStdString());
}

} // namespace

LandData::LandData(std::span<const std::uint8_t> bytes, const std::string& subject)
{
    LandReader reader(bytes, subject);
    for (const char letter : kMagic)
        if (reader.byte() != static_cast<std::uint8_t>(letter))
            reader.fail(ErrorCode::WrongFormat, IssueId::Damaged);
    if (reader.number(2) != kVersion)
        reader.fail(ErrorCode::UnsupportedVersion, IssueId::OtherVersion);
    m_unitsPerDegree = static_cast<std::int32_t>(reader.number(2));
    const auto side_deg = static_cast<std::int32_t>(reader.number(2));
    reader.check(m_unitsPerDegree > 0 && m_unitsPerDegree <= kFinestUnits);
    reader.check(side_deg > 0 && side_deg <= 180 && 180 % side_deg == 0);
    m_cellSide = side_deg * m_unitsPerDegree;
    const std::uint32_t cells = reader.number(4);
    std::int32_t before = -1;
    for (std::uint32_t i = 0; i < cells; ++i) {
        const std::int32_t row = reader.byte();
        const std::int32_t column = reader.byte();
        const std::int32_t columns = 360 / side_deg;
        const std::int32_t place = row * columns + column;
        reader.check(row < 180 / side_deg && column < columns && place > before);
        before = place;
        LandCell cell{.southWest = {.east = column * m_cellSide, .north = row * m_cellSide},
                      .rings = {}};
        const std::size_t rings = reader.count(kSmallestRing * kSmallestPoint);
        for (std::size_t k = 0; k < rings; ++k)
            cell.rings.push_back(ringOf(reader, cell.southWest, m_cellSide));
        m_cells.push_back(std::move(cell));
    }
    reader.check(reader.isAtEnd());
}

LatLon LandData::placeOf(const LandPoint& point) const
{
    return {static_cast<double>(point.north) / m_unitsPerDegree - 90,
            static_cast<double>(point.east) / m_unitsPerDegree - 180};
}

double LandData::cellSide_deg() const
{
    return static_cast<double>(m_cellSide) / m_unitsPerDegree;
}

bool LandData::isCut(const LandPoint& from, const LandPoint& to) const
{
    return (from.east == to.east && from.east % m_cellSide == 0) ||
           (from.north == to.north && from.north % m_cellSide == 0);
}

const LandData& landData(LandDetail detail)
{
    if (detail == LandDetail::Coarse) {
        static const LandData coarse = readLand(u":/map/land-50m.bin"_s);
        return coarse;
    }
    static const LandData fine = readLand(u":/map/land-10m.bin"_s);
    return fine;
}

} // namespace berg
