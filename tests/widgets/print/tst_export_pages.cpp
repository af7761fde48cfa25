#include "tests/support/expect_error.h"
#include "tests/support/files/export_fixtures.h"
#include "widgets/flight/sigma_end.h"
#include "widgets/print/chart_page.h"
#include "widgets/print/export_painter.h"
#include "widgets/print/export_picture.h"
#include "widgets/print/map_page.h"
#include "widgets/theme/quantity_text.h"

#include <QPainter>
#include <QRegularExpression>
#include <QSvgRenderer>
#include <QXmlStreamReader>
#include <QtTest>

#include <numeric>
#include <set>
#include <thread>

using namespace berg;
using namespace berg::test;
using namespace Qt::StringLiterals;

namespace {

constexpr qsizetype kLargestFile = 2'000'000; // bytes

QString idOf(const ExportFormat& format)
{
    return QString::fromLatin1(format.id.data(), qsizetype(format.id.size()));
}

const ExportFormat& format(const QString& id)
{
    return *findExportFormat(id.toStdString());
}

Scenario withThreeUavs()
{
    return changed([](Scenario& s) {
        s.uavs.resize(3, s.uavs[0]);
        for (std::size_t i = 0; i < s.uavs.size(); ++i) {
            s.uavs[i].id = "uav-" + std::to_string(i + 1);
            s.uavs[i].position_m.y() += 800 * double(i);
        }
    });
}

/** In the fjords of Greenland, over 500 km. */
Scenario amongLand()
{
    return changed([](Scenario& s) {
        s.origin = {.latitude_deg = 72, .longitude_deg = -26};
        for (Iceberg& iceberg : s.icebergs)
            iceberg.position_m *= 120;
    });
}

Scenario stormy()
{
    return changed([](Scenario& s) {
        s.wind_mps = Point(12, 5);
        s.uavs[0].spec.endurance_s = 1200;
        s.asset = Asset{.name = "Platform", .position_m = Point(2500, 0), .extraJson = {}};
    });
}

/** Names that a mission takes: it refuses what is no UTF-8. */
Scenario hostileFlown()
{
    Scenario scenario = hostile();
    scenario.icebergs[2].name = "\xC2\x85 and \x7F";
    return scenario;
}

/** An export with the mission it refers to, for its lifetime. */
class Source
{
public:
    Source(const Scenario& scenario, double flown_s, const ExportOptions& options)
        : m_scenario(scenario)
    {
        IcebergList order(scenario.icebergs.size());
        std::iota(order.begin(), order.end(), IcebergIndex());
        m_plan = planOf(order);
        if (flown_s > 0)
            m_mission.emplace(flown(m_scenario, flown_s));
        m_content = exportContent(
            {.scenario = m_scenario, .plan = m_plan, .mission = m_mission ? &*m_mission : nullptr},
            options);
    }
    Source(const Source&) = delete;
    Source& operator=(const Source&) = delete;

