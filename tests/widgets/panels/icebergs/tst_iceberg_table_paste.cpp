#include "core/earth/geodesy.h"
#include "tests/support/approx.h"
#include "tests/support/flight/scenario_builder.h"
#include "widgets/document/scenario_edits.h"
#include "widgets/panels/icebergs/iceberg_table_paste.h"
#include "widgets/words/iceberg_table_text.h"

#include <array>
#include <cmath>

using namespace berg;
using namespace Qt::StringLiterals;
using Cells = std::vector<std::vector<QString>>;

namespace {

const QLocale kGerman(QLocale::German, QLocale::Germany);
const QLocale kNorwegian(QLocale::NorwegianBokmal, QLocale::Norway);

const std::vector<IcebergColumn> kColumns{
    IcebergColumn::Name,     IcebergColumn::East,      IcebergColumn::North,
    IcebergColumn::Speed,    IcebergColumn::Direction, IcebergColumn::Sigma0,
    IcebergColumn::Growth,   IcebergColumn::Observed,  IcebergColumn::Appears,
    IcebergColumn::Latitude, IcebergColumn::Longitude};

Scenario threeIcebergs()
{
    Scenario scenario = test::emptySea();
    test::addIceberg(scenario, 1000, 2000).velocity_mps = Point(0.3, 0.4);
    test::addIceberg(scenario, 3000, 2000, 8);
    test::addIceberg(scenario, 5000, 4000);
    return scenario;
}

/** Pastes at iceberg `row` of three, from `column` on. */
PasteOutcome pasted(const QString& text, std::size_t row = 0,
                    IcebergColumn column = IcebergColumn::East,
                    const QLocale& locale = QLocale::c(),
                    const Scenario& scenario = threeIcebergs())
{
    PasteTarget target{.shown = kColumns};
    for (std::size_t i = row; i < scenario.icebergs.size(); ++i)
        target.ids.push_back(scenario.icebergs[i].id);
    target.columns.assign(std::find(kColumns.begin(), kColumns.end(), column), kColumns.end());
    return pasteCells(scenario, text, target, icebergColumnSpecs(), locale);
}

} // namespace

