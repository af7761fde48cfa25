#include "core/base/random.h"
#include "core/io/files/scenario_json.h"
#include "tests/support/approx.h"
#include "tests/support/flight/scenario_builder.h"
#include "tests/support/window/panel_test.h"
#include "widgets/map/paint/graticule.h"
#include "widgets/panels/fields/number_field.h"
#include "widgets/panels/icebergs/iceberg_table_columns.h"
#include "widgets/panels/icebergs/iceberg_table_model.h"
#include "widgets/panels/inspector/inspector_panel.h"
#include "widgets/panels/inspector/inspector_row_makers.h"
#include "widgets/places/places.h"
#include "widgets/theme/declination.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/words/field_names.h"
#include "widgets/words/issue_text.h"

#include <QLabel>
#include <QTemporaryDir>
#include <QTranslator>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

constexpr Units kAtSea{.distance = DistanceUnit::Nautical, .speed = SpeedUnit::Knots};
constexpr Units kAtSeaByComponents{.distance = DistanceUnit::Nautical,
                                   .speed = SpeedUnit::Knots,
                                   .vectors = VectorForm::Components};
const QLocale kEnglish(QLocale::English, QLocale::UnitedStates);
const QLocale kNorwegian(QLocale::NorwegianBokmal, QLocale::Norway);

Scenario oneIceberg()
{
    Scenario scenario = test::emptySea();
    // Numbers that no field shows all digits of.
    test::addIceberg(scenario, 1234.56789012345, -98765.4321098765).velocity_mps =
        Point(0.123456789, -0.31415926535);
    return scenario;
}

} // namespace

