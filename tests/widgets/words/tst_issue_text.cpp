#include "core/checks/validate.h"
#include "core/io/files/problem_json.h"
#include "core/io/files/run_json.h"
#include "core/io/files/scenario_json.h"
#include "tests/support/expect_error.h"
#include "tests/support/flight/scenario_builder.h"
#include "widgets/theme/unit_settings.h"
#include "widgets/words/issue_text.h"

#include <QDirIterator>
#include <QRegularExpression>
#include <QSet>
#include <QTranslator>
#include <QtTest>

#include <cerrno>
#include <limits>
#include <system_error>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

/** Returns an issue with this id and enough arguments for any text. */
Issue exampleOf(int id)
{
    return {.field = "icebergs[3].q_m2ps",
            .reason = {.id = static_cast<IssueId>(id), .arguments = {1.0, 2.0, 3.0}}};
}

/** A scenario with as many faults as possible. */
Scenario wrongAllOver()
{
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    Scenario s = test::emptySea();
    s.name = "\xFF";
    s.notes = "\xFF";
    s.origin = {.latitude_deg = 91, .longitude_deg = 181};
    s.startUtc = "yesterday";
    s.duration_s = 0.001;
    s.dt_s = 2;
    s.seed = -1;
    s.area_m = {{0, 0}, {1e9, 0}, {0, 1e9}};
    s.geofence = true;
    s.separation_m = -1;
    s.current_mps = {99, 99};
    s.wind_mps = {kNan, 0};
    Uav& uav = s.uavs[0];
    uav.id = "";
    uav.name = "\xFF";
    uav.position_m = uav.fov_m = {1e9, 1e9};
    uav.home_m = Point(1e9, 1e9);
    uav.heading_deg = kNan;
    uav.turnaround_s = -1;
    uav.spec = {.airspeed_mps = -1, .maxBank_deg = 89, .altitude_m = -1};
    uav.spec.endurance_s = uav.spec.autopilot_s = 1e300;
    for (const char* id : {"same", "same"}) {
        Iceberg& iceberg = test::addIceberg(s, 1e9, 1e9);
        iceberg.id = id;
        iceberg.name = "\xFF";
        iceberg.uav = "nobody";
        iceberg.velocity_mps = {99, 99};
        iceberg.velocitySpread_mps = iceberg.velocityTime_s = -1;
        iceberg.velocitySd_mps = iceberg.q_m2ps = iceberg.sigma0_m2 = -1;
        iceberg.observed_s = iceberg.appears_s = iceberg.radius_m = -1;
        iceberg.track = {.time_s = {2, 1}, .position_m = {{1e9, 0}, {0, 0}}};
    }
    s.icebergs[1].track.time_s = {1};
    s.asset = Asset{.name = "\xFF", .position_m = {1e9, 1e9}, .velocity_mps = {99, 99}};
    s.asset->range_m = s.asset->gain = -1;
    s.asset->alarm_m = -1;
    s.observer = {.model = ObserverModel::Kalman, .positionSd_m = -1, .detection = 2};
    s.observer.interval_s = -1;
    s.planner.tau = -1;
    s.planningTime_s = -1;
    s.reachRadius_m = -1;
    return s;
}

/** Reads a file as the type of its extension. */
void read(const std::string& path)
{
    if (path.ends_with(".berg"))
        (void)loadScenario(path);
    else if (path.ends_with(".json") || path.ends_with("tsp"))
        (void)loadProblem(path);
    else
        (void)loadRun(path);
}

} // namespace

/** Findings in the window: in its language and units, whatever the core's text is. */
class TestIssueText : public QObject
{
    Q_OBJECT

private slots:
    void distancesHaveTheUnitOfTheUser()
    {
        const Issue issue =
            Issue{Severity::Warning,
                  "icebergs[0].observed_s",
                  {.id = IssueId::SeenLongAgo,
                   .arguments = {std::string("0:35"), Amount{7100, Quantity::Distance},
                                 std::int64_t{12}}}};
        QCOMPARE(
            issueText(issue, QLocale::c()),
            u"Last seen: 0:35 h before the start; the iceberg may be 7.1 km from this position, 12 times the field of view"_s);
    }