class TestIcebergTablePaste : public QObject
{
    Q_OBJECT

private slots:
    void splitsTextIntoCells_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QLocale>("locale");
        QTest::addColumn<Cells>("cells");
        const QLocale c = QLocale::c();
        const Cells square{{u"1"_s, u"2"_s}, {u"3"_s, u"4"_s}};
        QTest::newRow("tabs") << u"1\t2\n3\t4\n"_s << c << square;
        QTest::newRow("no last line end") << u"1\t2\n3\t4"_s << c << square;
        QTest::newRow("Windows") << u"1\t2\r\n3\t4\r\n"_s << c << square;
        QTest::newRow("semicolons") << u"1;2\n3;4\n"_s << kGerman << square;
        QTest::newRow("commas") << u"1,2\n3,4\n"_s << c << square;
        QTest::newRow("decimal comma")
            << u"1,2\n3,4\n"_s << kGerman << Cells{{u"1,2"_s}, {u"3,4"_s}};
        QTest::newRow("commas with points") << u"1.5,2"_s << kGerman << Cells{{u"1.5"_s, u"2"_s}};
        QTest::newRow("two commas") << u"1,2,3"_s << kGerman << Cells{{u"1"_s, u"2"_s, u"3"_s}};
        QTest::newRow("tabs before commas") << u"1,5\t2"_s << c << Cells{{u"1,5"_s, u"2"_s}};
        QTest::newRow("empty cells")
            << u"\t2\n\n3\t"_s << c << Cells{{u""_s, u"2"_s}, {u""_s}, {u"3"_s, u""_s}};
        QTest::newRow("quotes") << u"\"a\tb\nc\"\"d\"\t2\n"_s << c
                                << Cells{{u"a\tb\nc\"d"_s, u"2"_s}};
        QTest::newRow("open quote") << u"\"a\tb"_s << c << Cells{{u"a\tb"_s}};
        QTest::newRow("nothing") << QString() << c << Cells{};
    }

    void splitsTextIntoCells()
    {
        QFETCH(QString, text);
        QFETCH(QLocale, locale);
        QFETCH(Cells, cells);
        QCOMPARE(cellsOf(text, locale), cells);
    }

    void readsNumbersOfTheLocale_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QLocale>("locale");
        QTest::addColumn<double>("value"); // NaN: none
        const QLocale c = QLocale::c();
        QTest::newRow("point") << u"12.5"_s << c << 12.5;
        QTest::newRow("German comma") << u"12,5"_s << kGerman << 12.5;
        QTest::newRow("Norwegian comma") << u"12,5"_s << kNorwegian << 12.5;
        QTest::newRow("point in German") << u"12.5"_s << kGerman << 12.5;
        QTest::newRow("three decimals in German") << u"1.234"_s << kGerman << 1.234;
        QTest::newRow("point in Norwegian") << u"-12.5"_s << kNorwegian << -12.5;
        QTest::newRow("minus of typesetting")
            << QString(QChar(0x2212)) + u"12,5"_s << kNorwegian << -12.5;
        QTest::newRow("narrow spaces")
            << u"1"_s + QChar(0x202f) + u"234,5"_s << kNorwegian << 1234.5;
        QTest::newRow("German thousands") << u"1.234,5"_s << kGerman << 1234.5;
        QTest::newRow("exponent") << u"1e-3"_s << c << 0.001;
        QTest::newRow("spaces round it") << u"  7 "_s << c << 7.0;
        QTest::newRow("word") << u"seven"_s << c << std::nan("");
        QTest::newRow("comma where it means nothing") << u"12,5"_s << c << std::nan("");
        QTest::newRow("two points") << u"1.2.3"_s << c << std::nan("");
        QTest::newRow("infinite") << u"inf"_s << c << std::nan("");
        QTest::newRow("nothing") << QString() << c << std::nan("");
    }

    void readsNumbersOfTheLocale()
    {
        QFETCH(QString, text);
        QFETCH(QLocale, locale);
        QFETCH(double, value);
        const std::optional<double> read = numberOf(text, locale);
        QCOMPARE(read.has_value(), !std::isnan(value));
        if (read)
            QCOMPARE(*read, value);
    }

    void exactTextReadsBack()
    {
        for (const double value : {0.0, 0.1, -1.0 / 3, 5e-324, 1e12, 123456.789, -0.025})
            for (const QLocale& locale : {QLocale::c(), kGerman, kNorwegian}) {
                const QString text = exactText(value, locale);
                QVERIFY2(numberOf(text, locale) == value, qPrintable(text));
            }
        QCOMPARE(exactText(1234567.5, kGerman), u"1234567,5"_s);
        QCOMPARE(exactText(1e6, QLocale::c()), u"1000000"_s);
    }

    void quotesWhatWouldNotReadBack()
    {
        const Cells cells{{u"a\tb"_s, u"c\"d"_s}, {u"e\nf"_s, u"plain; text, too"_s}};
        QCOMPARE(cellsOf(tabSeparated(cells), QLocale::c()), cells);
        QCOMPARE(tabSeparated({{u"a"_s, u"1"_s}}), u"a\t1\n"_s);
    }

    void fillsToTheRightAndDown()
    {
        const PasteOutcome outcome = pasted(u"100\t200\n300\t400"_s, 1);
        QCOMPARE(outcome.fault, QString());
        const std::vector<Iceberg>& icebergs = outcome.scenario.icebergs;
        QCOMPARE(icebergs.size(), std::size_t{3});
        QCOMPARE(icebergs[0].position_m, Point(1000, 2000));
        QCOMPARE(icebergs[1].position_m, Point(100, 200));
        QCOMPARE(icebergs[2].position_m, Point(300, 400));
        QCOMPARE(outcome.ids, (std::vector<std::string>{"berg-2", "berg-3"}));
    }

    void decimalsOfTheLocale()
    {
        for (const QLocale& locale : {kGerman, kNorwegian}) {
            const PasteOutcome outcome = pasted(u"100,5\t200.25"_s, 0, IcebergColumn::East, locale);
            QCOMPARE(outcome.fault, QString());
            QCOMPARE(outcome.scenario.icebergs[0].position_m, Point(100.5, 200.25));
        }
    }

    void emptyCellsLeaveWhatIsThere()
    {
        const PasteOutcome outcome = pasted(u"\t200\n\n300\t"_s);
        QCOMPARE(outcome.scenario.icebergs[0].position_m, Point(1000, 200));
        QCOMPARE(outcome.scenario.icebergs[1].position_m, Point(3000, 2000));
        QCOMPARE(outcome.scenario.icebergs[2].position_m, Point(300, 4000));
    }

    void moreRowsAddIcebergs()
    {
        const PasteOutcome outcome =
            pasted(u"Big one\t1\t2\nB07\t3\t4\nberg-1\t5\t6\n\t7\t8"_s, 2, IcebergColumn::Name);
        QCOMPARE(outcome.fault, QString());
        const std::vector<Iceberg>& icebergs = outcome.scenario.icebergs;
        QCOMPARE(icebergs.size(), std::size_t{6});
        QCOMPARE(icebergs[2].id, "berg-3");
        QCOMPARE(icebergs[2].name, "Big one");
        QCOMPARE(icebergs[3].id, "B07"); // free: its id
        QCOMPARE(icebergs[3].name, "");
        QCOMPARE(icebergs[4].name, "berg-1"); // taken
        QVERIFY(icebergs[4].id != "berg-1");
        QCOMPARE(icebergs[5].position_m, Point(7, 8));
        QCOMPARE(outcome.ids.size(), std::size_t{4});
    }

    void titlesSayWhichColumn()
    {
        const IcebergColumnSpecs specs = icebergColumnSpecs();
        const QString titles = specOf(specs, IcebergColumn::Sigma0).copied + u'\t' +
                               specOf(specs, IcebergColumn::North).copied;
        const PasteOutcome outcome = pasted(titles + u"\n7\t-50"_s, 0, IcebergColumn::Direction);
        QCOMPARE(outcome.fault, QString());
        QCOMPARE(outcome.scenario.icebergs[0].sigma0_m2, 7.0);
        QCOMPARE(outcome.scenario.icebergs[0].position_m, Point(1000, -50));
    }

    void driftIsSpeedAndDirection_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<Point>("velocity_mps");
        QTest::newRow("both") << u"2\t90"_s << Point(2, 0);
        QTest::newRow("south") << u"2\t180"_s << Point(0, -2);
        QTest::newRow("west") << u"2\t270"_s << Point(-2, 0);
        QTest::newRow("full circle") << u"2\t360"_s << Point(0, 2);
        QTest::newRow("speed keeps the direction") << u"1\t"_s << Point(0.6, 0.8);
        QTest::newRow("direction keeps the speed") << u"\t0"_s << Point(0, 0.5);
        QTest::newRow("still") << u"0\t45"_s << Point(0, 0);
    }

    void driftIsSpeedAndDirection()
    {
        QFETCH(QString, text);
        QFETCH(Point, velocity_mps);
        const PasteOutcome outcome = pasted(text, 0, IcebergColumn::Speed);
        QCOMPARE(outcome.fault, QString());
        // Rounding of sine and cosine.
        COMPARE_NEAR((outcome.scenario.icebergs[0].velocity_mps - velocity_mps).norm(), 0.0, 1e-15);
    }

    /** The coordinates are columns of one half each, or whole coordinates in one cell. */
    void pastesRowsOfCoordinates_data()
    {
        QTest::addColumn<QString>("text");
        QTest::newRow("decimal degrees") << u"47.1\t-48.25\n47.2\t-48.5"_s;
        QTest::newRow("comma between") << u"47.1, -48.25\n47.2, -48.5"_s;
        QTest::newRow("degrees and minutes") << u"47° 06.0′ N\t48° 15′ W\n47° 12.0′ N\t48 30 W"_s;
        QTest::newRow("whole coordinates") << u"47° 06.0′ N 48° 15′ W\n47 12 N 48 30 W"_s;
        QTest::newRow("titles") << u"Longitude\tLatitude\n-48.25\t47.1\n-48.5\t47.2"_s;
    }

    void pastesRowsOfCoordinates()
    {
        QFETCH(QString, text);
        const PasteOutcome outcome = pasted(text, 1, IcebergColumn::Latitude);
        QCOMPARE(outcome.fault, QString());
        QCOMPARE(outcome.ids, (std::vector<std::string>{"berg-2", "berg-3"}));
        const LocalFrame frame(outcome.scenario.origin);
        const auto checkAt = [&](std::size_t i, double latitude_deg, double longitude_deg) {
            const LatLon at = frame.toGeographic(outcome.scenario.icebergs[i].position_m);
            COMPARE_NEAR(at.latitude_deg, latitude_deg, 1e-9);
            COMPARE_NEAR(at.longitude_deg, longitude_deg, 1e-9);
        };
        checkAt(1, 47.1, -48.25);
        checkAt(2, 47.2, -48.5);
    }

    void oneThatStandsStillStartsNorth()
    {
        const PasteOutcome outcome = pasted(u"0.5"_s, 1, IcebergColumn::Speed);
        QCOMPARE(outcome.scenario.icebergs[1].velocity_mps, Point(0, 0.5));
    }

    /** The largest allowed velocity is copied and pasted; a larger one is a fault. */
    void velocityKeepsToTheLimits()
    {
        Scenario scenario = threeIcebergs();
        scenario.icebergs[0].velocity_mps = Point(5, -5);
        const QString speed = exactText(std::sqrt(50.0), QLocale::c());
        PasteOutcome outcome = pasted(speed, 0, IcebergColumn::Speed, QLocale::c(), scenario);
        QCOMPARE(outcome.fault, QString());
        QCOMPARE(outcome.scenario, scenario);
        outcome = pasted(u"0"_s, 0, IcebergColumn::Direction, QLocale::c(), scenario);
        QCOMPARE(outcome.scenario.icebergs[0].velocity_mps, Point(0, 5));
        QVERIFY(pasted(speed, 1, IcebergColumn::Speed).fault.contains(speed));
    }

    void refusesWithAReason_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<IcebergColumn>("column");
        QTest::addColumn<QStringList>("words");
        QTest::newRow("word") << u"1\t2\n3\tfar"_s << IcebergColumn::East
                              << QStringList{u"Row 2"_s, u"North, m"_s, u"far"_s};
        QTest::newRow("too far") << u"2000000"_s << IcebergColumn::East
                                 << QStringList{u"Row 1"_s, u"East, m"_s, u"2000000"_s};
        QTest::newRow("negative sigma")
            << u"-1"_s << IcebergColumn::Sigma0 << QStringList{u"Row 1"_s, u"σ₀, m²"_s, u"-1"_s};
        QTest::newRow("in an added row")
            << u"1\n2\n3\nx"_s << IcebergColumn::Growth << QStringList{u"Row 4"_s, u"q, m²/s"_s};
        QTest::newRow("too wide") << u"1\t2"_s << IcebergColumn::Longitude
                                  << QStringList{u"Row 1"_s, u"2"_s};
        QTest::newRow("no latitude") << u"47\t-48\n95\t-48"_s << IcebergColumn::Latitude
                                     << QStringList{u"Row 2"_s, u"Latitude"_s, u"95"_s, u"90° N"_s};
        QTest::newRow("place out of reach")
            << u"10\t-48"_s << IcebergColumn::Latitude << QStringList{u"Row 1"_s, u"1 000 km"_s};
        QTest::newRow("unknown title")
            << u"east\tnorth\n1\t2"_s << IcebergColumn::East << QStringList{u"Row 1"_s, u"east"_s};
        QTest::newRow("nothing") << u" \n\t\n"_s << IcebergColumn::East << QStringList{};
    }

    void refusesWithAReason()
    {
        QFETCH(QString, text);
        QFETCH(IcebergColumn, column);
        QFETCH(QStringList, words);
        const QString fault = pasted(text, 0, column).fault;
        QVERIFY(!fault.isEmpty());
        for (const QString& word : words)
            QVERIFY2(fault.contains(word), qPrintable(fault));
    }

    void refusesMoreThanAScenarioHolds()
    {
        QString text;
        for (int i = 0; i < 998; ++i)
            text += u"1\n"_s;
        QCOMPARE(pasted(text, 1).scenario.icebergs.size(), std::size_t{999});
        QCOMPARE(pasted(text, 3).fault.isEmpty(), false);
    }
};

QTEST_MAIN(TestIcebergTablePaste)
#include "tst_iceberg_table_paste.moc"