class TestUnitSettings : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void init()
    {
        test::failOnWarnings();
        setShownUnits({});
    }
    void cleanup() { setShownUnits({}); }

    void settingsSelectUnits()
    {
        const QTemporaryDir folder;
        QSettings settings(folder.filePath(u"s.ini"_s), QSettings::IniFormat);
        QVERIFY(readUnits(settings) == Units());
        settings.setValue(kDistanceUnitKey, u"nautical"_s);
        settings.setValue(kCoordinateFormKey, u"seconds"_s);
        QVERIFY(readUnits(settings) ==
                (Units{.distance = DistanceUnit::Nautical,
                       .coordinates = CoordinateForm::DegreesMinutesSeconds}));
        settings.setValue(kSpeedUnitKey, u"knots"_s);
        settings.setValue(kCoordinateFormKey, u"decimal"_s);
        QVERIFY(readUnits(settings).speed == SpeedUnit::Knots);
        QVERIFY(readUnits(settings).coordinates == CoordinateForm::DecimalDegrees);
        QVERIFY(readUnits(settings).vectors == VectorForm::Direction);
        settings.setValue(kVectorFormKey, u"components"_s);
        QVERIFY(readUnits(settings).vectors == VectorForm::Components);
        QVERIFY(readUnits(settings).height == HeightUnit::Metres);
        settings.setValue(kHeightUnitKey, u"feet"_s);
        settings.setValue(kNorthFormKey, u"typed"_s);
        settings.setValue(kDeclinationKey, -16.7);
        QVERIFY(readUnits(settings).height == HeightUnit::Feet);
        QVERIFY(readUnits(settings).north == NorthForm::Typed);
        QCOMPARE(readDeclination_deg(settings), -16.7);
        settings.setValue(kDeclinationKey, 1e9);
        QCOMPARE(readDeclination_deg(settings), 180.0);
        settings.setValue(kDeclinationKey, u"west"_s);
        QCOMPARE(readDeclination_deg(settings), 0.0);
        settings.setValue(kNorthFormKey, u"model"_s);
        QVERIFY(readUnits(settings).north == NorthForm::Model);
        QVERIFY(readUnits(settings).times == TimeForm::Utc);
        settings.setValue(kTimeFormKey, u"elapsed"_s);
        QVERIFY(readUnits(settings).times == TimeForm::Elapsed);
        QVERIFY(readUnits(settings).uncertainty == UncertaintyForm::Sigma);
        settings.setValue(kUncertaintyFormKey, u"radius"_s);
        QVERIFY(readUnits(settings).uncertainty == UncertaintyForm::Radius95);
        settings.setValue(kDistanceUnitKey, u"furlongs"_s);
        QVERIFY(readUnits(settings).distance == DistanceUnit::Metric);
    }

    void textsUseTheSelectedUnits()
    {
        QCOMPARE(distanceText(1852, kEnglish), u"1.85 km"_s);
        QCOMPARE(offsetText(-1234.4, kEnglish), u"-1\u202f234 m"_s);
        QCOMPARE(speedText(0.514444, kEnglish), u"0.51 m/s"_s);
        setShownUnits(kAtSea);
        QCOMPARE(distanceText(1852, kEnglish), u"1.00 nmi"_s);
        QCOMPARE(distanceText(18, kNorwegian), u"0,00972 nmi"_s); // small ones too: never mixed
        QCOMPARE(distanceText(1852, kEnglish, 3, DistanceUnit::Metric), u"1.85 km"_s);
        QCOMPARE(offsetText(-1234.4, kEnglish), u"-0.667 nmi"_s);
        QCOMPARE(speedText(0.5144444, kEnglish), u"1.0 kn"_s);
    }

    void heightsAreInMetresOrFeet()
    {
        QCOMPARE(heightText(100, kEnglish), u"100 m"_s);
        QCOMPARE(heightsText(0, 1524, kEnglish), u"0 m to 1.52 km (0 to 5\u202f000 ft)"_s);
        setShownUnits({.height = HeightUnit::Feet});
        QCOMPARE(heightText(100, kEnglish), u"328 ft"_s);
        QCOMPARE(heightText(1524, kNorwegian), u"5\u202f000 ft"_s);
        QCOMPARE(heightsText(0, 1524, kEnglish), u"0 to 5\u202f000 ft (0 m to 1.52 km)"_s);
        QCOMPARE(heightsText(304.8, std::nullopt, kEnglish), u"from 1\u202f000 ft (305 m)"_s);
        QCOMPARE(distanceText(100, kEnglish), u"100 m"_s); // a height is no distance
    }

    void coursesAreByTrueOrMagneticNorth()
    {
        QCOMPARE(courseText(45, std::nullopt), u"045°"_s);
        QCOMPARE(courseText(45, -18), u"045° T / 063° M"_s); // west of north: more
        QCOMPARE(courseText(10, 20.4), u"010° T / 350° M"_s);
        QCOMPARE(courseText(350, -20), u"350° T / 010° M"_s);
        QCOMPARE(declinationText(-16.69, kNorwegian), u"16,7° W"_s);
        const LatLon bonavista{.latitude_deg = 48.65, .longitude_deg = -53.1};
        const SunTime november = std::chrono::sys_days(std::chrono::year(2026) / 11 / 28);
        QVERIFY(!shownDeclination_deg(bonavista, november));
        setShownUnits({.north = NorthForm::Typed});
        setTypedDeclination(-17.5);
        COMPARE_NEAR(shownDeclination_deg(bonavista, std::nullopt).value(), -17.5, 1e-12);
        setShownUnits({.north = NorthForm::Model});
        COMPARE_NEAR(shownDeclination_deg(bonavista, november).value(), -16.69, 0.01);
        QVERIFY(!shownDeclination_deg(bonavista, std::nullopt)); // the model needs a date
        QVERIFY(!shownDeclination_deg(bonavista, november + std::chrono::years(4)));
    }

    /** Every field of a height has the unit, and stores what is typed as metres. */
    void heightsInTheInspector()
    {
        setShownUnits({.height = HeightUnit::Feet});
        ScenarioDocument document;
        Scenario scenario = test::emptySea();
        scenario.uavs.front().spec.altitude_m = 100;
        scenario.groundStation = GroundStation{};
        document.reset(scenario);
        Selection selection;
        InspectorPanel panel(document, selection);
        panel.show();
        QCOMPARE(test::child<NumberField>(panel, u"ground_station.antenna_m"_s).suffix(), u" ft"_s);
        selection.set({scenario.uavs.front().id});
        auto& altitude = test::child<NumberField>(panel, u"uavs.altitude_m"_s);
        QCOMPARE(altitude.suffix(), u" ft"_s);
        COMPARE_NEAR(altitude.value(), 328.1, 0.05);
        QVERIFY(altitude.toolTip().contains(u"98 ft"_s)); // 30 m
        test::enter(altitude, u"500"_s);
        QCOMPARE(document.scenario().uavs[0].spec.altitude_m, 500 * 0.3048);
        QCOMPARE(fieldValue("uavs[0].altitude_m", 30.0, kEnglish), u"98.4 ft"_s);
        const Issue entered{Severity::Warning,
                            "airspace[0].area_m",
                            {.id = IssueId::AirspaceEntered,
                             .arguments = {std::string("D 1"), Amount{304.8, Quantity::Height}}}};
        QVERIFY(issueText(entered, kEnglish).contains(u"begins at 1\u202f000 ft"_s));
        QCOMPARE(fieldValue("no_fly[0].floor_m", 304.8, kEnglish), u"1\u202f000 ft"_s);
    }

    /** The radius of 95 % is 2.4477 standard deviations. */
    void uncertaintyIsSigmaOrRadius()
    {
        QCOMPARE(uncertaintyText(5, kEnglish), u"σ 5.00 m² (95 % within 5.47 m)"_s);
        QCOMPARE(radius95Text(150.0 * 150, kEnglish), u"367 m"_s);
        QCOMPARE(radius95Text(500.0 * 500, kEnglish), u"1.22 km"_s);
        setShownUnits({.uncertainty = UncertaintyForm::Radius95});
        QCOMPARE(uncertaintyText(5, kNorwegian), u"95 % within 5,47 m (σ 5,00 m²)"_s);
        setShownUnits(kAtSea);
        QCOMPARE(radius95Text(150.0 * 150, kEnglish), u"0.198 nmi"_s);
        QCOMPARE(radius95Text(5, kEnglish), u"5.47 m"_s);
    }

    void largeZetaIsInSquareKilometres()
    {
        QCOMPARE(zetaText(84423, kEnglish), u"84\u202f420 m² s"_s);
        QCOMPARE(zetaText(16e9, kEnglish), u"16\u202f000 km² s"_s);
        QCOMPARE(zetaText(1e6, kEnglish, 2), u"1.0 km² s"_s);
        QCOMPARE(zetaText(-999999, kEnglish, 2), u"-1\u202f000\u202f000 m² s"_s);
    }

    /** West is O in French: it is shown, and read again. */
    void frenchLettersAreReadAgain()
    {
        class West : public QTranslator
        {
        public:
            [[nodiscard]] bool isEmpty() const override { return false; }
            [[nodiscard]] QString translate(const char*, const char* source, const char*,
                                            int) const override
            {
                return qstrcmp(source, "%1 W") == 0 ? u"%1 O"_s : QString();
            }
        };
        const LatLon place{.latitude_deg = 48.75, .longitude_deg = -53};
        West west;
        QCoreApplication::installTranslator(&west);
        const QString shown = placeText(place, 3, kEnglish);
        const auto found = findPlace(shown);
        const auto half = typedPlace(longitudeText(-53, 3, kEnglish), PlaceHalf::Longitude, place);
        QCoreApplication::removeTranslator(&west);
        QCOMPARE(shown, u"48° 45.000′ N  53° 00.000′ O"_s);
        const auto* read = std::get_if<FoundPlace>(&found);
        QVERIFY(read != nullptr);
        COMPARE_NEAR(read->at.longitude_deg, -53, 1e-9);
        QVERIFY(std::holds_alternative<LatLon>(half));
        COMPARE_NEAR(std::get<LatLon>(half).longitude_deg, -53, 1e-9);
    }

    void placesUseTheSelectedForm()
    {
        const LatLon place{.latitude_deg = 47.0533333, .longitude_deg = -(48 + 59.9999 / 60)};
        QCOMPARE(placeText(place, 1, kEnglish), u"47° 03.2′ N  49° 00.0′ W"_s);
        setShownUnits({.coordinates = CoordinateForm::DecimalDegrees});
        QCOMPARE(placeText(place, 1, kNorwegian), u"47,053° N  49,000° W"_s);
        setShownUnits({.coordinates = CoordinateForm::DegreesMinutesSeconds});
        QCOMPARE(placeText(place, 2, kEnglish), u"47° 03′ 12″ N  49° 00′ 00″ W"_s);
    }

    /** 1 nmi is 1852 m and 1 kn is 1852 m in an hour, to the last bit of the division. */
    void typedValuesAreConvertedExactly()
    {
        setShownUnits(kAtSea);
        QCOMPARE(distanceUnit().toSi(10), 18520.0);
        QCOMPARE(speedUnit().toSi(1), 1852.0 / 3600);
        QCOMPARE(speedUnit().toSi(9), 4.63);
        QCOMPARE(areaUnit().toSi(1), 1852.0 * 1852);
    }

    void typedInTheInspector()
    {
        setShownUnits(kAtSeaByComponents);
        ScenarioDocument document;
        document.reset(oneIceberg());
        Selection selection;
        InspectorPanel panel(document, selection);
        panel.show();
        selection.set({document.scenario().icebergs[0].id});
        auto& east = test::child<NumberField>(panel, u"icebergEast"_s);
        QCOMPARE(east.suffix(), u" nmi"_s);
        COMPARE_NEAR(east.value(), 1234.56789012345 / 1852, 0.00006); // four decimals
        test::enter(east, u"2.5"_s);
        QCOMPARE(document.scenario().icebergs[0].position_m.x(), 4630.0);
        auto& drift = test::child<NumberField>(panel, u"icebergVelocityEast"_s);
        QCOMPARE(drift.suffix(), u" kn"_s);
        test::enter(drift, u"0.9"_s);
        QCOMPARE(document.scenario().icebergs[0].velocity_mps.x(), 0.9 * 1852 / 3600);
        const std::string text = scenarioToJson(document.scenario());
        QVERIFY(scenarioFromJson(text, "test").icebergs[0].position_m.x() == 4630.0);
        QVERIFY(test::child<QLabel>(panel, u"icebergDrift"_s).text().contains(u" kn "_s));
    }

    void leavingAFieldChangesNothing_data()
    {
        QTest::addColumn<QString>("name");
        for (const char* name :
             {"icebergEast", "icebergNorth", "icebergVelocityEast", "icebergVelocityNorth",
              "icebergVelocitySpeed", "icebergVelocityDirection", "icebergs.radius_m"})
            QTest::newRow(name) << QString::fromLatin1(name);
    }

    void leavingAFieldChangesNothing()
    {
        QFETCH(QString, name);
        setShownUnits(name.endsWith(u"East"_s) || name.endsWith(u"North"_s) ? kAtSeaByComponents
                                                                            : kAtSea);
        const Scenario before = oneIceberg();
        ScenarioDocument document;
        document.reset(before);
        Selection selection;
        InspectorPanel panel(document, selection);
        panel.show();
        selection.set({before.icebergs[0].id});
        auto& field = test::child<NumberField>(panel, name);
        field.setFocus();
        QTest::keyClick(&field, Qt::Key_Return);
        field.clearFocus();
        test::enter(field, field.cleanText()); // the digits shown are not the number
        QVERIFY(document.scenario() == before);
    }

    /** Every value that can be typed can be stored. */
    void limitsStayInside()
    {
        setShownUnits(kAtSea);
        for (const double high : {5.0, 1e6, 50.0, 0.1}) {
            for (const ShownUnit& unit : {distanceUnit(), speedUnit()}) {
                const Limits limits = shownLimits({.low = -high, .high = high}, unit, 3);
                QVERIFY(unit.toSi(limits.high) <= high);
                QVERIFY(unit.toSi(limits.low) >= -high);
            }
        }
    }

    void tableShowsAndReadsTheSelectedUnits()
    {
        setShownUnits(kAtSea);
        const Scenario before = oneIceberg();
        ScenarioDocument document;
        document.reset(before);
        IcebergTableModel model(document, QLocale::c());
        const auto at = [&](IcebergColumn column) {
            return model.index(0, static_cast<int>(column));
        };
        QCOMPARE(
            model.headerData(static_cast<int>(IcebergColumn::East), Qt::Horizontal, Qt::DisplayRole)
                .toString(),
            u"East, nmi"_s);
        QCOMPARE(at(IcebergColumn::East).data().toString(), u"0.667"_s);
        for (const IcebergColumn column : {IcebergColumn::East, IcebergColumn::North,
                                           IcebergColumn::Speed, IcebergColumn::Direction})
            model.setData(at(column), at(column).data(Qt::EditRole), Qt::EditRole);
        QVERIFY(document.scenario() == before);
        model.setData(at(IcebergColumn::East), 10.0, Qt::EditRole);
        QCOMPARE(document.scenario().icebergs[0].position_m.x(), 18520.0);
        model.setData(at(IcebergColumn::Speed), 1.0, Qt::EditRole);
        COMPARE_NEAR(document.scenario().icebergs[0].velocity_mps.norm(), 1852.0 / 3600, 1e-15);
    }

    void copiedAndPastedInTheTable()
    {
        setShownUnits(kAtSea);
        Random random(5, 1);
        Scenario before = test::emptySea();
        for (int i = 0; i < 40; ++i)
            test::addIceberg(before, random.uniform(-1e6, 1e6), random.uniform(-1e6, 1e6))
                .velocity_mps = Point(random.uniform(-3, 3), random.uniform(-3, 3));
        ScenarioDocument document;
        document.reset(before);
        IcebergTableModel model(document, QLocale::c());
        std::vector<int> rows;
        for (int row = 0; row < model.rowCount(); ++row)
            rows.push_back(row);
        const std::vector<int> columns{static_cast<int>(IcebergColumn::East),
                                       static_cast<int>(IcebergColumn::North),
                                       static_cast<int>(IcebergColumn::Speed)};
        const QString text = model.copied(rows, columns);
        QVERIFY(text.startsWith(u"East, nmi\t"_s));
        const PasteOutcome outcome = model.paste(text, 0, columns.front(), columns);
        QCOMPARE(outcome.fault, QString());
        QVERIFY(document.scenario() == before);
    }

    /** Lines of the graticule have different numbers in every form, at every scale. */
    void graticuleUsesTheSelectedForm()
    {
        const LocalFrame frame({47.03, -48.11});
        for (const CoordinateForm form :
             {CoordinateForm::DecimalDegrees, CoordinateForm::DegreesMinutes,
              CoordinateForm::DegreesMinutesSeconds}) {
            setShownUnits({.coordinates = form});
            for (double scale_pxpm = 0.001; scale_pxpm < 20; scale_pxpm *= 2.3) {
                const QRectF rect(0, 0, 900, 600);
                const MapViewTransform view({0, 0}, rect.center(), scale_pxpm);
                const Graticule lines = graticuleOf(frame, view, rect);
                QStringList texts;
                for (const GraticuleLine& line : lines.lines)
                    texts << (line.isMeridian
                                  ? longitudeText(line.value_deg, lines.longitudeDecimals, kEnglish)
                                  : latitudeText(line.value_deg, lines.latitudeDecimals, kEnglish));
                QVERIFY(!texts.isEmpty());
                QCOMPARE(texts.removeDuplicates(), 0);
            }
        }
    }
};

QTEST_MAIN(TestUnitSettings)
#include "tst_unit_settings.moc"
