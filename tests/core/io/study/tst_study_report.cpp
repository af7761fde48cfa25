#include "core/io/figure/policy_style.h"
#include "core/io/figure/report_style.h"
#include "core/io/study/study_json.h"
#include "core/io/study/study_report.h"
#include "core/io/text/atomic_file.h"
#include "core/io/text/html_text.h"
#include "core/io/text/system_info.h"
#include "tests/support/approx.h"

#include <QRegularExpression>
#include <QTemporaryDir>
#include <QXmlStreamReader>

#include <clocale>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

/** A spec of tau 0.5, 1, 2, then path, with made-up outcomes and nothing flown. */
Study madeUp(int cases)
{
    Study study;
    study.spec = {.name = "Made up",
                  .random = cases,
                  .taus = {0.5, 1, 2},
                  .policies = {PolicyKind::Visitation, PolicyKind::Path}};
    study.outcomes.resize(missionCount(study.spec));
    return study;
}

void setZeta(Study& study, std::size_t caseIndex, const std::vector<double>& zeta_m2s)
{
    for (std::size_t s = 0; s < zeta_m2s.size(); ++s)
        study.outcomes.at(caseIndex * 4 + s) =
            MissionOutcome{.metrics = {.zeta_m2s = zeta_m2s[s], .visits = 7}, .stuck = s == 2};
}

Study threeCases()
{
    Study study = madeUp(3);
    setZeta(study, 0, {11000, 10000, 9000, 12000});
    setZeta(study, 1, {19000, 20000, 22000, 15000});
    setZeta(study, 2, {40000, 40000, 40000, 50000});
    return study;
}

Study oneCase()
{
    Study study = madeUp(1);
    setZeta(study, 0, {11000, 10000, 9000, 12000});
    return study;
}

Study unfinished()
{
    Study study = threeCases();
    study.outcomes[6].reset();
    return study;
}

std::string reportOf(const Study& study)
{
    return studyReportHtml(study, summarise(study, usualReference(study.spec)),
                           {.program = "Bergwatch 9.8",
                            .machine = "A <fast> machine",
                            .madeUtc = "2026-05-01T12:00:00Z",
                            .elapsed_s = 725.2});
}

/** The page as read by an independent parser. */
struct Page
{
    QString error;
    QString title;
    QMap<QString, int> elements;
    QList<QStringList> rows; ///< texts of the cells of all tables
    QString text;            ///< all text except styles and scripts

    [[nodiscard]] QStringList row(const QString& name, int table) const
    {
        int seen = 0;
        for (const QStringList& cells : rows)
            if (cells.value(0) == name && seen++ == table)
                return cells;
        return {};
    }
};

Page parsed(const std::string& html)
{
    Page page;
    QStringList open;
    QXmlStreamReader reader(QByteArray::fromStdString(html));
    while (!reader.atEnd()) {
        reader.readNext();
        if (reader.isStartElement()) {
            open.append(reader.name().toString());
            ++page.elements[open.back()];
            if (open.back() == "tr"_L1)
                page.rows.append(QStringList());
            if (open.back() == "td"_L1 || open.back() == "th"_L1)
                page.rows.back().append(QString());
        } else if (reader.isEndElement()) {
            open.removeLast();
        } else if (reader.isCharacters() && !open.isEmpty()) {
            if (open.contains("tr"_L1) && !page.rows.back().isEmpty())
                page.rows.back().back() += reader.text();
            if (open == QStringList{u"html"_s, u"head"_s, u"title"_s})
                page.title += reader.text();
            if (open.back() != "style"_L1 && open.back() != "script"_L1)
                page.text += reader.text();
        }
    }
    page.error = reader.errorString();
    return page;
}

/** Points of the first element of this class. */
QList<QPointF> pointsOf(const std::string& html, const QString& style)
{
    const QRegularExpression element(u"class=\"%1 [a-z-]*\" points=\"([^\"]*)\""_s.arg(style));
    QList<QPointF> points;
    const QString all = element.match(QString::fromStdString(html)).captured(1);
    for (const QString& pair : all.split(' ', Qt::SkipEmptyParts))
        points.append({pair.section(',', 0, 0).toDouble(), pair.section(',', 1).toDouble()});
    return points;
}

double luminance(const QString& hex)
{
    const auto channel = [&](int at) {
        const double c = hex.mid(at, 2).toInt(nullptr, 16) / 255.0;
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * channel(1) + 0.7152 * channel(3) + 0.0722 * channel(5);
}

} // namespace

