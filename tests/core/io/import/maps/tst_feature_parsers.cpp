#include "core/io/files/scenario_json.h"
#include "core/io/import/fields/area_outline.h"
#include "core/io/import/maps/feature_parsers.h"
#include "core/io/text/atomic_file.h"
#include "tests/support/files/export_text.h"
#include "tests/support/flight/scenario_builder.h"

#include <QtTest>

#include <algorithm>
#include <array>

using namespace berg;
using namespace berg::test;

namespace {

/** A feature as a text, with numbers to what every format keeps. */
struct ReadFeature
{
    std::string kind;
    std::string properties;
    std::vector<Point> places_m; ///< one place, or the corners of an area
};

/** Returns a value as a text; numbers are equal in all formats, however they are written. */
std::string valueText(const Json& value)
{
    const std::string text = value.is_boolean() ? value.dump() : cellText(value);
    bool isNumber = false;
    const double number = QString::fromStdString(text).toDouble(&isNumber);
    return isNumber ? QString::number(number, 'g', 12).toStdString() : text;
}

/** Returns name and value of each property, sorted; vectors as GeoJSON has them are apart. */
std::string propertiesText(const Json* properties)
{
    std::vector<std::string> texts;
    for (const auto& [name, value] : properties->items()) {
        const bool isPair = value.is_array() && value.size() == 2 && value[0].is_number();
        const std::size_t unit = std::min(name.rfind('_'), name.size());
        if (isPair) {
            texts.push_back(name.substr(0, unit) + "_east" + name.substr(unit) + '=' +
                            valueText(value[0]));
            texts.push_back(name.substr(0, unit) + "_north" + name.substr(unit) + '=' +
                            valueText(value[1]));
        } else if (value.is_primitive() && name != "order") { // a list in GeoJSON, else one text
            texts.push_back(name + '=' + valueText(value));
        }
    }
    std::ranges::sort(texts);
    std::string all;
    for (const std::string& text : texts)
        all += text + '\n';
    return all;
}

std::vector<ReadFeature> featuresOf(const std::string& text, const LocalFrame& frame)
{
    std::vector<ReadFeature> features;
    ReadBudget budget("export", text.size());
    const std::optional<MapFormat> format = mapFormatOf(text);
    if (!format)
        return features;
    readMapFeatures(text, *format, budget, [&](const FileFeature& feature) {
        ReadFeature& read = features.emplace_back();
        read.kind = feature.isOwn ? feature.kind : "not ours";
        read.properties = propertiesText(feature.properties);
        std::vector<std::vector<LatLon>> rings;
        for (const FileShape& shape : feature.geometry().shapes) {
            if (shape.kind != ShapeKind::Area && shape.kind != ShapeKind::Places)
                continue;
            const auto places = placesOf(shape, 0);
            if (shape.kind == ShapeKind::Area && places)
                rings.push_back(*places);
            else if (places)
                read.places_m.push_back(frame.toPlane(places->front()));
        }
        if (!rings.empty())
            read.places_m = areaOutline(rings, frame);
    });
    return features;
}

bool isOneOf(const std::string& kind, std::initializer_list<const char*> kinds)
{
    return std::ranges::find(kinds, kind) != kinds.end();
}

} // namespace

/** Tests that the formats of maps are read to one list of features. */
class TestFeatureParsers : public QObject
{
    Q_OBJECT

private slots:
    void exportsAreReadToTheSameFeatures_data()
    {
        QTest::addColumn<QString>("format");
        QTest::addColumn<QString>("scenario");
        for (const char* format : {"geojson", "kml", "czml"})
            for (const char* scenario : {"every-field", "plain"})
                QTest::addRow("%s, %s", format, scenario) << format << scenario;
    }

    /**
     * GeoJSON has the start of a UAV as a feature; the others have a home there, and CZML a path
     * of one place.
     */
    void exportsAreReadToTheSameFeatures()
    {
        QFETCH(QString, format);
        QFETCH(QString, scenario);
        const Scenario loaded =
            loadScenario((BERG_TEST_DATA "/scenarios/" + scenario + ".berg").toStdString());
        const Plan plan = planFromStart(loaded);
        const ExportContent content = exportContent({.scenario = loaded, .plan = plan});
        const LocalFrame frame(loaded.origin);
        const auto listed = [&](const char* id) {
            return featuresOf(findExportFormat(id)->text(content), frame);
        };
        std::vector<ReadFeature> read = listed(qPrintable(format));
        int common = 0;
        for (const ReadFeature& expected : listed("geojson")) {
            if (expected.kind == "uav")
                continue;
            const auto same = std::ranges::find_if(read, [&](const ReadFeature& feature) {
                return feature.kind == expected.kind && feature.properties == expected.properties;
            });
            QVERIFY2(same != read.end(), expected.kind.c_str());
            ++common;
            // Vertices for the map move an outline by less than a metre.
            if (!isOneOf(expected.kind, {"path", "plan", "track"})) // lines
                for (const Point& place_m : expected.places_m)
                    QVERIFY(std::ranges::any_of(same->places_m, [&](const Point& read_m) {
                        return (read_m - place_m).norm() < 1;
                    }));
            read.erase(same);
        }
        QVERIFY(common > 3);
        for (const ReadFeature& feature : read)
            QVERIFY2(isOneOf(feature.kind, {"uav", "home", "plan"}), feature.kind.c_str());
    }
};

QTEST_APPLESS_MAIN(TestFeatureParsers)
#include "tst_feature_parsers.moc"