    [[nodiscard]] const ExportContent& content() const { return m_content; }

private:
    Scenario m_scenario;
    Plan m_plan;
    std::optional<Mission> m_mission;
    ExportContent m_content;
};

/** Nearly everything of one colour: nothing is drawn. */
bool isBlank(const QImage& image)
{
    std::set<QRgb> colours;
    for (int y = 0; y < image.height(); y += 7)
        for (int x = 0; x < image.width(); x += 7)
            colours.insert(image.pixel(x, y));
    return colours.size() < 8;
}

QString pngFault(const QByteArray& file, const QSize& size_px)
{
    const QImage image = QImage::fromData(file, "PNG");
    if (image.size() != 2 * size_px)
        return u"size %1 x %2"_s.arg(image.width()).arg(image.height());
    return isBlank(image) ? u"blank"_s : QString();
}

QString svgFault(const QByteArray& file, const QSize& size_px)
{
    if (const QString fault = xmlFault(file); !fault.isEmpty())
        return fault;
    QSvgRenderer renderer(file);
    if (!renderer.isValid() || renderer.viewBox().size() != size_px)
        return u"cannot be shown in its size"_s;
    if (file.contains("non-scaling-stroke")) // librsvg and others cannot draw it
        return u"lines that do not scale"_s;
    QImage image(size_px, QImage::Format_RGB32);
    QPainter painter(&image);
    renderer.render(&painter);
    return isBlank(image) ? u"blank"_s : QString();
}

QString pdfFault(const QByteArray& file)
{
    if (!file.startsWith("%PDF-"))
        return u"no PDF"_s;
    const qsizetype pages = file.count("/Type /Page\n"); // the log has one for 60 icebergs
    return pages >= 1 && pages <= 11 && file.contains("/Count " + QByteArray::number(pages) + "\n")
               ? QString()
               : u"not one page"_s;
}

QString faultOf(const QByteArray& file, const ExportFormat& written, const QSize& size_px)
{
    if (file.size() > kLargestFile)
        return u"%1 bytes"_s.arg(file.size());
    if (written.extension == "png")
        return pngFault(file, size_px);
    return written.extension == "svg" ? svgFault(file, size_px) : pdfFault(file);
}

void addRow(const QString& id, const char* name, const Scenario& scenario, double flown_s,
            const ExportOptions& options = {})
{
    QTest::addRow("%s, %s", qPrintable(id), name) << id << scenario << flown_s << options;
}

void pageRows()
{
    QTest::addColumn<QString>("id");
    QTest::addColumn<Scenario>("scenario");
    QTest::addColumn<double>("flown_s"); // zero exports the plan
    QTest::addColumn<ExportOptions>("options");
    const std::vector<std::pair<const char*, Scenario>> scenarios{
        {"four", fourIcebergs()},
        {"three UAVs", withThreeUavs()},
        {"hostile names", hostile()},
        {"across 180", at180()},
        {"North Pole",
         changed([](Scenario& s) { s.origin = {.latitude_deg = 90, .longitude_deg = 0}; })},
        {"South Pole",
         changed([](Scenario& s) { s.origin = {.latitude_deg = -89.99, .longitude_deg = 180}; })},
        {"no start", changed([](Scenario& s) { s.startUtc.clear(); })},
        {"no icebergs", changed([](Scenario& s) { s.icebergs.clear(); })},
        {"land", amongLand()},
        {"wind, asset, endurance", stormy()},
        {"500 icebergs", fiveHundred()}};
    for (const ExportFormat& row : exportFormats()) {
        if (!row.holds.painted)
            continue;
        const QString id = idOf(row);
        for (const auto& [name, scenario] : scenarios) {
            const bool isHostile = scenario.name == hostile().name;
            addRow(id, qPrintable(QString::fromLatin1(name) + u", flown"_s),
                   isHostile ? hostileFlown() : scenario, 90);
            if (row.holds.flownOnly)
                continue;
            addRow(id, name, scenario, 0);
        }
        if (row.holds.flownOnly)
            continue;
        addRow(id, "one of three", withThreeUavs(), 0, {.uav = "uav-2"});
        addRow(id, "path home", stormy(), 0, {.what = ExportScope::Path, .returnHome = true});
        addRow(id, "first leg in flight", fourIcebergs(), 90, {.what = ExportScope::FirstLeg});
    }
}

} // namespace

class TestExportPages : public QObject
{
    Q_OBJECT

private slots:
    void init() { QTest::failOnWarning(QRegularExpression(u".*"_s)); }

    /** Every painted format renders for every place, name and kind of path. */
    void filesAreWhole_data() { pageRows(); }

    void filesAreWhole()
    {
        QFETCH(QString, id);
        QFETCH(Scenario, scenario);
        QFETCH(double, flown_s);
        QFETCH(ExportOptions, options);
        const Source source(scenario, flown_s, options);
        const std::string file = exportPaint().file(format(id), source.content());
        const QSize size_px = exportPage(format(id), source.content(), QLocale()).size_px;
        const QString fault = faultOf(bytes(file), format(id), size_px);
        QVERIFY2(fault.isEmpty(), qPrintable(fault));
    }

    void filesAreTheSameAgainAndOnAnyThread_data()
    {
        QTest::addColumn<QString>("id");
        for (const ExportFormat& row : exportFormats())
            if (row.holds.painted)
                QTest::newRow(row.id.data()) << idOf(row);
    }

    void filesAreTheSameAgainAndOnAnyThread()
    {
        QFETCH(QString, id);
        const Source source(withThreeUavs(), 90, {});
        const auto file = [&] { return exportPaint().file(format(id), source.content()); };
        const std::string first = file();
        QVERIFY(file() == first);
        std::string elsewhere;
        std::thread([&] { elsewhere = file(); }).join();
        QVERIFY(elsewhere == first);
    }

