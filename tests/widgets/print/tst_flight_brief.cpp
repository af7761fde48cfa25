#include "tests/support/files/brief_fixtures.h"
#include "tests/support/window/panel_test.h"
#include "widgets/print/brief_layout.h"
#include "widgets/print/flight_brief.h"

#include <QFontMetricsF>
#include <QRegularExpression>
#include <QThread>
#include <QtTest>

#include <memory>

using namespace berg;
using namespace berg::test;
using namespace Qt::StringLiterals;

namespace {

constexpr QSizeF kA4_px(794, 1123);

bool hasControls(const QString& text)
{
    return std::any_of(text.begin(), text.end(), [](QChar c) {
        return c.category() == QChar::Other_Control || c.category() == QChar::Separator_Line;
    });
}

/** Describes a defect of the page; empty if there is none. */
QString faultOf(const BriefLayout& layout)
{
    const double margin_px = kBriefMargin_px - 0.01;
    const QRectF inside =
        QRectF(QPointF(0, 0), layout.page).adjusted(margin_px, margin_px, -margin_px, -margin_px);
    std::vector<std::pair<QRectF, QString>> boxes{{layout.map, u"the map"_s}};
    for (const BriefSign& sign : layout.signs)
        boxes.emplace_back(sign.rect, u"a sign"_s);
    for (const BriefText& text : layout.texts) {
        boxes.emplace_back(text.rect, text.text);
        const QFontMetricsF metrics(briefFont(text.type));
        if (metrics.horizontalAdvance(text.text) > text.rect.width() + 0.01)
            return u"wider than its box: "_s + text.text;
        if (metrics.height() > text.rect.height() + 0.5)
            return u"higher than its box: "_s + text.text;
        if (text.type.size_px < kSmallestBriefType_px)
            return u"too small: "_s + text.text;
        if (hasControls(text.text))
            return u"control characters in: "_s + text.text;
    }
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (!inside.contains(boxes[i].first))
            return u"in the margin: "_s + boxes[i].second;
        for (std::size_t k = 0; k < i; ++k)
            if (boxes[i].first.adjusted(0.01, 0.01, -0.01, -0.01).intersects(boxes[k].first))
                return u"overlap of "_s + boxes[i].second + u" and "_s + boxes[k].second;
    }
    return layout.map.height() < 200 ? u"the map is too low"_s : QString();
}

bool hasText(const BriefLayout& layout, const QString& part)
{
    return std::any_of(layout.texts.begin(), layout.texts.end(),
                       [&](const BriefText& text) { return text.text.contains(part); });
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
        for (const QSizeF& page : {kA4_px, QSizeF(816, 1056)})
            for (const QLocale& locale : {kEnglish, kGerman}) {
                const BriefContent brief = briefContent(content, locale);
                const BriefLayout layout = layOutBrief(brief, page);
                const QString fault = faultOf(layout);
                QVERIFY2(fault.isEmpty(), qPrintable(fault.left(200)));
                QCOMPARE(hasText(layout, u"the whole list"_s), !cut.isEmpty());
                QVERIFY(hasText(layout, cut));
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
            const BriefLayout layout = layOutBrief(briefContent(content, kGerman), kA4_px);
            QCOMPARE(faultOf(layout), QString());
            QVERIFY(hasText(layout, u"magnetic"_s));
        }
    }

    void whatIsCutIsCounted()
    {
        const BriefContent brief = briefContent(fleetContent(1, 500), kEnglish);
        const BriefLayout layout = layOutBrief(brief, kA4_px);
        const auto count = [&layout](const QRegularExpression& pattern) {
            return std::ranges::count_if(layout.texts, [&](const BriefText& text) {
                return pattern.match(text.text).hasMatch();
            });
        };
        const auto shown = count(QRegularExpression(u"^\\d+$"_s)); // numbers of the rows
        QVERIFY(shown > 60);
        QCOMPARE(count(QRegularExpression(u"^and %1 more;"_s.arg(500 - shown))), 1);
    }

    void noWarningsAreSaid()
    {
        const BriefContent brief = briefContent(planContent(byDay(fourIcebergs())), kEnglish);
        QVERIFY(brief.warnings.isEmpty());
        QVERIFY(hasText(layOutBrief(brief, kA4_px), u"No warnings"_s));
    }

    /** The map gets what the table leaves. */
    void noRoomIsLost()
    {
        for (const int uavs : {1, 3, 5}) {
            const BriefLayout layout =
                layOutBrief(briefContent(fleetContent(uavs, 500), kEnglish), kA4_px);
            double end_px = 0;
            double words_px = kA4_px.height();
            for (const BriefText& text : layout.texts) {
                if (text.text.contains(u"No warnings"_s) || text.text.contains(u"Warnings ("_s))
                    words_px = text.rect.top();
                else if (text.rect.top() < words_px)
                    end_px = std::max(end_px, text.rect.bottom());
            }
            QVERIFY2(words_px - end_px < 12, qPrintable(QString::number(words_px - end_px)));
        }
    }

    void warningsWithoutRoomAreCounted()
    {
        BriefContent brief = briefContent(planContent(byDay(fourIcebergs())), kEnglish);
        for (int i = 1; i <= 40; ++i)
            brief.warnings << u"Warning number %1"_s.arg(i);
        const BriefLayout layout = layOutBrief(brief, kA4_px);
        const auto shown = std::ranges::count_if(layout.texts, [](const BriefText& text) {
            return text.text.contains(u"Warning number"_s);
        });
        QVERIFY(shown > 4);
        QVERIFY(hasText(layout, u"Warnings (40)"_s));
        QVERIFY(hasText(layout, u"and %1 more"_s.arg(40 - shown)));
        QCOMPARE(faultOf(layout), QString());
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
