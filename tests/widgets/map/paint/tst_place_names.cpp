#include "core/presets/presets.h"
#include "tests/support/window/panel_test.h"
#include "widgets/map/paint/map_layout.h"
#include "widgets/map/picture/scenario_picture.h"

#include <algorithm>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

const QRectF kMap(0, 0, 900, 600);
constexpr LatLon kBonavista{48.52, -53.15}; // between it and Trinity

MapPicture pictureAt(const LatLon& origin, int icebergs = 0)
{
    Scenario scenario = randomScenario(3, {.icebergs = std::max(icebergs, 1)});
    scenario.origin = origin;
    if (icebergs == 0)
        scenario.icebergs.clear();
    return withScenario({}, scenario);
}

MapLayout layoutOf(const MapPicture& picture, double metresInPixel, const MapLayers& layers = {})
{
    static const Theme theme = Theme::light();
    return arrangeMap(picture, {.theme = theme, .locale = QLocale::c(), .layers = layers}, kMap,
                      MapViewTransform({0, 0}, kMap.center(), 1 / metresInPixel));
}

QStringList namesOn(const MapLayout& map)
{
    QStringList names;
    for (const MapPlaceName& name : map.places)
        names << placeName(*name.place);
    return names;
}

} // namespace

class TestPlaceNames : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    /** Villages on the map of a bay, seas on that of the ocean. */
    void namesSuitTheScale()
    {
        const MapPicture picture = pictureAt(kBonavista);
        const QStringList bay = namesOn(layoutOf(picture, 100));
        QVERIFY(bay.contains(u"Bonavista"_s) && bay.contains(u"Trinity"_s));
        QVERIFY(!bay.contains(u"Labrador Sea"_s)); // out of sight
        const QStringList ocean = namesOn(layoutOf(picture, 5000));
        QVERIFY(ocean.contains(u"Labrador Sea"_s) && ocean.contains(u"Grand Banks"_s));
        QVERIFY(!ocean.contains(u"Trinity"_s));
        const QStringList world = namesOn(layoutOf(picture, 20'000));
        QVERIFY(world.contains(u"Barents Sea"_s) && !world.contains(u"Halifax"_s));
        QVERIFY(!world.contains(u"Ross Sea"_s)); // beyond what a map shows
        const MapPicture strait = pictureAt({79.05, 0.1});
        QVERIFY(namesOn(layoutOf(strait, 1000)).contains(u"Fram Strait"_s));
        QVERIFY(namesOn(layoutOf(strait, 20)).isEmpty()); // its middle is nowhere in particular
    }

    void namesAvoidPanelsAndSymbols()
    {
        for (const double metres : {20.0, 100.0, 500.0, 3000.0}) {
            const MapPicture picture = pictureAt({49.7, -54.2}, 40);
            const MapLayout map = layoutOf(picture, metres);
            for (std::size_t i = 0; i < map.places.size(); ++i) {
                const QRectF& name = map.places[i].rect;
                QVERIFY(kMap.contains(name));
                for (std::size_t k = 0; k < i; ++k)
                    QVERIFY(!name.intersects(map.places[k].rect));
                for (const QRectF& panel : map.overlays())
                    QVERIFY(!name.intersects(panel));
                for (const PlacedLabel& label : map.labels)
                    QVERIFY(!name.intersects(label.rect));
                for (const LabelDisk& symbol : map.icebergs)
                    QVERIFY(!overlaps(name, symbol));
            }
            QVERIFY(metres > 1000 || metres < 50 || !map.places.empty());
        }
    }

    /** An asset that is a place of the gazetteer has its name from the scenario. */
    void theAssetIsNamedOnce()
    {
        MapPicture picture = pictureAt({46.75, -48.70});
        QVERIFY(namesOn(layoutOf(picture, 100)).contains(u"Hibernia"_s));
        picture.asset = MapAsset{.name = u"Hibernia"_s,
                                 .position_m = LocalFrame(picture.origin).toPlane({46.75, -48.78}),
                                 .range_m = 5000,
                                 .alarm_m = 2000};
        const QStringList names = namesOn(layoutOf(picture, 100));
        QVERIFY(!names.contains(u"Hibernia"_s));
        QVERIFY(names.contains(u"Terra Nova"_s));
    }

    void hiddenNamesTakeNoTime()
    {
        MapLayers layers;
        layers.set(MapLayer::Places, 0);
        QVERIFY(layoutOf(pictureAt(kBonavista), 100, layers).places.empty());
    }
};

QTEST_MAIN(TestPlaceNames)
#include "tst_place_names.moc"