    void previewIsThePage_data() { filesAreTheSameAgainAndOnAnyThread_data(); }

    void previewIsThePage()
    {
        QFETCH(QString, id);
        const Source source(fourIcebergs(), 90, {});
        const QImage preview = exportPaint().prepare(format(id), source.content()).image();
        const QSize size_px = exportPage(format(id), source.content(), QLocale()).size_px;
        QVERIFY(preview.width() >= size_px.width());
        QCOMPARE(preview.deviceIndependentSize().toSize(), size_px);
        QVERIFY(!isBlank(preview));
    }

    void unknownFormatsAreBugs()
    {
        const Source source(fourIcebergs(), 0, {});
        for (const char* id : {"gpx", "plan", "poster"})
            QVERIFY_THROWS_EXCEPTION(
                std::logic_error,
                (void)exportPage({.id = id, .extension = "pdf"}, source.content(), QLocale()));
    }

    void chartsNeedAFlight()
    {
        const Source source(fourIcebergs(), 0, {});
        const std::optional<Error> error =
            errorOf([&] { (void)chartPage(source.content(), QLocale()); });
        QVERIFY(error.has_value());
        QCOMPARE(error->code(), ErrorCode::InvalidInput);
        QCOMPARE(error->subject(), std::string("format"));
    }

    void pagesHaveTitles_data()
    {
        QTest::addColumn<double>("flown_s");
        QTest::addColumn<ExportOptions>("options");
        QTest::addColumn<QString>("what");
        QTest::newRow("track") << 90. << ExportOptions{} << u"Flown until 00:01:00Z +1"_s;
        QTest::newRow("order") << 0. << ExportOptions{} << u"Planned order"_s;
        QTest::newRow("order in flight") << 90. << ExportOptions{.what = ExportScope::Order}
                                         << u"Planned order at 00:01:00Z +1"_s;
        QTest::newRow("first leg")
            << 0. << ExportOptions{.what = ExportScope::FirstLeg} << u"First leg"_s;
        QTest::newRow("path") << 0. << ExportOptions{.what = ExportScope::Path}
                              << u"Planned path with turns"_s;
    }

    void pagesHaveTitles()
    {
        QFETCH(double, flown_s);
        QFETCH(ExportOptions, options);
        QFETCH(QString, what);
        const Source source(fourIcebergs(), flown_s, options);
        const PicturePage page = mapPage(source.content(), QLocale::c());
        QCOMPARE(page.size_px, QSize(1120, 700));
        QCOMPARE(page.title, u"Four icebergs"_s);
        QCOMPARE(page.description,
                 what + u" · Nearest iceberg first · Start 2026-05-01 23:59:30 UTC"_s);
    }

    /** The content may go before the page is painted. */
    void pagesOwnTheirData()
    {
        PicturePage page;
        std::string expected;
        for (const char* id : {"map-svg", "charts-svg"}) {
            {
                const Source source(fourIcebergs(), 90, {});
                page = exportPage(format(QString::fromLatin1(id)), source.content(), QLocale());
                expected = pictureFile(page, u"svg"_s);
            }
            QVERIFY(pictureFile(page, u"svg"_s) == expected);
        }
    }

