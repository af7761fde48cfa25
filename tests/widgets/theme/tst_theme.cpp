#include "tests/support/approx.h"
#include "tests/support/window/themes.h"
#include "widgets/theme/theme.h"

#include <QtTest>

#include <cmath>

using namespace berg;
using test::themes;

namespace {

constexpr double kTextContrast = 4.5; // WCAG 2.1, 1.4.3
constexpr double kLineContrast = 3.0; // WCAG 2.1, 1.4.11

/** CIE lightness L* of a colour, 0 to 100. */
double lightness(const QColor& colour)
{
    const double y = relativeLuminance(colour);
    return y > 0.008856 ? 116 * std::cbrt(y) - 16 : 903.3 * y;
}

struct Pair
{
    const char* name;
    QColor Theme::*on;
    QColor Theme::*below;
    double least;
};

const std::vector<Pair>& pairs()
{
    static const std::vector<Pair> all = {
        {"text on sea", &Theme::text, &Theme::sea, kTextContrast},
        {"text on land", &Theme::text, &Theme::land, kTextContrast},
        {"text on panel", &Theme::text, &Theme::panel, kTextContrast},
        {"text on chart", &Theme::text, &Theme::chart, kTextContrast},
        {"place name on sea", &Theme::mutedText, &Theme::sea, kTextContrast},
        {"place name on land", &Theme::mutedText, &Theme::land, kTextContrast},
        {"muted text on panel", &Theme::mutedText, &Theme::panel, kTextContrast},
        {"muted text on chart", &Theme::mutedText, &Theme::chart, kTextContrast},
        {"graticule text on sea", &Theme::graticuleText, &Theme::sea, kTextContrast},
        {"number in an order circle", &Theme::planText, &Theme::plan, kTextContrast},
        {"label of the sum of sigma", &Theme::momentary, &Theme::chart, kTextContrast},
        {"label of zeta", &Theme::accumulated, &Theme::chart, kTextContrast},
        {"UAV on sea", &Theme::uav, &Theme::sea, kLineContrast},
        {"UAV on panel", &Theme::uav, &Theme::panel, kLineContrast},
        {"marks on chart", &Theme::uav, &Theme::chart, kLineContrast},
        {"plan on sea", &Theme::plan, &Theme::sea, kLineContrast},
        {"former plan on sea", &Theme::formerPlan, &Theme::sea, kLineContrast},
        {"former plan on panel", &Theme::formerPlan, &Theme::panel, kLineContrast},
        {"track on sea", &Theme::track, &Theme::sea, kLineContrast},
        {"comparison on sea", &Theme::comparison, &Theme::sea, kLineContrast},
        {"alarm on panel", &Theme::alarm, &Theme::panel, kLineContrast},
        {"warning on panel", &Theme::warning, &Theme::panel, kLineContrast},
        {"symbol outline on sea", &Theme::ink, &Theme::sea, kLineContrast},
        {"symbol outline on panel", &Theme::ink, &Theme::panel, kLineContrast},
        {"coast against sea", &Theme::coast, &Theme::sea, kLineContrast},
        {"coast against land", &Theme::coast, &Theme::land, kLineContrast},
        {"axis on chart", &Theme::chartAxis, &Theme::chart, kLineContrast},
    };
    return all;
}

void addThemes()
{
    QTest::addColumn<int>("themeIndex");
    for (std::size_t i = 0; i < themes().size(); ++i)
        QTest::newRow(themes()[i].name) << static_cast<int>(i);
}

const Theme& themeOf(int themeIndex)
{
    return themes()[static_cast<std::size_t>(themeIndex)].theme;
}

} // namespace

class TestTheme : public QObject
{
    Q_OBJECT

private slots:
    /** Lines of the graticule are seen on sea and land alike, and do not stand out. */
    void graticuleIsSeen()
    {
        for (const auto& [name, theme] : themes())
            for (const QColor& ground : {theme.sea, theme.land}) {
                QColor line = theme.graticule;
                line.setAlpha(255);
                line = mixed(ground, line, theme.graticule.alphaF());
                const double contrast = contrastRatio(line, ground);
                QVERIFY2(contrast >= kLineContrast && contrast < 4.5, QByteArray::number(contrast));
            }
    }

    void contrastOfKnownColours()
    {
        // Definition of WCAG 2.1: 21 for black on white, 1 for equal colours.
        COMPARE_NEAR(contrastRatio(Qt::black, Qt::white), 21.0, 1e-9);
        COMPARE_NEAR(contrastRatio(Qt::white, Qt::black), 21.0, 1e-9);
        COMPARE_NEAR(contrastRatio(Qt::red, Qt::red), 1.0, 1e-12);
        // #767676 is the well-known lightest grey that passes 4.5 on white.
        COMPARE_NEAR(contrastRatio(QColor(0x767676), Qt::white), 4.54, 0.005);
    }

    void contrastIsEnough_data()
    {
        QTest::addColumn<int>("themeIndex");
        QTest::addColumn<int>("pair");
        for (std::size_t themeIndex = 0; themeIndex < themes().size(); ++themeIndex)
            for (std::size_t i = 0; i < pairs().size(); ++i)
                QTest::addRow("%s: %s", themes()[themeIndex].name, pairs()[i].name)
                    << static_cast<int>(themeIndex) << static_cast<int>(i);
    }

    void contrastIsEnough()
    {
        QFETCH(int, themeIndex);
        QFETCH(int, pair);
        const Theme& theme = themeOf(themeIndex);
        const Pair& p = pairs()[static_cast<std::size_t>(pair)];
        const double ratio = contrastRatio(theme.*p.on, theme.*p.below);
        QVERIFY2(ratio >= p.least, QByteArray::number(ratio).constData());
    }

