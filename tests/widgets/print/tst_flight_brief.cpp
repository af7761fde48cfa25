#include "tests/support/files/brief_fixtures.h"
#include "tests/support/window/panel_test.h"
#include "widgets/print/brief_html.h"
#include "widgets/print/flight_brief.h"

#include <QRegularExpression>
#include <QThread>
#include <QtTest>

#include <memory>

using namespace berg;
using namespace berg::test;
using namespace Qt::StringLiterals;

namespace {

const QLocale kLetter(QLocale::English, QLocale::UnitedStates);

double mapHeight_px(const PrintedDocument& brief)
{
    static const QRegularExpression map(u"src=\"map\" width=\"\\d+\" height=\"(\\d+)\""_s);
    return map.match(QString::fromStdString(brief.html)).captured(1).toDouble();
}

bool hasControls(const QString& text)
{
    return std::ranges::any_of(text, [](QChar c) {
        return c != u'\n' &&
               (c.category() == QChar::Other_Control || c.category() == QChar::Separator_Line);
    });
}

/** Describes a defect of the page; empty if there is none. */
QString faultOf(const PrintedDocument& brief)
{
    const PrintedText text(brief);
    if (text.pageCount() != 1)
        return u"%1 pages"_s.arg(text.pageCount());
    constexpr double kBorders_px = 5; // of tables
    if (text.size().width() > brief.room_px().width() + kBorders_px)
        return u"%1 wide"_s.arg(text.size().width());
    if (hasControls(text.toPlainText()))
        return u"control characters"_s;
    const QRegularExpression size(u"font-size: ([0-8])px"_s);
    if (size.match(QString::fromStdString(brief.html)).hasMatch())
        return u"too small"_s;
    return mapHeight_px(brief) < 200 ? u"the map is too low"_s : QString();
}

QString textOf(const PrintedDocument& brief)
{
    return PrintedText(brief).toPlainText();
}

int pagesOf(const std::string& pdf)
{
    const QByteArray text = bytes(pdf);
    return static_cast<int>(text.count("/Type /Page") - text.count("/Type /Pages"));
}

} // namespace

/** The flight brief on its one page. */
class TestFlightBrief : public QObject
{
    Q_OBJECT

private slots:
    void everythingHasItsPlace_data()
    {
        QTest::addColumn<ExportContent>("content");
        QTest::addColumn<QString>("cut"); ///< line about rows left out; empty if all are shown
        const auto row = [](const char* name, const ExportContent& content,
                            const QString& cut = {}) { QTest::newRow(name) << content << cut; };
        row("no icebergs", planContent(changed([](Scenario& s) { s.icebergs.clear(); }), {}));
        row("4", planContent(fourIcebergs()));
        row("40", fleetContent(1, 40));
        row("50", fleetContent(1, 50));
        row("500", fleetContent(1, 500), u" more; export CSV for the whole list"_s);
        row("5 UAVs, 500", fleetContent(5, 500), u" more; export CSV for the whole list"_s);
        row("5 UAVs, 20", fleetContent(5, 20));
        row("100 UAVs, 500", fleetContent(100, 500), u" more UAVs"_s);
        row("hostile", planContent(longHostile()));
        row("500 hostile",
            planContent(
                [] {
                    Scenario scenario = fleetScenario(5, 500);
                    for (Iceberg& iceberg : scenario.icebergs)
                        iceberg.name = longHostile().icebergs[1].name + iceberg.id;
                    for (Uav& uav : scenario.uavs) {
                        uav.spec.endurance_s = 36000;
                        uav.name = std::string(200, 'M');
                    }
                    scenario.notes = longHostile().notes;
                    scenario.geofence = true;
                    return scenario;
                }(),
                fleetPlan(5, 400), {.loiterTurns = 2}),
            u" more; export CSV for the whole list"_s);
    }

    void everythingHasItsPlace()
    {
        QFETCH(const ExportContent, content);
        QFETCH(const QString, cut);
        for (const QLocale& locale : {kEnglish, kGerman, kLetter}) {
            const PrintedDocument brief = briefDocument(content, locale);
            QCOMPARE(faultOf(brief), QString());
            QCOMPARE(textOf(brief).contains(u"the whole list"_s), !cut.isEmpty());
            QVERIFY(textOf(brief).contains(cut));
        }
    }

    /** Units with the longest texts and both norths; what there is no room for is left out whole.
     */
    void everyUnitHasItsPlace()
    {
        const UnitsInUse units({.distance = DistanceUnit::Nautical,
                                .speed = SpeedUnit::Knots,
                                .height = HeightUnit::Feet,
                                .north = NorthForm::Typed});
        for (const ExportContent& content :
             {planContent(fourIcebergs()), fleetContent(1, 40), fleetContent(5, 20)}) {
            const PrintedDocument brief = briefDocument(content, kGerman);
            QCOMPARE(faultOf(brief), QString());
            QVERIFY(textOf(brief).contains(u"magnetic"_s));
        }
    }

