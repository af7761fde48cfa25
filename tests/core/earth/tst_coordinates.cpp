#include "core/base/random.h"
#include "core/earth/coordinates.h"
#include "tests/support/approx.h"

#include <array>

using namespace berg;

namespace {

constexpr double kTyped_deg = 1e-9; // typed values are decimal, stored ones binary

constexpr std::array kForms{CoordinateForm::DecimalDegrees, CoordinateForm::DegreesMinutes,
                            CoordinateForm::DegreesMinutesSeconds};

/** Value of the last digit written. */
double finest_deg(CoordinateForm form, int decimals)
{
    const bool hasSeconds = form == CoordinateForm::DegreesMinutesSeconds && decimals > 0;
    if (form == CoordinateForm::DecimalDegrees)
        return std::pow(10.0, -decimals - 2);
    return hasSeconds ? std::pow(10.0, 2 - std::max(2, decimals)) / 3600
                      : std::pow(10.0, -decimals) / 60;
}

} // namespace

class TestCoordinates : public QObject
{
    Q_OBJECT

private slots:
    void coordinatesAreRead_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<double>("latitude_deg");
        QTest::addColumn<double>("longitude_deg");
        const auto row = [](const char* text, double latitude_deg, double longitude_deg) {
            QTest::newRow(text) << QString::fromUtf8(text) << latitude_deg << longitude_deg;
        };
        row("47.05, -48.1", 47.05, -48.1);
        row("47.05 -48.1", 47.05, -48.1);
        row("47.05-48.1", 47.05, -48.1);
        row("47.05N 48.1W", 47.05, -48.1);
        row("47.05 n, 48.1 w", 47.05, -48.1);
        row("N47.05 W048.1", 47.05, -48.1);
        row("n 47.05 w 48.1", 47.05, -48.1);
        row("48.1W 47.05N", 47.05, -48.1);
        row("47.05° −48.1°", 47.05, -48.1);
        row("47 03.2' N 047 58.1' W", 47 + 3.2 / 60, -(47 + 58.1 / 60));
        row("47°03.2'N 47°58.1'W", 47 + 3.2 / 60, -(47 + 58.1 / 60));
        row("47° 03.2′ N  47° 58.1′ W", 47 + 3.2 / 60, -(47 + 58.1 / 60));
        row("47 03.2 -47 58.1", 47 + 3.2 / 60, -(47 + 58.1 / 60));
        row("47-03.2N 047-58.1W", 47 + 3.2 / 60, -(47 + 58.1 / 60));
        row("47:03:12N 47:58:06W", 47 + 3.2 / 60, -(47 + 58.1 / 60));
        row("47°03'12\"N 47°58'06\"W", 47 + 3.2 / 60, -(47 + 58.1 / 60));
        row("47º03′12″n 47º58′06″w", 47 + 3.2 / 60, -(47 + 58.1 / 60));
        row("47° 3’ 12” N, 47° 58’ 6” W", 47 + 3.2 / 60, -(47 + 58.1 / 60));
        row("47d03'12''N 47d58'06''W", 47 + 3.2 / 60, -(47 + 58.1 / 60));
        row("47 deg 3.2 min north 47 deg 58.1 min west", 47 + 3.2 / 60, -(47 + 58.1 / 60));
        row("N 47 3 12 W 47 58 6", 47 + 3.2 / 60, -(47 + 58.1 / 60));
        row("47 3 12 -47 58 6", 47 + 3.2 / 60, -(47 + 58.1 / 60));
        row("+47.05-048.10/", 47.05, -48.1);
        row("+4703.2-04758.1/", 47 + 3.2 / 60, -(47 + 58.1 / 60));
        row("-470312+0475806CRSWGS_84/", -(47 + 3.2 / 60), 47 + 58.1 / 60);
        row("47,05 -48,1", 47.05, -48.1);
        row("47,05, -48,1", 47.05, -48.1);
        row("47,05;-48,1", 47.05, -48.1);
        row("47,05°N 48,1°V", 47.05, -48.1);
        row("78,22 N 15,65 Ø", 78.22, 15.65);
        row("78 nord 15 øst", 78, 15);
        row("Sør 62 Vest 58", -62, -58);
        row("78° 13.2′ N  15° 39.0′ ø", 78.22, 15.65);
        row("47 312", 47, -48);
        row("0 0", 0, 0);
        row("0° 00.0′  10° 00.0′ W", 0, -10);
        row("90 N 0 E", 90, 0);
        row("-90 180", -90, -180);
        row("75 N 180", 75, -180);
    }

    void coordinatesAreRead()
    {
        QFETCH(QString, text);
        QFETCH(double, latitude_deg);
        QFETCH(double, longitude_deg);
        const auto place = parsePlace(text.toStdString());
        const auto* at = std::get_if<LatLon>(&place);
        if (at == nullptr)
            QFAIL(qPrintable(text));
        COMPARE_NEAR(at->latitude_deg, latitude_deg, kTyped_deg);
        COMPARE_NEAR(at->longitude_deg, longitude_deg, kTyped_deg);
    }

    /** The northing is 0.9996 of the length of the meridian to that latitude. */
    void gridCoordinatesAreRead_data()
    {
        QTest::addColumn<QString>("text");
        QTest::newRow("UTM, hemisphere") << "33n 500000 8683500";
        QTest::newRow("UTM, band") << "33X 500000 8683500";
        QTest::newRow("UTM, units") << "33X 500000mE 8683500mN";
        QTest::newRow("MGRS") << "33XWG0000083500";
        QTest::newRow("MGRS, spaces, lower case") << "33x wg 00000 83500";
    }

    void gridCoordinatesAreRead()
    {
        QFETCH(QString, text);
        const auto place = parsePlace(text.toStdString());
        const auto* at = std::get_if<LatLon>(&place);
        QVERIFY(at != nullptr);
        COMPARE_NEAR(at->longitude_deg, 15, 1e-4); // the central meridian of zone 33
        COMPARE_NEAR(at->latitude_deg, 78.22518, 1e-5);
    }

    void southernBandS()
    {
        QCOMPARE(std::get<CoordinateFault>(parsePlace("33S 500000 3900000")),
                 CoordinateFault::Ambiguous);
        QVERIFY(std::get<LatLon>(parsePlace("20S 500000 3000000")).latitude_deg < -60);
    }

    void faultyCoordinatesHaveAReason_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<CoordinateFault>("fault");
        const auto row = [](const char* text, CoordinateFault fault) {
            QTest::newRow(text) << QString::fromUtf8(text) << fault;
        };
        row("", CoordinateFault::Empty);
        row("   ", CoordinateFault::Empty);
        row("hello", CoordinateFault::Unreadable);
        row("47.05.1 48", CoordinateFault::Unreadable);
        row("47.5 03 N 48 10 W", CoordinateFault::Unreadable);
        row("47' 03° N 48 W", CoordinateFault::Unreadable);
        row("1 2 3 4 5 6 7 8", CoordinateFault::Unreadable);
        row("nan nan", CoordinateFault::Unreadable);
        row("47", CoordinateFault::Half);
        row("47.05 N", CoordinateFault::Half);
        row("47° 03.2' N", CoordinateFault::Half);
        row("47,05 N", CoordinateFault::Half);
        row("47 03 12 N", CoordinateFault::Half);
        row("47,48", CoordinateFault::Ambiguous);
        row("47,05,48,1", CoordinateFault::Ambiguous);
        row("47 03 48", CoordinateFault::Ambiguous);
        row("47 N 48", CoordinateFault::HemisphereMissing);
        row("47, 48 W", CoordinateFault::HemisphereMissing);
        row("-47 N 48 W", CoordinateFault::SignAndLetter);
        row("47 N 48 S", CoordinateFault::SameAxis);
        row("47 E 48 W", CoordinateFault::SameAxis);
        row("47 60 N 48 W", CoordinateFault::Sixty);
        row("47 03 75 N 48 10 00 W", CoordinateFault::Sixty);
        row("90.1 N 48 W", CoordinateFault::Latitude);
        row("148 47", CoordinateFault::Latitude);
        row("47 N 181 W", CoordinateFault::Longitude);
        row("47 -181", CoordinateFault::Longitude);
        row("47 360", CoordinateFault::Longitude);
        row("61n 500000 8683500", CoordinateFault::Grid);
        row("33XII0000083500", CoordinateFault::Grid);
    }

    void faultyCoordinatesHaveAReason()
    {
        QFETCH(QString, text);
        const auto place = parsePlace(text.toStdString());
        QVERIFY(std::holds_alternative<CoordinateFault>(place));
        QTEST(std::get<CoordinateFault>(place), "fault");
    }

    /** Any text gives a place on the Earth or a reason. */
    void survivesAnyText()
    {
        constexpr std::string_view kPieces[] = {
            "47", "180", ".5", ",", ";",           " ", "-",    "+", "°",   "'",  "\"",    "N",
            "w",  "Ø",   "V",  "/", "99999999999", "x", "\xff", ":", "33X", "WG", "500000"};
        Random random(7, 1);
        for (int round = 0; round < 20'000; ++round) {
            std::string text;
            for (auto left = random.below(9); left > 0; --left)
                text += kPieces[random.below(std::size(kPieces))];
            const auto place = parsePlace(text);
            if (const auto* at = std::get_if<LatLon>(&place)) {
                QVERIFY2(std::abs(at->latitude_deg) <= 90, text.c_str());
                QVERIFY2(at->longitude_deg >= -180 && at->longitude_deg < 180, text.c_str());
            }
        }
        QVERIFY(std::holds_alternative<CoordinateFault>(parsePlace(std::string(100'000, '4'))));
    }

    void coordinatesAreWritten_data()
    {
        QTest::addColumn<double>("angle_deg");
        QTest::addColumn<CoordinateForm>("form");
        QTest::addColumn<std::optional<int>>("decimals");
        QTest::addColumn<QString>("text");
        using Form = CoordinateForm;
        const auto row = [](double angle_deg, Form form, std::optional<int> decimals,
                            const char* text) {
            QTest::addRow("%s", text) << angle_deg << form << decimals << QString::fromUtf8(text);
        };
        row(47.05, Form::DecimalDegrees, 2, "47.0500°");
        row(47.05, Form::DegreesMinutes, 2, "47° 03.00′");
        row(47.0533333, Form::DegreesMinutesSeconds, 2, "47° 03′ 12″");
        row(47.0533333, Form::DegreesMinutesSeconds, 3, "47° 03′ 12.0″");
        row(47.0533333, Form::DegreesMinutesSeconds, 0, "47° 03′");
        row(7, Form::DegreesMinutes, 0, "7° 00′");
        row(120, Form::DegreesMinutes, std::nullopt, "120°");
        // 59.9999 minutes are a degree when they are rounded
        row(59.9999 / 60, Form::DegreesMinutes, 1, "1° 00.0′");
        row(46 + 59.9999 / 60, Form::DegreesMinutesSeconds, 2, "47° 00′ 00″");
        row(46.999999, Form::DecimalDegrees, 2, "47.0000°");
        row(46.9, Form::DecimalDegrees, std::nullopt, "47°");
    }

    void coordinatesAreWritten()
    {
        QFETCH(double, angle_deg);
        QFETCH(CoordinateForm, form);
        QFETCH(std::optional<int>, decimals);
        QFETCH(QString, text);
        QCOMPARE(QString::fromStdString(angleText(angle_deg, form, decimals)), text);
    }

    /** A written coordinate is read back as the same place, within its digits. */
    void writtenCoordinatesAreReadBack()
    {
        std::vector<LatLon> places{{90, 0},
                                   {-90, 0},
                                   {0, 0},
                                   {0, -180},
                                   {70, 179.99999},
                                   {70, -179.99999},
                                   {-0.00001, 0.00001},
                                   {59.9999999, 59.9999999}};
        Random random(11, 2);
        for (int i = 0; i < 2000; ++i)
            places.push_back({180 * random.uniform() - 90, 360 * random.uniform() - 180});
        for (const LatLon& place : places)
            for (const CoordinateForm form : kForms)
                for (const int decimals : {0, 2, 4}) {
                    const std::string text = placeText(place, form, decimals);
                    const auto read = parsePlace(text);
                    QVERIFY2(std::holds_alternative<LatLon>(read), text.c_str());
                    const auto& at = std::get<LatLon>(read);
                    const double half_deg = 0.5001 * finest_deg(form, decimals);
                    QVERIFY2(std::abs(at.latitude_deg - place.latitude_deg) <= half_deg,
                             text.c_str());
                    const double path_deg =
                        std::remainder(at.longitude_deg - place.longitude_deg, 360.0);
                    QVERIFY2(std::abs(path_deg) <= half_deg, text.c_str());
                }
    }
};

QTEST_APPLESS_MAIN(TestCoordinates)
#include "tst_coordinates.moc"