    void init() { QLocale::setDefault(QLocale::c()); }

    void everyReasonHasItsWords()
    {
        QSet<QString> texts;
        for (int id = 0; id < kIssueIds; ++id) {
            const QString text = issueText(exampleOf(id));
            QVERIFY2(!text.contains(u'%'), qPrintable(text));
            texts << text;
        }
        QCOMPARE(texts.size(), kIssueIds);
    }

    /** Files have the numbers of files, and units where a number is not that of the field. */
    void filesHaveSi()
    {
        QCOMPARE(englishText({IssueId::WindLimit,
                              {Amount{12.5, Quantity::Speed}, Amount{10, Quantity::Speed}}}),
                 std::string("must not be exceeded: wind of 12.5 m/s, limit 10 m/s"));
        QCOMPARE(englishText({.id = IssueId::OutOfRange, .arguments = {0.0, 1e6, -2.5}}),
                 std::string("must be from 0 to 1000000, not -2.5"));
    }

    void saysItInUnits()
    {
        const Issue growth = Issue{Severity::Error,
                                   "icebergs[3].q_m2ps",
                                   {.id = IssueId::OutOfRange, .arguments = {0.0, 1.0, 4.5}}};
        QCOMPARE(issueText(growth), u"Growth q: must be from 0 m²/s to 1 m²/s, not 4.5 m²/s"_s);
        const Issue wind = Issue{Severity::Error,
                                 "uavs[0].airspeed_mps",
                                 {.id = IssueId::OutOfRange, .arguments = {0.0, 1852 / 3.6, 0.0}}};
        setShownUnits({.speed = SpeedUnit::Knots});
        const QString knots = issueText(wind);
        setShownUnits({});
        QCOMPARE(knots, u"Airspeed: must be from 0 kn to 1\u202f000 kn, not 0 kn"_s);
    }

    /** A name may look like a place holder. */
    void namesAreTakenAsTheyAre()
    {
        QCOMPARE(issueText(Issue{Severity::Error,
                                 "icebergs[0].uav",
                                 {.id = IssueId::UnknownUav, .arguments = {std::string("%1")}}}),
                 u"Visited by: there is no UAV \"%1\" in this scenario"_s);
    }

    /** The text used to be "icebergs[3].q_m2ps: must be ...". */
    void norwegiansReadNoEnglish()
    {
        const Scenario scenario = wrongAllOver();
        const std::vector<Issue> issues = validate(scenario);
        QVERIFY2(issues.size() > 60, qPrintable(QString::number(issues.size())));
        QStringList english;
        for (const Issue& issue : issues)
            english << issueText(issue);
        QStringList ofIds;
        for (int id = 0; id < kIssueIds; ++id)
            ofIds << issueText(exampleOf(id));
        QTranslator norwegian;
        QVERIFY(norwegian.load(u":/i18n/bergwatch_nb.qm"_s));
        QCoreApplication::installTranslator(&norwegian);
        QStringList wrong;
        for (std::size_t i = 0; i < issues.size(); ++i) {
            const QString text = issueText(issues[i]);
            if (text == english[static_cast<qsizetype>(i)] || text.contains(u" must "_s) ||
                text.contains(u"_") || text.contains(u'['))
                wrong << text;
        }
        for (int id = 0; id < kIssueIds; ++id)
            if (issueText(exampleOf(id)) == ofIds[id] && id != static_cast<int>(IssueId::Verbatim))
                wrong << ofIds[id];
        QCoreApplication::removeTranslator(&norwegian);
        QVERIFY2(wrong.empty(), qPrintable(wrong.join(u'\n')));
    }

