#include "core/land/land_data.h"

#include "core/base/error.h"
#include "core/land/land_bytes.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace berg {
namespace {

constexpr std::string_view kMagic = "BERGLAND";
constexpr std::uint32_t kVersion = 1;
constexpr std::int32_t kFinestUnits = 100'000; // per degree
constexpr std::size_t kSmallestRing = 3;       // points
constexpr std::size_t kSmallestPoint = 2;      // bytes

/** Reads from the front and throws `Error` on missing or invalid data. */
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

    /** Reads a little-endian number. */
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

    /** Reads a count of items that take at least `bytesOfEach` bytes each. */
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

/** Returns how many times the ring winds around the point, counter-clockwise. */
int windings(const LandRing& ring, double east, double north)
{
    int turns = 0;
    LandPoint before = ring.back();
    for (const LandPoint& point : ring) {
        const double side =
            (static_cast<double>(point.east) - before.east) * (north - before.north) -
            (east - before.east) * (static_cast<double>(point.north) - before.north);
        if (before.north <= north && point.north > north && side > 0)
            ++turns;
        else if (before.north > north && point.north <= north && side < 0)
            --turns;
        before = point;
    }
    return turns;
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

bool LandData::contains(const LatLon& place) const
{
    const double turn = 360.0 * m_unitsPerDegree;
    const double turned = std::fmod((place.longitude_deg + 180) * m_unitsPerDegree, turn);
    const double east = turned < 0 ? turned + turn : turned;
    const double north = (place.latitude_deg + 90) * m_unitsPerDegree;
    const auto cellAt = [&](double units) {
        return static_cast<std::int32_t>(std::floor(units / m_cellSide)) * m_cellSide;
    };
    const LandPoint southWest{.east = cellAt(east), .north = cellAt(north)};
    const auto order = [](const LandPoint& a, const LandPoint& b) {
        return a.north != b.north ? a.north < b.north : a.east < b.east;
    };
    const auto cell = std::ranges::lower_bound(m_cells, southWest, order, &LandCell::southWest);
    if (cell == m_cells.end() || cell->southWest != southWest)
        return false;
    int turns = 0;
    for (const LandRing& ring : cell->rings)
        turns += windings(ring, east, north);
    return turns != 0;
}

const LandData& landData(LandDetail detail)
{
    if (detail == LandDetail::Coarse) {
        static const LandData coarse(landBytes(LandDetail::Coarse), "land-50m.bin");
        return coarse;
    }
    static const LandData fine(landBytes(LandDetail::Fine), "land-10m.bin");
    return fine;
}

bool isOnLand(const LatLon& place)
{
    return landData(LandDetail::Fine).contains(place);
}

} // namespace berg