class TestStudyReport : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        std::setlocale(LC_ALL, "nb_NO.UTF-8"); // if it exists; it must not matter
    }

    void pageIsWellFormed_data()
    {
        QTest::addColumn<Study>("study");
        QTest::newRow("three cases") << threeCases();
        QTest::newRow("one case") << oneCase();
        QTest::newRow("not complete") << unfinished();
        QTest::newRow("nothing flown") << madeUp(2);
        Study policies = madeUp(2);
        policies.spec.policies = {PolicyKind::Path, PolicyKind::Tour, PolicyKind::Nearest};
        policies.outcomes.assign(6, MissionOutcome{.metrics = {.zeta_m2s = 5}});
        QTest::newRow("no tau") << policies;
        Study nothing = threeCases();
        for (std::optional<MissionOutcome>& outcome : nothing.outcomes)
            outcome->metrics.zeta_m2s = 0;
        QTest::newRow("zeta 0 throughout") << nothing;
    }

    /** The page is XML, so all HTML readers find the same tree, and it still contains the study. */
    void pageIsWellFormed()
    {
        QFETCH(Study, study);
        const std::string html = reportOf(study);
        const Page page = parsed(html);
        QCOMPARE(page.error, QString());
        QCOMPARE(page.title, u"Made up"_s);
        QVERIFY(!page.text.contains("nan"_L1) && !page.text.contains("inf"_L1));
        QVERIFY(studyFromJson(studyOfReport(html, "x"), "x") == study);
    }

    /** The page loads and runs nothing. */
    void pageIsSelfContained()
    {
        const std::string html = reportOf(threeCases());
        const QString text = QString::fromStdString(html);
        for (const auto& word : {"src="_L1, "href="_L1, "url("_L1, "@import"_L1, "onload"_L1})
            QVERIFY2(!text.contains(word), word.data());
        QVERIFY(text.contains("default-src 'none'"_L1));
        QCOMPARE(parsed(html).elements.value(u"script"_s), 1);
    }

    void tablesHaveTheNumbers()
    {
        const Page page = parsed(reportOf(threeCases()));
        // Mean of 9000, 22000, 40000; standard error of the mean 8987.6.
        const QStringList two = page.row(u"τ = 2"_s, 0);
        QCOMPARE(two.size(), 10);
        QCOMPARE(two[1], u"23\u202f667"_s);
        QCOMPARE(two[2], u"8\u202f988"_s);
        QCOMPARE(two[5], u"22\u202f000"_s);
        QCOMPARE(two[8], u"7.0"_s);
        QCOMPARE(two[9], u"100.0 %"_s);
        // Relative -0.1, 0.1, 0: mean 0, half interval 4.3027 x 0.1 / sqrt 3 = 24.84 %.
        const QStringList difference = page.row(u"τ = 2"_s, 1);
        QCOMPARE(difference.size(), 7);
        QCOMPARE(difference[1], u"+333"_s);
        QCOMPARE(difference[3], u"0.00"_s);
        QCOMPARE(difference[4], u"−24.84 … +24.84"_s);
        QCOMPARE(difference[5], u"33.3 %"_s);
        QCOMPARE(difference[6], u"+10.0 %"_s);
        QCOMPARE(page.row(u"τ = 1"_s, 1).value(1), u"reference"_s);
        // The best are 2, 0.5, and 0.5 among three equal ones.
        QCOMPARE(page.row(u"τ = 0.5"_s, 2), (QStringList{u"τ = 0.5"_s, u"2"_s, u"66.7 %"_s}));
    }

    void curveIsDrawnToScale()
    {
        const std::string html = reportOf(threeCases());
        const QList<QPointF> mean = pointsOf(html, u"mean"_s);
        QCOMPARE(mean.size(), 3); // 23333, 23333, 23667 at 0.5, 1, 2
        COMPARE_NEAR((mean[2].x() - mean[1].x()) / (mean[1].x() - mean[0].x()), 2, 0.01);
        COMPARE_NEAR(mean[0].y(), mean[1].y(), 0.01);
        QVERIFY(mean[2].y() < mean[1].y());            // more is higher
        QCOMPARE(pointsOf(html, u"half"_s).size(), 6); // there and back
        QCOMPARE(pointsOf(html, u"half"_s)[0].x(), mean[0].x());
    }

    void oneCaseIsACurve()
    {
        const std::string html = reportOf(oneCase());
        QCOMPARE(pointsOf(html, u"mean"_s).size(), 3);
        QVERIFY(pointsOf(html, u"half"_s).isEmpty());
        const Page page = parsed(html);
        QCOMPARE(page.elements.value(u"svg"_s), 1);
        QCOMPARE(page.row(u"path"_s, 0), (QStringList{u"path"_s, u"12\u202f000"_s, u"+2\u202f000"_s,
                                                      u"+20.00"_s, u"7"_s, u"no"_s}));
        QVERIFY(page.row(u"path"_s, 1).isEmpty());
    }

    void incompleteStudyIsMarked()
    {
        const Page page = parsed(reportOf(unfinished()));
        QVERIFY(page.text.contains("Missions flown: 11 of 12."_L1));
        QVERIFY(page.text.contains("every setting has flown: 2 of 3."_L1));
        const Page none = parsed(reportOf(madeUp(2)));
        QVERIFY(none.text.contains("Missions flown: 0 of 8."_L1));
        QCOMPARE(none.elements.value(u"table"_s), 0);
        QVERIFY(!parsed(reportOf(threeCases())).text.contains("Not complete"_L1));
    }

    void setupIsListed()
    {
        Study study = threeCases();
        study.spec.firstSeed = 1001;
        study.spec.taus = {0, 0.1, 0.2, 0.30000000000000004, 0.4};
        study.outcomes.assign(missionCount(study.spec), MissionOutcome{});
        const QString text = parsed(reportOf(study)).text;
        for (const QString& words :
             {u"Random fields: 3, seeds 1001 to 1003. Icebergs in each: 12, in 5000 m × 4000 m"_s,
              u"0 to 0.4 by 0.1 (5 values)"_s, u"18 of 18"_s, u"Bergwatch 9.8"_s,
              u"A <fast> machine"_s, u"2026-05-01T12:00:00Z"_s, u"12 min 5 s"_s,
              u"bergwatch-cli sweep --random 3 --first-seed 1001 --tau 0:0.4:0.1 "
              "--policies visitation,path --report"_s})
            QVERIFY2(text.contains(words), qPrintable(words));
    }

    /** Every sentence is translated; names, numbers, units and commands remain. */
    void everySentenceIsTranslated()
    {
        const Study study = threeCases();
        ReportOrigin origin{
            .program = "Bergwatch 9.8", .machine = {}, .madeUtc = {}, .elapsed_s = 2};
        origin.words = ReportWords([](std::string_view english) {
            std::string other;
            for (std::size_t i = 0; i < english.size(); ++i)
                other +=
                    std::isalpha(static_cast<unsigned char>(english[i])) != 0 ? 'x' : english[i];
            return other;
        });
        const Page page =
            parsed(studyReportHtml(study, summarise(study, usualReference(study.spec)), origin));
        QCOMPARE(page.error, QString());
        QString text = page.text;
        text.remove(QRegularExpression(u"bergwatch-cli [^\\n]*|Bergwatch 9.8|Made up"_s));
        const QRegularExpression word(u"[A-Za-wyz]{3,}"_s);
        const QSet<QString> names{u"path"_s, u"tour"_s, u"visitation"_s};
        for (auto found = word.globalMatch(text); found.hasNext();) {
            const QString one = found.next().captured();
            QVERIFY2(names.contains(one), qPrintable(one));
        }
    }

    void hostileNamesAreEscaped_data()
    {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<QString>("shown");
        const auto as = [](const char* text) { return QString::fromUtf8(text); };
        QTest::newRow("markup") << QByteArray("<b>&amp; \"x\" 'y'") << as("<b>&amp; \"x\" 'y'");
        QTest::newRow("end of script") << QByteArray("</script><script>alert(1)</script>")
                                       << as("</script><script>alert(1)</script>");
        QTest::newRow("the study's own mark")
            << QByteArray(R"(<script type="application/json" id="study">{}</script>)")
            << as(R"(<script type="application/json" id="study">{}</script>)");
        QTest::newRow("comments") << QByteArray("<!-- --> ]]> <![CDATA[")
                                  << as("<!-- --> ]]> <![CDATA[");
        QTest::newRow("line ends")
            << QByteArray("one\ntwo\r\nthree\tfour") << as("one two  three four");
        QTest::newRow("emoji and right to left")
            << QByteArray("🧊 جبل \u202eabc") << as("🧊 جبل \u202eabc");
        QTest::newRow("controls") << QByteArray("a\x01\x7f\xC2\x85") << as("a\uFFFD\uFFFD\uFFFD");
        QTest::newRow("no characters")
            << QByteArray("a\xEF\xBF\xBE\xEF\xBF\xBF") << as("a\uFFFD\uFFFD");
        QTest::newRow("backslashes") << QByteArray("\\u003c \\") << as("\\u003c \\");
    }

    void hostileNamesAreEscaped()
    {
        QFETCH(QByteArray, name);
        QFETCH(QString, shown);
        Study study = threeCases();
        study.spec.name = name.toStdString();
        study.spec.scenarios = {randomScenario(1)};
        study.spec.scenarios[0].name = study.spec.name;
        study.outcomes.resize(missionCount(study.spec));
        const std::string html = reportOf(study);
        const Page page = parsed(html);
        QCOMPARE(page.error, QString());
        QCOMPARE(page.title, shown);
        QVERIFY(page.text.contains(shown + u": icebergs: 12, seed 1"_s));
        QCOMPARE(page.elements.value(u"script"_s), 1);
        QCOMPARE(page.elements.value(u"bdi"_s), 2); // heading and scenario
        // An HTML reader ends a script at the first of these, even within quotes.
        QCOMPARE(QString::fromStdString(html).count("</script"_L1), 1);
        QVERIFY(studyFromJson(studyOfReport(html, "x"), "x") == study);
    }

    void brokenUtf8IsReplaced()
    {
        QCOMPARE(htmlText("a\xFFz\xC3"), std::string("a\uFFFDz\uFFFD"));
        QCOMPARE(htmlName("a<b"), std::string("<bdi>a&lt;b</bdi>"));
    }

    void reportLoadsLikeAStudyFile()
    {
        const QTemporaryDir folder;
        const std::string path = folder.filePath(u"report.html"_s).toStdString();
        const Study study = unfinished();
        writeFileAtomically(path, reportOf(study));
        QVERIFY(loadStudy(path) == study);
        writeFileAtomically(path, "\xEF\xBB\xBF\n<html><body>nothing</body></html>");
        try {
            (void)loadStudy(path);
            QFAIL("a page without a study was read");
        } catch (const Error& error) {
            QCOMPARE(error.code(), ErrorCode::WrongFormat);
            QCOMPARE(error.subject(), path);
        }
    }

    void truncatedReportIsRejected()
    {
        const std::string html = reportOf(threeCases());
        const std::size_t middle = html.find("\"outcomes\"");
        QVERIFY(middle != std::string::npos);
        QVERIFY_THROWS_EXCEPTION(Error, (void)studyOfReport(html.substr(0, middle), "x"));
    }

    void reportsAreDistinguishedFromStudyFiles()
    {
        QVERIFY(isReport(reportOf(oneCase())));
        QVERIFY(isReport("\xEF\xBB\xBF \r\n<!DOCTYPE html>"));
        QVERIFY(!isReport(studyToJson(oneCase())));
        QVERIFY(!isReport(""));
    }

    /** The report is the same in every run, except for its origin. */
    void reportIsReproducible() { QCOMPARE(reportOf(threeCases()), reportOf(threeCases())); }

    /**
     * DESIGN requires contrasts to the page of 3 : 1 for lines and 4.5 : 1 for text, light and
     * dark.
     */
    void coloursHaveEnoughContrast()
    {
        const QString style =
            QString::fromUtf8(kReportStyle.data(), qsizetype(kReportStyle.size()));
        const QStringList themes = style.split(u"prefers-color-scheme: dark"_s);
        QCOMPARE(themes.size(), 2);
        for (const QString& theme : themes) {
            QMap<QString, double> colours;
            auto found = QRegularExpression(u"--(\\w+): (#[0-9a-f]{6})"_s).globalMatch(theme);
            while (found.hasNext()) {
                const QRegularExpressionMatch match = found.next();
                colours[match.captured(1)] = luminance(match.captured(2));
            }
            QVERIFY(colours.size() >= 9);
            const bool isDark = &theme == &themes.back();
            for (const PolicyStyle& look : kPolicyStyles)
                if (!look.light.empty())
                    colours[QString::fromStdString(nameOf(kPolicyNames, look.policy))] = luminance(
                        QString::fromStdString(std::string(isDark ? look.dark : look.light)));
            const QStringList faint{u"page"_s, u"panel"_s, u"grid"_s, u"rule"_s};
            for (auto colour = colours.cbegin(); colour != colours.cend(); ++colour) {
                if (faint.contains(colour.key()))
                    continue;
                const auto [low, high] = std::minmax(colour.value(), colours[u"page"_s]);
                const bool isText = colour.key() == "text"_L1 || colour.key() == "muted"_L1;
                QVERIFY2((high + 0.05) / (low + 0.05) >= (isText ? 4.5 : 3.0),
                         qPrintable(colour.key()));
            }
        }
    }

    void systemInfoHasNoNames()
    {
        const std::string machine = systemInfo();
        QVERIFY(machine.find(QSysInfo::kernelType() == "linux"_L1 ? "Linux" : "") !=
                std::string::npos);
        QVERIFY(machine.find("core") != std::string::npos);
        const std::string host = QSysInfo::machineHostName().toStdString();
        QVERIFY(host.size() < 4 || machine.find(host) == std::string::npos);
    }
};

QTEST_APPLESS_MAIN(TestStudyReport)
#include "tst_study_report.moc"
