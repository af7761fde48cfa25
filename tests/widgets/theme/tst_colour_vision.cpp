#include "core/io/figure/policy_style.h"
#include "tests/support/approx.h"
#include "tests/support/window/colour_vision.h"
#include "widgets/map/paint/map_surroundings.h"
#include "widgets/theme/palette.h"
#include "widgets/words/policy_words.h"

#include <QtTest>

using namespace berg;
using namespace berg::test;
using namespace Qt::StringLiterals;

namespace {

/** Several times what is just noticed of large areas: lines and marks are thin, and apart. */
constexpr double kApart = 8;

struct NamedTheme
{
    const char* name;
    Theme theme;
};

const std::vector<NamedTheme>& themes()
{
    static const std::vector<NamedTheme> all = {
        {"light", Theme::light()},
        {"dark", Theme::dark()},
        {"high contrast, light", Theme::highContrast(false)},
        {"high contrast, dark", Theme::highContrast(true)},
        {"night", Theme::night()}};
    return all;
}

void addRows()
{
    QTest::addColumn<int>("theme");
    QTest::addColumn<Vision>("vision");
    constexpr std::array kNames = {"normal", "protanopia", "deuteranopia", "tritanopia"};
    for (std::size_t i = 0; i < themes().size(); ++i)
        for (const Vision vision : kVisions)
            QTest::addRow("%s, %s", themes()[i].name, kNames[static_cast<std::size_t>(vision)])
                << static_cast<int>(i) << vision;
}

/** Colours with different meanings that appear side by side. */
struct Pair
{
    const char* name;
    QColor Theme::*one;
    QColor Theme::*other;
};

constexpr Pair kPairs[] = {
    {"plan and what it took the place of", &Theme::plan, &Theme::formerPlan},
    {"former plan and track", &Theme::formerPlan, &Theme::track},
    {"plan and track", &Theme::plan, &Theme::track},
    {"plan and UAV", &Theme::plan, &Theme::uav},
    {"plan and the run compared", &Theme::plan, &Theme::comparison},
    {"track and that of the run compared", &Theme::track, &Theme::comparison},
    {"zeta and that of the run compared", &Theme::accumulated, &Theme::comparison},
    {"UAV and the run compared", &Theme::uav, &Theme::comparison},
    {"zeta and sum of sigma", &Theme::accumulated, &Theme::momentary},
    {"alarm and warning", &Theme::alarm, &Theme::warning},
    {"alarm and note", &Theme::alarm, &Theme::panelLine},
    {"warning and note", &Theme::warning, &Theme::panelLine},
};

} // namespace

Q_DECLARE_METATYPE(berg::test::Vision)

/** No meaning depends on colours that colour-blind people cannot distinguish. */
class TestColourVision : public QObject
{
    Q_OBJECT

private slots:
    /** Pairs 1, 7 and 25 of the test data of Sharma, Wu and Dalal; and what a matrix does to grey.
     */
    void simulationIsTheOnePublished()
    {
        COMPARE_NEAR(colourDifference(Lab{50, 2.6772, -79.7751}, Lab{50, 0, -82.7485}), 2.0425,
                     1e-4);
        COMPARE_NEAR(colourDifference(Lab{50, 0, 0}, Lab{50, -1, 2}), 2.3669, 1e-4);
        COMPARE_NEAR(
            colourDifference(Lab{60.2574, -34.0099, 36.2677}, Lab{60.4626, -34.1751, 39.4387}),
            1.2644, 1e-4);
        for (const Vision vision : kVisions) // grey is grey to everybody
            QVERIFY(colourDifference(labOf(seen(QColor(128, 128, 128), vision)),
                                     labOf(seen(QColor(128, 128, 128), Vision::Normal))) < 0.1);
        // Red and green of one lightness are the classic.
        QVERIFY(colourDifference(QColor(0xc0392b), QColor(0x1e8449), Vision::Normal) > 50);
        QVERIFY(colourDifference(QColor(0xc0392b), QColor(0x1e8449), Vision::Deuteranopia) < 20);
    }

    void meaningsAreDistinguishable_data() { addRows(); }

    void meaningsAreDistinguishable()
    {
        QFETCH(int, theme);
        QFETCH(Vision, vision);
        const Theme& shown = themes()[static_cast<std::size_t>(theme)].theme;
        for (const Pair& pair : kPairs) {
            const double apart = colourDifference(shown.*pair.one, shown.*pair.other, vision);
            QVERIFY2(apart >= kApart,
                     qPrintable(u"%1: %2"_s.arg(QLatin1String(pair.name)).arg(apart)));
        }
    }

    void airspaceDiffersFromTheComparedRun_data() { addRows(); }

    void airspaceDiffersFromTheComparedRun()
    {
        QFETCH(int, theme);
        QFETCH(Vision, vision);
        const Theme& shown = themes()[static_cast<std::size_t>(theme)].theme;
        QVERIFY(colourDifference(airspacePen(shown).color(), shown.comparison, vision) >= kApart);
    }

    void uavColoursAreDistinguishable_data() { addRows(); }

    void uavColoursAreDistinguishable()
    {
        QFETCH(int, theme);
        QFETCH(Vision, vision);
        const Theme& shown = themes()[static_cast<std::size_t>(theme)].theme;
        for (int i = 0; i < kUavColours; ++i)
            for (int k = 0; k < i; ++k) {
                const double apart =
                    colourDifference(uavColour(shown, i), uavColour(shown, k), vision);
                QVERIFY2(apart >= kApart,
                         qPrintable(u"UAVs %1 and %2: %3"_s.arg(k).arg(i).arg(apart)));
            }
    }

    void sigmaScaleIsMonotonic_data() { addRows(); }

    /** From step to step it gets lighter, or darker, and its ends are far apart. */
    void sigmaScaleIsMonotonic()
    {
        QFETCH(int, theme);
        QFETCH(Vision, vision);
        const Theme& shown = themes()[static_cast<std::size_t>(theme)].theme;
        const auto at = [&](int step) { return labOf(seen(shown.sigma.at(step / 10.0), vision)); };
        const double sign = shown.isDark ? 1 : -1;
        for (int step = 0; step < 10; ++step)
            QVERIFY2(sign * (at(step + 1).L - at(step).L) > 1, QByteArray::number(step));
        QVERIFY(colourDifference(at(0), at(10)) > 5 * kApart / 2);
    }

    void similarPoliciesHaveOtherMarks_data() { addRows(); }

    /** Nobody can distinguish all seven colours, so marks differ in shape. */
    void similarPoliciesHaveOtherMarks()
    {
        QFETCH(int, theme);
        QFETCH(Vision, vision);
        const Theme& shown = themes()[static_cast<std::size_t>(theme)].theme;
        for (const PolicyKind one : kOfferedPolicies)
            for (const PolicyKind other : kOfferedPolicies) {
                if (one == other)
                    continue;
                const bool isSimilar =
                    colourDifference(policyColour(one, shown), policyColour(other, shown), vision) <
                    kApart;
                QVERIFY(!isSimilar || policyMark(one, 1).shape != policyMark(other, 1).shape);
            }
    }
};

QTEST_MAIN(TestColourVision)
#include "tst_colour_vision.moc"