    /** System errors are in the window's language, whatever the C library's is. */
    void whyTheSystemRefuses()
    {
        const auto said = [](int number) {
            return issueText(
                {.reason = {IssueId::CannotOpen, {std::generic_category().message(number)}}});
        };
        QCOMPARE(said(ENOENT), u"Cannot be opened: no such file or folder"_s);
        QTranslator norwegian;
        QVERIFY(norwegian.load(u":/i18n/bergwatch_nb.qm"_s));
        QCoreApplication::installTranslator(&norwegian);
        const QString full = said(ENOSPC);
        QCoreApplication::removeTranslator(&norwegian);
        QCOMPARE(full, u"Kan ikke åpnes: disken er full"_s);
    }

    /** A point as a whole has no label, and neither has a UAV. */
    void ownersComeFirst()
    {
        Scenario scenario = test::emptySea();
        scenario.uavs[0].name = "Heidrun";
        const auto line = [&](const char* field, IssueReason reason) {
            return issueLine({Severity::Warning, field, std::move(reason)}, scenario);
        };
        QCOMPARE(line("uavs[0].position_m", {IssueId::UavOutside}),
                 u"Heidrun: starts outside the area"_s);
        QCOMPARE(line("uavs[0].home_m", {IssueId::OutsideFence}),
                 u"Heidrun, Home: must be inside the area, which is a geofence"_s);
        QCOMPARE(line("area_m", {IssueId::AreaNotSimple}),
                 u"The area must neither touch nor cross itself"_s);
        QCOMPARE(line("area_m[3][1]", {IssueId::NotFinite}),
                 u"Corner of the area: must be a finite number"_s);
        QCOMPARE(
            line("uavs[0].id", {IssueId::IdTaken, {std::string("a"), FieldPath{"icebergs[2]"}}}),
            u"Heidrun, Id: \"a\" is the id of iceberg 3 already: each iceberg and UAV needs a "
            "unique id"_s);
    }

    /** Places in files are counted as the readers do. */
    void placesInFilesAreNamed()
    {
        const auto text = [](const char* place) {
            return placedIssueText({Severity::Error, place, {IssueId::FileEmpty}});
        };
        for (const char* place : {"line 3", "feature 3", "packet 3"})
            QVERIFY2(text(place).startsWith(QString::fromLatin1(place) + u": "_s), place);
    }

    /** Every finding of a broken file has an id and a Norwegian text. */
    void brokenFilesAreReportedInNorwegian()
    {
        QTranslator norwegian;
        QVERIFY(norwegian.load(u":/i18n/bergwatch_nb.qm"_s));
        QCoreApplication::installTranslator(&norwegian);
        QStringList wrong;
        int count = 0;
        QDirIterator files(QStringLiteral(BERG_TEST_DATA "/broken"),
                           {u"*.berg"_s, u"*.json"_s, u"*.bergrun"_s}, QDir::Files,
                           QDirIterator::Subdirectories);
        while (files.hasNext()) {
            const QFileInfo file(files.next());
            const std::optional<Error> error =
                test::errorOf([&] { read(file.filePath().toStdString()); });
            QVERIFY2(error, qPrintable(file.fileName()));
            ++count;
            static const QRegularExpression kEnglish(
                u"\\b(must|is|be|not|the|and|than|has|have|with|or|number)\\b"_s);
            const QStringList lines = issueLines(*error);
            for (std::size_t i = 0; i < error->issues().size(); ++i)
                if (error->issues()[i].reason.id == IssueId::Verbatim ||
                    lines[static_cast<qsizetype>(i)].contains(kEnglish))
                    wrong << file.fileName() + u": "_s + lines[static_cast<qsizetype>(i)];
        }
        QCoreApplication::removeTranslator(&norwegian);
        QVERIFY2(wrong.empty(), qPrintable(wrong.join(u'\n')));
        QVERIFY(count > 200);
    }
};

QTEST_MAIN(TestIssueText)
#include "tst_issue_text.moc"
