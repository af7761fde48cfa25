#include "core/base/angles.h"
#include "core/land/land_data.h"
#include "tests/support/window/panel_test.h"
#include "widgets/places/gazetteer.h"

#include <cmath>
#include <limits>
#include <set>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

constexpr double kDegree_km = 111.2;

/** Returns the offset east and north, km; accurate within some hundred kilometres. */
Point offset_km(const LatLon& from, const LatLon& to)
{
    const double east_deg = std::remainder(to.longitude_deg - from.longitude_deg, 360);
    return {east_deg * kDegree_km * std::cos(radFromDeg(from.latitude_deg)),
            (to.latitude_deg - from.latitude_deg) * kDegree_km};
}

double distanceToSegment_km(const Point& a_km, const Point& b_km)
{
    const Point edge_km = b_km - a_km;
    const double length2 = edge_km.squaredNorm();
    const double share = length2 > 0 ? std::clamp(-a_km.dot(edge_km) / length2, 0.0, 1.0) : 0;
    return Point(a_km + share * edge_km).norm();
}

/** Returns the contribution of a ring to the winding number around the origin. */
double turnRound_rad(const Point& a_km, const Point& b_km)
{
    return std::atan2(a_km.x() * b_km.y() - a_km.y() * b_km.x(), a_km.dot(b_km));
}

/** Returns 0 on land. Checks the cell of the place and those beside it. */
double distanceToLand_km(const LandData& land, const LatLon& place)
{
    const double side_deg = land.cellSide_deg();
    double least_km = std::numeric_limits<double>::infinity();
    double turns_rad = 0;
    for (const LandCell& cell : land.cells()) {
        const LatLon corner = land.placeOf(cell.southWest);
        const double east_deg = std::remainder(corner.longitude_deg - place.longitude_deg, 360);
        const double north_deg = corner.latitude_deg - place.latitude_deg;
        if (east_deg < -2 * side_deg || east_deg > side_deg || north_deg < -2 * side_deg ||
            north_deg > side_deg)
            continue;
        for (const LandRing& ring : cell.rings) {
            Point before_km = offset_km(place, land.placeOf(ring.back()));
            for (const LandPoint& point : ring) {
                const Point next_km = offset_km(place, land.placeOf(point));
                least_km = std::min(least_km, distanceToSegment_km(before_km, next_km));
                turns_rad += turnRound_rad(before_km, next_km);
                before_km = next_km;
            }
        }
    }
    return std::abs(turns_rad) > kPi ? 0 : least_km;
}

} // namespace

/** The gazetteer's places against the program's coast. */
class TestGazetteer : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void theFileIsSound()
    {
        std::set<QByteArray> names;
        int before = 1;
        for (const GazetteerPlace& place : gazetteer()) {
            QVERIFY2(names.insert(place.name).second, place.name.constData());
            QVERIFY2(std::abs(place.at.latitude_deg) <= 90, place.name.constData());
            QVERIFY2(std::abs(place.at.longitude_deg) < 180, place.name.constData());
            QVERIFY2(place.rank >= before && place.rank <= 5, place.name.constData());
            before = place.rank;
        }
        for (const char* name :
             {"Bonavista",    "Twillingate", "Fogo",         "St. John's",     "Nain",
              "Halifax",      "White Rose",  "Hibernia",     "Terra Nova",     "Hebron",
              "Tromsø",       "Hammerfest",  "Goliat",       "Johan Castberg", "Snøhvit",
              "Longyearbyen", "Upernavik",   "Ilulissat",    "Nuuk",           "Qaanaaq",
              "Baffin Bay",   "Disko Bay",   "Melville Bay", "Fram Strait"})
            QVERIFY2(names.contains(QByteArray(name)), name);
    }

    /** Towns and capes are on land or at its edge, fields at sea, seas not on land. */
    void placesLieAtTheCoast()
    {
        constexpr double kTown_km = 7; // limit of 1 : 10 million and a hundredth of a degree
        constexpr double kIsland_km = 30;
        constexpr double kField_km = 2;
        constexpr double kSea_km = 1;
        // These are on islands that are too small for the land data.
        const std::set<QByteArray> onIslets{"Cape Horn", "Maniitsoq", "Kangaamiut"};
        const LandData& land = landData(LandDetail::Fine);
        QStringList wrong;
        for (const GazetteerPlace& place : gazetteer()) {
            if (std::abs(place.at.latitude_deg) == 90 || onIslets.contains(place.name))
                continue;
            const double away_km = distanceToLand_km(land, place.at);
            const auto expect = [&](bool isRight) {
                if (!isRight)
                    wrong << QString::fromUtf8(place.name) + u": %1 km from land"_s.arg(away_km);
            };
            switch (place.kind) {
            case PlaceKind::Town:
            case PlaceKind::Cape:
                expect(away_km <= kTown_km);
                break;
            case PlaceKind::Land:
                expect(away_km <= kIsland_km);
                break;
            case PlaceKind::Field:
                expect(away_km >= kField_km);
                break;
            case PlaceKind::Water:
                expect(away_km >= kSea_km);
                break;
            }
        }
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u'\n')));
    }
};

QTEST_MAIN(TestGazetteer)
#include "tst_gazetteer.moc"