    void whatIsCutIsCounted()
    {
        const QString text = textOf(briefDocument(fleetContent(1, 500), kEnglish));
        const auto count = [&text](const QRegularExpression& pattern) {
            const QStringList lines = text.split(u'\n');
            return std::ranges::count_if(
                lines, [&](const QString& line) { return pattern.match(line).hasMatch(); });
        };
        const auto shown = count(QRegularExpression(u"^\\d+$"_s)); // numbers of the rows
        QVERIFY2(shown > 60, qPrintable(QString::number(shown)));
        QCOMPARE(count(QRegularExpression(u"and %1 more;"_s.arg(500 - shown))), 1);
    }

    void noWarningsAreSaid()
    {
        const ExportContent content = planContent(byDay(fourIcebergs()));
        QVERIFY(briefContent(content, kEnglish).warnings.isEmpty());
        QVERIFY(textOf(briefDocument(content, kEnglish)).contains(u"No warnings"_s));
    }

    /** The map gets what the table leaves. */
    void noRoomIsLost()
    {
        for (const int uavs : {1, 3, 5})
            for (const int icebergs : {20, 500}) {
                const PrintedDocument brief = briefDocument(fleetContent(uavs, icebergs), kEnglish);
                const double spare_px = PrintedText(brief).spare_px();
                QVERIFY2(spare_px >= 0 && spare_px < 12, qPrintable(QString::number(spare_px)));
            }
    }

    void warningsWithoutRoomAreCounted()
    {
        BriefContent brief = briefContent(planContent(byDay(fourIcebergs())), kEnglish);
        for (int i = 1; i <= 40; ++i)
            brief.warnings << u"Warning number %1"_s.arg(i);
        const QString text = QString::fromStdString(briefHtml(brief, {}, {QColor(Qt::black)}, 698));
        const auto shown = text.count(u"Warning number"_s);
        QCOMPARE(shown, 9); // of ten lines
        QVERIFY(text.contains(u"Warnings (40)"_s));
        QVERIFY(text.contains(u"and %1 more"_s.arg(40 - shown)));
    }

    void onePageAlways_data()
    {
        QTest::addColumn<int>("uavs");
        QTest::addColumn<int>("icebergs");
        QTest::newRow("none") << 1 << 0;
        QTest::newRow("4") << 1 << 4;
        QTest::newRow("40") << 1 << 40;
        QTest::newRow("500") << 1 << 500;
        QTest::newRow("5 UAVs") << 5 << 200;
    }

    void onePageAlways()
    {
        QFETCH(const int, uavs);
        QFETCH(const int, icebergs);
        const ExportContent content = fleetContent(uavs, icebergs);
        const PicturePage page = flightBrief(content, kEnglish);
        const std::string pdf = pictureFile(page, u"pdf"_s);
        QCOMPARE(pagesOf(pdf), 1);
        QVERIFY(bytes(pdf).contains("/MediaBox [0 0 595"));
        QVERIFY2(!bytes(pdf).contains("/Subtype /Image"), "no pixels");
    }

    void sameBytesOnEveryThread()
    {
        const auto made = [] {
            PicturePage page;
            {
                const ExportContent content = planContent(longHostile());
                page = flightBrief(content, kEnglish);
            } // the page holds what it paints
            return page;
        };
        const PicturePage page = made();
        const std::string pdf = pictureFile(page, u"pdf"_s);
        QVERIFY(pdf == pictureFile(page, u"pdf"_s));
        std::string elsewhere;
        const std::unique_ptr<QThread> thread(
            QThread::create([&] { elsewhere = pictureFile(made(), u"pdf"_s); }));
        thread->start();
        QVERIFY(thread->wait());
        QVERIFY(pdf == elsewhere);
        QCOMPARE(pagesOf(pdf), 2); // the second about the operation
    }

    void otherDevicesToo()
    {
        const PicturePage page = flightBrief(planContent(fourIcebergs()), kEnglish);
        const QByteArray svg = bytes(pictureFile(page, u"svg"_s));
        QVERIFY(svg.contains(">berg-4</text>"));
        const QImage image = pictureImage(page, 1);
        QCOMPARE(image.size(), page.size_px);
        // The paper stays white in the margins and has ink inside.
        QCOMPARE(image.pixelColor(20, 600), QColor(Qt::white));
        const QRect head(48, 48, 200, 28);
        int dark = 0;
        for (int y = head.top(); y < head.bottom(); ++y)
            for (int x = head.left(); x < head.right(); ++x)
                dark += qGray(image.pixel(x, y)) < 100 ? 1 : 0;
        QVERIFY(dark > 100);
    }

    void paperIsThatOfTheCountry()
    {
        const ExportContent content = planContent(fourIcebergs());
        QCOMPARE(flightBrief(content, kGerman).size_px, QSize(794, 1123));
        QCOMPARE(flightBrief(content, kAmerican).size_px, QSize(816, 1056));
    }
};

QTEST_MAIN(TestFlightBrief)
#include "tst_flight_brief.moc"