    void mapIsAsThingsStand()
    {
        const Scenario scenario = changed([](Scenario& s) {
            s.icebergs[2].appears_s = 200;
            s.fovShape = FovShape::Disk;
            s.uavs[0].home_m = Point(0, 0);
            s.asset = Asset{.name = "Platform", .position_m = Point(2500, 0), .extraJson = {}};
        });
        const Source plan(scenario, 0, {});
        const MapPicture planned = exportPicture(plan.content());
        QCOMPARE(planned.icebergs.size(), std::size_t{4});
        QCOMPARE(planned.icebergs[2].appears_s, 200.0);
        QCOMPARE(planned.sigmaFull_m2, sigmaEnd_m2(scenario)); // as on the map of the window
        const auto isAlarm = [](const MapIceberg& iceberg) {
            return iceberg.ringEntry_s.has_value();
        };
        QVERIFY(std::ranges::any_of(planned.icebergs, isAlarm));
        QCOMPARE(planned.uavs[0].position_m, scenario.uavs[0].position_m);
        QVERIFY(planned.uavs[0].sensor.shape == FovShape::Disk);
        const Source track(scenario, 90, {});
        const MapPicture shown = exportPicture(track.content());
        QCOMPARE(shown.icebergs.size(), std::size_t{3}); // the other one has not come yet
        QCOMPARE(shown.sigmaFull_m2, planned.sigmaFull_m2);
        QVERIFY(std::ranges::any_of(shown.icebergs, isAlarm));
        ExportContent inDialog = track.content(); // which has no mission
        inDialog.mission = nullptr;
        const MapPicture same = exportPicture(inDialog);
        for (std::size_t i = 0; i < shown.icebergs.size(); ++i)
            QCOMPARE(same.icebergs[i].ringEntry_s, shown.icebergs[i].ringEntry_s);
        const DubinsState last = track.content().uavs[0].track.back().state;
        QCOMPARE(shown.uavs[0].position_m, last.position_m);
        QCOMPARE(shown.uavs[0].psi_rad, last.psi_rad);
        QCOMPARE(shown.uavs[0].home_m, std::optional(Point(0, 0)));
        QVERIFY(shown.routes[0].plan.empty() && shown.routes[0].track.size() > 50);
    }

    void lostIcebergsAreMarked()
    {
        const Source source(fourIcebergs(), 90, {});
        ExportContent content = source.content();
        content.icebergs[1].state = IcebergState::Lost;
        content.icebergs[2].state = IcebergState::GivenUp;
        const MapPicture picture = exportPicture(content);
        QVERIFY(picture.icebergs[0].status == TrackStatus::Tracked);
        QVERIFY(picture.icebergs[1].status == TrackStatus::Lost);
        QVERIFY(picture.icebergs[2].status == TrackStatus::GivenUp);
    }

    void numbersAreOfTheLocale()
    {
        const Source source(fourIcebergs(), 0, {});
        const QLocale german(QLocale::German, QLocale::Germany);
        const QString text =
            QString::fromStdString(pictureFile(mapPage(source.content(), german), u"svg"_s));
        // Each figure is by itself in SVG, as digits are drawn to one width.
        QVERIFY(QRegularExpression(u">,<"_s).match(text).hasMatch());
        QLocale::setDefault(german);
        const std::string file = exportPaint().file(format(u"map-svg"_s), source.content());
        QLocale::setDefault(QLocale::c());
        QCOMPARE(QString::fromStdString(file), text);
    }

    void namesAreEscaped()
    {
        const Source source(hostileFlown(), 90, {});
        for (const char* id : {"map-svg", "charts-svg"}) {
            const QByteArray file =
                bytes(exportPaint().file(format(QString::fromLatin1(id)), source.content()));
            QVERIFY(!file.contains("<b>") && !file.contains("</kml>") && !file.contains('\x01'));
            QXmlStreamReader xml(file);
            QString texts;
            while (!xml.atEnd()) {
                xml.readNext();
                if (xml.isStartElement() && xml.name() == u"text"_s)
                    texts += xml.readElementText();
            }
            QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
            QVERIFY2(texts.contains(u"<name>&amp;\"'"_s), qPrintable(texts));
        }
    }

    void trackShowsItsVisits()
    {
        const Source source(fourIcebergs(), 400, {});
        QVERIFY(!source.content().uavs[0].visits.empty());
        const QByteArray file = bytes(pictureFile(mapPage(source.content(), QLocale()), u"svg"_s));
        QVERIFY(file.contains("dots on the path"));
        qsizetype timed = 0; // not where there is no room
        for (const Visit& visit : source.content().uavs[0].visits)
            timed +=
                file.count(
                    u">%1<"_s.arg(MissionClock{source.content().start}.columnText(visit.time_s))
                        .toUtf8()) > 0
                    ? 1
                    : 0;
        QVERIFY(timed >= 3);
        const Source plan(fourIcebergs(), 400, {.what = ExportScope::Order});
        QVERIFY(!bytes(pictureFile(mapPage(plan.content(), QLocale()), u"svg"_s))
                     .contains("dots on the path"));
    }
};

QTEST_MAIN(TestExportPages)
#include "tst_export_pages.moc"