    void highContrastHasMore_data()
    {
        QTest::addColumn<bool>("isDark");
        QTest::addColumn<int>("pair");
        for (const bool isDark : {false, true})
            for (std::size_t i = 0; i < pairs().size(); ++i)
                QTest::addRow("%s: %s", isDark ? "dark" : "light", pairs()[i].name)
                    << isDark << static_cast<int>(i);
    }

    /** WCAG 2.1, 1.4.6 asks for 7 : 1 for text; what carries meaning without it has 4.5 : 1. */
    void highContrastHasMore()
    {
        QFETCH(bool, isDark);
        QFETCH(int, pair);
        const Theme theme = Theme::highContrast(isDark);
        QCOMPARE(theme.isDark, isDark);
        const Pair& p = pairs()[static_cast<std::size_t>(pair)];
        const double ratio = contrastRatio(theme.*p.on, theme.*p.below);
        QVERIFY2(ratio >= (p.least == kTextContrast ? 7 : 4.5),
                 QByteArray::number(ratio).constData());
    }

    void waterSeenHidesNothing_data() { addThemes(); }

    /** The tint is distinguishable from the sea, and lines on it are as readable as on the sea. */
    void waterSeenHidesNothing()
    {
        QFETCH(int, themeIndex);
        const Theme& theme = themeOf(themeIndex);
        QColor tint = theme.swept;
        tint.setAlpha(255);
        const QColor seen = mixed(theme.sea, tint, double{theme.swept.alphaF()});
        QVERIFY(std::abs(lightness(seen) - lightness(theme.sea)) > 3);
        for (const Pair& p : pairs())
            if (p.below == &Theme::sea)
                QVERIFY2(contrastRatio(theme.*p.on, seen) >= p.least, p.name);
    }

    void sigmaIsVisibleEverywhere_data() { addThemes(); }

    void sigmaIsVisibleEverywhere()
    {
        QFETCH(int, themeIndex);
        const Theme& theme = themeOf(themeIndex);
        for (int i = 0; i <= 100; ++i)
            for (const QColor& below : {theme.sea, theme.panel, theme.chart})
                QVERIFY2(contrastRatio(theme.sigma.at(i / 100.0), below) >= kLineContrast,
                         QByteArray::number(i).constData());
    }

    void sigmaIsMonotoneAndEven_data() { addThemes(); }

    /**
     * Lightness is monotonic, away from the background, in nearly equal steps: viridis is even to
     * a few tenths of a unit of L*, and the table adds rounding to 8 bits.
     */
    void sigmaIsMonotoneAndEven()
    {
        QFETCH(int, themeIndex);
        const Theme& theme = themeOf(themeIndex);
        const double sign = theme.isDark ? 1 : -1;
        constexpr int kSteps = 20;
        const double mean = (lightness(theme.sigma.at(1)) - lightness(theme.sigma.at(0))) / kSteps;
        QVERIFY(sign * mean > 1); // a difference one can see from step to step
        for (int i = 0; i < kSteps; ++i) {
            const double step = lightness(theme.sigma.at((i + 1.0) / kSteps)) -
                                lightness(theme.sigma.at(static_cast<double>(i) / kSteps));
            QVERIFY(sign * step > 0);
            COMPARE_NEAR(step, mean, 0.6);
        }
        QVERIFY(contrastRatio(theme.sigma.at(1), theme.sea) >
                contrastRatio(theme.sigma.at(0), theme.sea));
    }

    void sigmaIsClamped()
    {
        const SigmaScale scale(SigmaScale::Ground::Light);
        QCOMPARE(scale.colour(-1, 10), scale.at(0));
        QCOMPARE(scale.colour(25, 10), scale.at(1));
        QCOMPARE(scale.colour(5, 10), scale.at(0.5));
        QCOMPARE(scale.colour(5, 0), scale.at(0));
    }

    /** Whatever colour is asked for, by night it is a red of about its lightness. */
    void nightIsRed()
    {
        const Theme night = Theme::night();
        for (const QColor& colour : {QColor(Qt::white), QColor(0x56b4e9), QColor(0x009e73),
                                     QColor(0x444444), QColor(0x0072b2), QColor(Qt::black)}) {
            const QColor red = night.toned(colour);
            QVERIFY(red.red() >= red.green() && red.red() >= red.blue());
            QVERIFY(red.blue() < 128);
            QVERIFY(std::abs(lightness(red) - std::clamp(lightness(colour), 0.0, 77.0)) < 8);
            QCOMPARE(Theme::dark().toned(colour), colour);
        }
        QCOMPARE(night.toned(QColor(1, 2, 3, 77)).alpha(), 77);
    }

    void mixingEndsAtItsColours()
    {
        const QColor from(10, 20, 30);
        const QColor to(200, 100, 0);
        QCOMPARE(mixed(from, to, 0).rgba(), from.rgba());
        QCOMPARE(mixed(from, to, 1).rgba(), to.rgba());
        QCOMPARE(mixed(from, to, 0.5).rgb(), QColor(105, 60, 15).rgb());
    }

    void fontsAreInPixels()
    {
        const Theme theme = Theme::light();
        QCOMPARE(theme.body().pixelSize(), 13);
        QCOMPARE(theme.small().pixelSize(), 11);
        QVERIFY(theme.strong().bold());
        QVERIFY(theme.figure().pixelSize() > theme.body().pixelSize());
    }
};

QTEST_MAIN(TestTheme)
#include "tst_theme.moc"
